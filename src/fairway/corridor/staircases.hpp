// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "fairway/corridor/box.hpp"
#include "fairway/corridor/obstacle_points.hpp"

namespace fairway {

/// The obstacle points that matter for boxes around a core, in one orientation.
///
/// In each of the four quadrants around the core these are the nearest points: none has another one
/// nearer in both coordinates. Sorted they are a staircase, and what lies straight beside the core
/// caps how far a box can reach. A point that comes in later changes a few steps at most, so the
/// bound on the area is cheap to keep up to date.
class Staircases {
 public:
  /// The points, seen in the frame turned so that its x-axis points along `along` (a unit vector),
  /// for boxes that hold `core` and have no side longer than `longest_side`.
  /// @pre the core holds the points' origin, and its sides are at most `longest_side`.
  void assign(const ObstaclePoints& points,
              const Eigen::Vector2d& along,
              const Box& core,
              double longest_side) noexcept;

  /// One more point, in the turned frame.
  void add(float x, float y) noexcept;

  /// The largest box that holds the core and has no point in its interior; none when a point lies
  /// inside the core, or no such box is larger than `least_area`.
  ///
  /// Where a side would be longer than allowed, the box lies as centrally about the core as it may.
  /// Exact up to float rounding: the staircases give all heights that a top or bottom side can stop
  /// at, and every pair that can be the best is tried. (A quadrant keeps its kMostSteps steps
  /// nearest to its first axis; what is beyond them only makes the box too large.)
  [[nodiscard]] std::optional<Box> largest_box(double least_area) const noexcept;

 private:
  static constexpr std::size_t kMostSteps = 64;

  // In its quadrant's own axes, `ahead` and `aside`, both positive there.
  struct Step {
    float ahead;
    float aside;
  };
  // Along it `ahead` falls and `aside` rises.
  struct Staircase {
    std::array<Step, kMostSteps> steps;
    std::size_t count = 0;
  };
  struct Level;
  struct Levels;

  void extract(std::size_t quadrant, const float* ahead, const float* aside, std::size_t count);
  void collect_levels(std::size_t quadrant, Levels& out) const noexcept;

  // Counter-clockwise from the upper right one; their axes ahead are +x, +y, -x, -y.
  std::array<Staircase, 4> quadrants_;
  // How far the core reaches, and boxes at most, in the directions +x, +y, -x, -y.
  std::array<float, 4> core_reach_{};
  std::array<float, 4> cap_{};
  Box core_;
  double longest_side_ = 0.0;
  bool core_hit_ = false;
};

}  // namespace fairway
