// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "fairway/geometry/pose2.hpp"
#include "fairway/localization/scan_matching.hpp"

namespace fairway {

/// How certain a corrected pose is.
struct PoseCertainty {
  /// Covariance of (x, y) [m^2], the heading [rad^2] and both, in the frame of the map.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Whether the scan says nothing about the position in one direction, as in a long corridor. The
  /// position in that direction then comes from odometry alone.
  bool degenerate = false;
  Eigen::Vector2d weak_direction = Eigen::Vector2d::Zero();  ///< that direction
  bool matched = false;  ///< whether the last scan was used; if not, odometry alone was
  double share = 0.0;    ///< part of the scan that lies on known surfaces []
};

/// Corrects poses from odometry with scans, by an extended Kalman filter. Its measurement is the
/// match of a scan with the surfaces seen before, or with those of a known map.
///
/// The state is the transformation from the frame of the odometry to that of the map. Odometry
/// errors grow with the distance driven and the angle turned. Deterministic; allocates in the
/// constructor and in use_map only, unless a scan has more beams than it was made for.
class PoseCorrection {
 public:
  /// @param window     Side of the square around the robot in which surfaces are remembered [m].
  /// @param max_beams  Greatest number of beams of a scan.
  PoseCorrection(double window, std::size_t max_beams);

  /// Uses the surfaces of a known map. Surfaces of scans are then not added.
  void use_map(const BitGrid& map);

  /// Sets the robot's pose in the map, for a pose by odometry.
  /// @param covariance  Of this pose.
  void set_pose(const Pose2& odometry,
                const Pose2& pose,
                const Eigen::Matrix3d& covariance) noexcept;

  /// Returns the corrected pose for a pose by odometry.
  [[nodiscard]] Pose2 corrected(const Pose2& odometry) const noexcept;

  /// Replaces the turn by odometry since the last match by one that a gyroscope measured [rad].
  /// @param odometry  Pose of the sensor at the end of the scan that is matched next.
  void use_turn(const Pose2& odometry, double turn) noexcept;

  /// Matches a scan and updates the correction.
  /// @param ends      Ends of the beams by the correction so far; beams without a hit are NaN.
  /// @param odometry  Pose of the sensor at the end of the scan, by odometry.
  /// @return the motion by which the scan was moved, about the corrected sensor.
  ScanMotion match(std::span<const Eigen::Vector2d> ends, const Pose2& odometry);

  /// Remembers surfaces of the last scan. It takes the points of those beams for which
  /// `is_static(beam, end)` holds, where `end` is the corrected end of the beam.
  template <typename IsStatic>
  void remember(IsStatic&& is_static) {
    if (known_map_ || !remembers_) return;
    for (std::size_t i = 0; i < scan_.size(); ++i) {
      if (is_static(beams_[i], scan_[i].position)) surfaces_.add(scan_[i]);
    }
  }

  [[nodiscard]] const PoseCertainty& certainty() const noexcept { return certainty_; }
  [[nodiscard]] const SurfacePoints& surfaces() const noexcept { return surfaces_; }

 private:
  void predict(const Pose2& odometry) noexcept;
  [[nodiscard]] std::optional<double> search_along(const Eigen::Vector2d& weak,
                                                   const ScanMatch& match,
                                                   const Eigen::Vector2d& center) noexcept;
  void correct(const ScanMatch& match, const Eigen::Vector2d& center) noexcept;

  SurfacePoints surfaces_;
  bool known_map_ = false;
  bool remembers_ = true;  // the points of the last scan
  bool started_ = false;
  double driven_ = 0.0;           // since the match before [m]
  double weak_driven_ = 0.0;      // while one direction was weak [m]
  std::optional<double> turned_;  // since the last match, by a gyroscope [rad]
  Pose2 correction_;              // from the frame of the odometry to that of the map
  Pose2 last_odometry_;           // of the sensor
  PoseCertainty certainty_;
  std::vector<SurfacePoint> scan_;
  std::vector<std::size_t> beams_;  // of the points of the scan
};

}  // namespace fairway
