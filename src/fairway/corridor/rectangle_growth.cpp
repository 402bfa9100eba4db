// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fairway {

namespace {

using Eigen::Vector2d;

// The sides in the order in which Algorithm 1 advances them.
enum class Side : std::uint8_t { Top, Left, Bottom, Right };
constexpr std::array<Side, 4> kSides = {Side::Top, Side::Left, Side::Bottom, Side::Right};

// Where a side is, counted from the seed outwards, as a reference into the box.
struct SideOf {
  int axis;
  bool upper;
};

constexpr SideOf side_of(Side side) noexcept {
  switch (side) {
    case Side::Top:
      return {.axis = 1, .upper = true};
    case Side::Left:
      return {.axis = 0, .upper = false};
    case Side::Bottom:
      return {.axis = 1, .upper = false};
    case Side::Right:
      return {.axis = 0, .upper = true};
  }
  return {.axis = 0, .upper = true};
}

// One run of Algorithm 1's inner loop, in one orientation. Lengths in cells.
class Growth {
 public:
  Growth(const BitGrid& obstacles, const TurnedFrame& frame, double radius) noexcept
      : obstacles_(obstacles),
        frame_(frame),
        radius_(radius) {}

  // @return false when the start rectangle is not free.
  [[nodiscard]] bool run(double start, double step, double limit) noexcept {
    box_ = {.min = Vector2d::Constant(-start), .max = Vector2d::Constant(start)};
    if (!is_free(obstacles_, frame_.region(box_), radius_)) return false;
    std::array<double, 4> steps;
    steps.fill(step);
    bool growing = true;
    while (growing) {
      growing = false;
      for (std::size_t j = 0; j < kSides.size(); ++j) {
        if (steps[j] <= 0.0) continue;
        growing = true;
        if (!advance(kSides[j], steps[j], limit)) steps[j] = steps[j] > 1.0 ? 1.0 : 0.0;
      }
    }
    return true;
  }

  [[nodiscard]] const Box& box() const noexcept { return box_; }

 private:
  bool advance(Side side, double step, double limit) noexcept {
    const SideOf at = side_of(side);
    double& place = (at.upper ? box_.max : box_.min)[at.axis];
    const double next = place + (at.upper ? step : -step);
    if (std::abs(next) > limit) return false;
    Box strip = box_;
    (at.upper ? strip.min : strip.max)[at.axis] = place;
    (at.upper ? strip.max : strip.min)[at.axis] = next;
    if (!is_free(obstacles_, frame_.region(strip), radius_)) return false;
    place = next;
    return true;
  }

  const BitGrid& obstacles_;
  TurnedFrame frame_;
  double radius_;
  Box box_;
};

}  // namespace

std::optional<OrientedRectangle> grow_rectangle(const BitGrid& obstacles,
                                                double clearance,
                                                const Vector2d& seed,
                                                const GrowthSettings& settings) noexcept {
  if (!is_finite(seed)) return std::nullopt;
  const GridFrame& grid = obstacles.frame();
  const double radius = search_radius(grid, clearance);
  std::optional<OrientedRectangle> best;
  double best_area = 0.0;
  for (int k = 0; k < settings.num_orientations; ++k) {
    const double orientation = std::numbers::pi / 2.0 * k / settings.num_orientations;  // Eq. (4)
    const TurnedFrame frame{.origin = grid.to_grid(seed),
                            .along = direction(orientation - grid.origin.heading)};
    Growth growth(obstacles, frame, radius);
    if (!growth.run(settings.start_size / grid.resolution, settings.growth_step / grid.resolution,
                    settings.max_growth / grid.resolution)) {
      continue;
    }
    if (best && growth.box().area() <= best_area) continue;
    const OrientedRectangle rectangle{.seed = seed,
                                      .orientation = orientation,
                                      .min = growth.box().min * grid.resolution,
                                      .max = growth.box().max * grid.resolution};
    if (!is_free(obstacles, rectangle, clearance)) continue;
    best_area = growth.box().area();
    best = rectangle;
  }
  return best;
}

}  // namespace fairway
