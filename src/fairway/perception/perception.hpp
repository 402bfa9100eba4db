// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fairway/perception/moving_object_tracker.hpp"
#include "fairway/perception/rolling_grid.hpp"
#include "fairway/perception/scan_alignment.hpp"

namespace fairway {

/// Turns lidar scans into the input of a navigator: a map of static obstacles, and moving
/// obstacles.
///
/// Allocates in the constructor only. Of a scan with more than `max_beams` beams the first are
/// used. Deterministic.
class Perception {
 public:
  Perception(const PerceptionSettings& settings, const Eigen::Vector2d& position);

  /// Processes one scan.
  /// @param position  Position of the robot at the scan's time, in the frame of the scan's poses.
  /// @param body_radius  Radius of the disc that covers the robot [m].
  void observe(const LidarScan& scan, const Eigen::Vector2d& position, double body_radius) noexcept;

  /// Sets the zones that both readings of the map carry; null for none.
  void set_zones(std::shared_ptr<const ZoneMap> zones) noexcept {
    grid_.set_zones(std::move(zones));
  }

  /// Makes the unknown cells under a part of the robot free, as RollingGrid::claim.
  void claim(const Eigen::Vector2d& center, double radius) noexcept { grid_.claim(center, radius); }

  /// Doubts occupied cells that none of the last scans has touched, as RollingGrid::doubt_unseen.
  CellWindow doubt_unseen(int scans) noexcept { return grid_.doubt_unseen(scans); }

  [[nodiscard]] const RollingGrid& grid() const noexcept { return grid_; }
  [[nodiscard]] const MovingObjectTracker& tracker() const noexcept { return tracker_; }
  /// Beams of the last scan.
  [[nodiscard]] std::span<const Beam> beams() const noexcept { return beams_; }
  [[nodiscard]] double time() const noexcept { return time_; }  ///< of the last scan [s]

  /// Returns the pose in the frame of the grid for a pose in the frame of the scans' poses. Both
  /// are the same unless `match_scans` is set.
  [[nodiscard]] Pose2 corrected(const Pose2& odometry) const noexcept {
    return alignment_ ? alignment_->correction.corrected(odometry) : odometry;
  }

  /// Takes over the correction of an older perception, whose map is not taken over.
  void keep_correction(const Perception& older) noexcept {
    if (alignment_ && older.alignment_)
      alignment_->correction.set_pose({}, older.corrected({}), older.certainty()->covariance);
  }

  /// The certainty of corrected poses; null unless `match_scans` is set.
  [[nodiscard]] const PoseCertainty* certainty() const noexcept {
    return alignment_ ? &alignment_->correction.certainty() : nullptr;
  }

 private:
  PerceptionSettings settings_;
  std::size_t max_beams_;
  RollingGrid grid_;
  MovingObjectTracker tracker_;
  std::vector<Beam> beams_;
  std::optional<ScanAlignment> alignment_;
  double time_;
};

}  // namespace fairway
