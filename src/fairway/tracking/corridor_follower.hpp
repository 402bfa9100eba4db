// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fairway/corridor/corridor.hpp"
#include "fairway/tracking/tracking_settings.hpp"

namespace fairway {

/// A polyline with its arc lengths: the taut string from the robot to the goal, or as far as is
/// looked.
struct ReferencePath {
  static constexpr int kMaxPoints = 20;
  std::array<Eigen::Vector2d, kMaxPoints> points;
  std::array<double, kMaxPoints> arc;  ///< length from the first point [m]
  int count = 0;                       ///< at least 2
  bool ends_at_goal = false;           ///< whether the last point is the goal

  [[nodiscard]] double length() const noexcept { return arc[static_cast<std::size_t>(count - 1)]; }

  /// The point at arc length `s`, clamped to the ends.
  [[nodiscard]] Eigen::Vector2d at(double s) const noexcept;
};

/// A corridor that is being followed: which rectangle the robot is in, and the shortest string from
/// it through the overlaps ahead.
///
/// Every piece of the string lies in one rectangle, since both of its ends do and rectangles are
/// convex.
class CorridorFollower {
 public:
  CorridorFollower() = default;  ///< no corridor

  /// Takes over a built corridor. Allocates; the other functions do not.
  CorridorFollower(Corridor corridor,
                   const Eigen::Vector2d& goal,
                   const TrackingSettings& settings);

  [[nodiscard]] bool empty() const noexcept { return admissible_.empty(); }

  /// Finds the rectangle that the robot is in and pulls the string taut from there.
  ///
  /// Prefers the furthest of the current and the next three that hold the position; else any other
  /// one that does; else the rectangle nearest to the position if that is within `slack` [m].
  /// @return whether there is such a rectangle; if not, nothing changes.
  [[nodiscard]] bool update(const Eigen::Vector2d& position, double slack) noexcept;

  [[nodiscard]] std::size_t current() const noexcept { return current_; }
  [[nodiscard]] std::size_t size() const noexcept { return admissible_.size(); }

  /// Where the robot's centre may be in rectangle `i`.
  [[nodiscard]] const OrientedRectangle& admissible(std::size_t i) const noexcept {
    return admissible_[i];
  }

  /// The overlap of the admissible rectangles i and i + 1.
  [[nodiscard]] const OverlapPatch& patch(std::size_t i) const noexcept { return patches_[i]; }

  [[nodiscard]] const Corridor& corridor() const noexcept { return corridor_; }
  /// Length of the string from the robot to the goal [m].
  [[nodiscard]] double remaining() const noexcept;

  [[nodiscard]] const ReferencePath& reference_path() const noexcept { return path_; }

 private:
  [[nodiscard]] std::optional<std::size_t> locate(const Eigen::Vector2d& position,
                                                  double slack) const noexcept;
  void pull(const Eigen::Vector2d& position) noexcept;

  Corridor corridor_;
  std::vector<OrientedRectangle> admissible_;
  std::vector<OverlapPatch> patches_;       // exact overlaps
  std::vector<OverlapPatch> path_patches_;  // the part of them the string may touch
  std::vector<Eigen::Vector2d> touches_;    // one per patch
  Eigen::Vector2d goal_ = Eigen::Vector2d::Zero();
  std::size_t current_ = 0;
  ReferencePath path_;
};

}  // namespace fairway
