// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/rectangle_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "fairway/corridor/rectangle/box_repair.hpp"
#include "fairway/corridor/rectangle/greedy_box.hpp"
#include "fairway/corridor/rectangle/zone_points.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// The sides in the order in which Algorithm 1 advances them.
enum class Side : std::uint8_t { Top, Left, Bottom, Right };
constexpr std::array<Side, 4> kSides = {Side::Top, Side::Left, Side::Bottom, Side::Right};

// A side's distance from the seed, measured outwards, as a reference into the box.
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

// One run of the inner loop of Algorithm 1 as it is written, in one orientation. Lengths are in
// cells.
class StepwiseGrowth {
 public:
  StepwiseGrowth(const BitGrid& obstacles, const TurnedFrame& frame, double radius) noexcept
      : obstacles_(obstacles),
        frame_(frame),
        radius_(radius) {}

  // @return false if the initial rectangle is not free.
  [[nodiscard]] bool run(const GreedySteps& lengths) noexcept {
    box_ = {.min = Vector2d::Constant(-lengths.start), .max = Vector2d::Constant(lengths.start)};
    if (!is_free(obstacles_, frame_.region(box_), radius_)) return false;
    std::array<double, 4> steps;
    steps.fill(lengths.step);
    bool growing = true;
    while (growing) {
      growing = false;
      for (std::size_t j = 0; j < kSides.size(); ++j) {
        if (steps[j] <= 0.0) continue;
        growing = true;
        if (!advance(kSides[j], steps[j], lengths.limit)) steps[j] = steps[j] > 1.0 ? 1.0 : 0.0;
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

// The same growth, faster: grows on the known obstacles and tests the result on the map. Obstacles
// that it meets there are learnt, also for the next orientations, and the growth is repeated.
class Growth {
 public:
  Growth(const BitGrid& obstacles,
         const Vector2d& origin,
         double radius,
         const GreedySteps& steps) noexcept
      : obstacles_(obstacles),
        origin_(origin),
        radius_(radius),
        steps_(steps) {
    const double reach = std::numbers::sqrt2 * steps.limit;
    // Obstacles that a coarse look misses are learnt from the tests.
    constexpr std::size_t kRaySpacing = 2;
    points_.look_around(obstacles, origin, radius, reach, kRaySpacing);
    look_at_zones(obstacles, origin, radius, reach, points_);
  }

  // Returns the free box grown with its x-axis along `along`; none if the start is not free.
  [[nodiscard]] std::optional<Box> run(const Vector2d& along) noexcept {
    constexpr int kMostTests = 12;  // mazes need more; they are grown step by step
    const TurnedFrame frame{.origin = origin_, .along = along};
    for (int tests = 0; tests < kMostTests; ++tests) {
      const std::optional<Box> box = greedy_box(points_, along, steps_);
      if (!box) break;
      std::array<CellIndex, 4> found;  // NOLINT(*-member-init): filled as far as it is read
      const BlockedCells blocked =
          find_blocked_cells(obstacles_, frame.region(*box), radius_, origin_, found);
      if (blocked.count == 0 && !blocked.outside_map && !blocked.in_zone) return box;
      if (blocked.in_zone) learn_zones(obstacles_, frame, *box, radius_, points_);
      learn(frame, *box, std::span(found).first(blocked.count), blocked.outside_map);
    }
    StepwiseGrowth growth(obstacles_, frame, radius_);
    if (!growth.run(steps_)) return std::nullopt;
    return growth.box();
  }

 private:
  void learn(const TurnedFrame& frame,
             const Box& box,
             std::span<const CellIndex> cells,
             bool outside_map) noexcept {
    const Vector2d core = Vector2d::Constant(steps_.start);
    const BoxRepair repair{.grid = obstacles_.frame(),
                           .frame = frame,
                           .core = {.min = -core, .max = core},
                           .radius = radius_};
    for (const CellIndex& cell : cells)
      for (const Eigen::Vector2d& point : repair.points_inside(cell, box))
        points_.add(point);
    if (outside_map) repair.add_outside_points(box, points_);
  }

  const BitGrid& obstacles_;
  Vector2d origin_;
  double radius_;
  GreedySteps steps_;
  ObstaclePoints points_;
};

}  // namespace

std::optional<OrientedRectangle> grow_rectangle(const BitGrid& obstacles,
                                                double clearance,
                                                const Vector2d& seed,
                                                const GrowthSettings& settings) noexcept {
  if (!is_finite(seed)) return std::nullopt;
  const GridFrame& grid = obstacles.frame();
  const Vector2d origin = grid.to_grid(seed);
  const double radius = search_radius(grid, clearance);
  if (!is_free(obstacles, TurnedBox{.origin = origin}, radius)) return std::nullopt;
  Growth growth(obstacles, origin, radius,
                {.start = settings.start_size / grid.resolution,
                 .step = settings.growth_step / grid.resolution,
                 .limit = settings.max_growth / grid.resolution});
  std::optional<OrientedRectangle> best;
  for (int k = 0; k < settings.num_orientations; ++k) {
    const double orientation = std::numbers::pi / 2.0 * k / settings.num_orientations;  // Eq. (4)
    const std::optional<Box> box = growth.run(direction(orientation - grid.origin.heading));
    if (!box) continue;
    const OrientedRectangle rectangle{.seed = seed,
                                      .orientation = orientation,
                                      .min = box->min * grid.resolution,
                                      .max = box->max * grid.resolution};
    if (best && rectangle.area() <= best->area()) continue;
    if (is_free(obstacles, rectangle, clearance)) best = rectangle;
  }
  return best;
}

}  // namespace fairway
