// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "fairway/localization/pose_correction.hpp"
#include "fairway/perception/lidar_scan.hpp"

namespace fairway {

/// Lays the beams of scans where they match the surfaces seen before, or those of a known map.
class ScanAlignment {
 public:
  /// As PoseCorrection.
  ScanAlignment(double window, std::size_t max_beams);

  /// Transforms the beams of a scan with poses by odometry, and corrects the pose with them.
  /// @param beams  Filled with one beam per range, in the corrected frame; keeps its memory.
  void lay(const LidarScan& scan, double reach, std::vector<Beam>& beams) noexcept;

  PoseCorrection correction;

 private:
  std::size_t max_beams_;
  double time_ = -std::numeric_limits<double>::infinity();  // of the last scan [s]
  std::vector<Eigen::Vector2d> ends_;
};

}  // namespace fairway
