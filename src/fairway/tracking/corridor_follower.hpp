// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fairway/corridor/corridor.hpp"
#include "fairway/tracking/tracking_settings.hpp"

namespace fairway {

/// A polyline with its arc lengths. It is the shortest path in the corridor from the robot to the
/// goal, or over the part of it considered.
struct ReferencePath {
  static constexpr int kMaxPoints = 20;
  std::array<Eigen::Vector2d, kMaxPoints> points;
  std::array<double, kMaxPoints> arc;  ///< arc length from the first point [m]
  int count = 0;                       ///< at least 2
  bool ends_at_goal = false;           ///< whether the last point is the goal

  [[nodiscard]] double length() const noexcept { return arc[static_cast<std::size_t>(count - 1)]; }

  /// Returns the point at arc length `s` [m], clamped to the ends.
  [[nodiscard]] Eigen::Vector2d at(double s) const noexcept;
};

/// Follows a corridor: finds the rectangle that contains the robot, and the reference path from
/// there. The reference path is the shortest path through the overlaps ahead.
///
/// Every piece of the reference path lies in one rectangle: both of its ends do, and rectangles are
/// convex.
class CorridorFollower {
 public:
  CorridorFollower() = default;  ///< without a corridor

  /// Starts to follow a built corridor. Allocates; the other functions do not.
  CorridorFollower(Corridor corridor,
                   const Eigen::Vector2d& goal,
                   const TrackingSettings& settings);

  [[nodiscard]] bool empty() const noexcept { return admissible_.empty(); }

  /// Finds the rectangle that contains the robot and computes the reference path from there.
  ///
  /// The furthest of the current rectangle and the next three that contains the position is chosen.
  /// If there is none, any other one that contains it is, and then the nearest one within `slack`
  /// [m].
  /// @return whether there is such a rectangle; if not, nothing changes.
  [[nodiscard]] bool update(const Eigen::Vector2d& position, double slack) noexcept;

  /// Index of the rectangle that contains the robot.
  [[nodiscard]] std::size_t current() const noexcept { return current_; }
  [[nodiscard]] std::size_t size() const noexcept { return admissible_.size(); }

  /// Returns the region for the robot's centre in rectangle `i`.
  [[nodiscard]] const OrientedRectangle& admissible(std::size_t i) const noexcept {
    return admissible_[i];
  }

  /// Returns the overlap of the admissible rectangles i and i + 1.
  [[nodiscard]] const OverlapPatch& patch(std::size_t i) const noexcept { return patches_[i]; }

  [[nodiscard]] const Corridor& corridor() const noexcept { return corridor_; }
  /// Length of the path from the robot to the goal [m].
  [[nodiscard]] double remaining() const noexcept;

  [[nodiscard]] const ReferencePath& reference_path() const noexcept { return path_; }

 private:
  [[nodiscard]] std::optional<std::size_t> locate(const Eigen::Vector2d& position,
                                                  double slack) const noexcept;
  void update_path(const Eigen::Vector2d& position) noexcept;

  Corridor corridor_;
  std::vector<OrientedRectangle> admissible_;
  std::vector<OverlapPatch> patches_;       // exact overlaps
  std::vector<OverlapPatch> path_patches_;  // the parts that the reference path may touch
  std::vector<Eigen::Vector2d> touches_;    // touch points, one per patch
  Eigen::Vector2d goal_ = Eigen::Vector2d::Zero();
  std::size_t current_ = 0;
  ReferencePath path_;
};

}  // namespace fairway
