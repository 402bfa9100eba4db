// SPDX-License-Identifier: Apache-2.0
#include "experiments/baselines/sound_baselines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/corridor/rectangle/turned_frame.hpp"
#include "fairway/corridor/sequential_rectangles.hpp"

namespace fairway::baselines {

namespace {

using Eigen::Vector2d;

class OutlineGrowth {
 public:
  OutlineGrowth(const BitGrid& obstacles, const Vector2d& seed, double clearance)
      : obstacles_(obstacles),
        frame_{.origin = obstacles.frame().to_grid(seed),
               .along = direction(-obstacles.frame().origin.heading)},
        radius_(search_radius(obstacles.frame(), clearance)) {}

  // Sides in the order up, left, down, right; lengths in cells.
  [[nodiscard]] bool run(double start, double limit) {
    box_ = {.min = Vector2d::Constant(-start), .max = Vector2d::Constant(start)};
    if (!is_free(obstacles_, frame_.region(box_), radius_)) return false;
    std::array<bool, 4> growing{true, true, true, true};
    while (std::any_of(growing.begin(), growing.end(), [](bool g) { return g; })) {
      for (std::size_t side = 0; side < 4; ++side)
        growing[side] = growing[side] && advance(side, limit);
    }
    return true;
  }

  [[nodiscard]] const Box& box() const { return box_; }

 private:
  [[nodiscard]] bool free(const Vector2d& a, const Vector2d& b) const {
    return is_free(obstacles_, frame_.region({.min = a.cwiseMin(b), .max = a.cwiseMax(b)}),
                   radius_);
  }

  bool advance(std::size_t side, double limit) {
    const int axis = side % 2 == 0 ? 1 : 0;
    const bool upper = side == 0 || side == 3;
    Box next = box_;
    double& place = (upper ? next.max : next.min)[axis];
    place += upper ? 1.0 : -1.0;
    if (std::abs(place) > limit) return false;
    // The new edge from a to b, and its short connections to the old edge.
    Vector2d a = next.min;
    Vector2d b = next.max;
    a[axis] = place;
    b[axis] = place;
    const Vector2d back = Vector2d::Unit(axis) * (upper ? -1.0 : 1.0);
    if (!free(a, b) || !free(a, a + back) || !free(b, b + back)) return false;
    box_ = next;
    return true;
  }

  const BitGrid& obstacles_;
  TurnedFrame frame_;
  double radius_;
  Box box_;
};

}  // namespace

CorridorResult build_src(const BitGrid& obstacles,
                         const Path& path,
                         double robot_radius,
                         const CorridorSettings& settings) {
  CorridorSettings single = settings;
  single.num_orientations = 1;
  return build_sequential(obstacles, path, robot_radius, single);
}

CorridorResult build_fsrc(const BitGrid& obstacles,
                          const Path& path,
                          double robot_radius,
                          const CorridorSettings& settings) {
  const bool workspace = settings.space == CorridorSpace::Workspace;
  const double clearance = workspace ? 0.0 : robot_radius;
  const double cell = obstacles.frame().resolution;
  const auto grow = [&](const Vector2d& seed) -> std::optional<OrientedRectangle> {
    OutlineGrowth growth(obstacles, seed, clearance);
    if (!growth.run(workspace ? settings.inward_offset / cell : 0.0, settings.max_growth / cell))
      return std::nullopt;
    const OrientedRectangle rectangle{.seed = seed,
                                      .orientation = 0.0,
                                      .min = growth.box().min * cell,
                                      .max = growth.box().max * cell};
    if (!is_free(obstacles, rectangle, clearance)) return std::nullopt;
    return rectangle;
  };
  return build_sequential(obstacles, path, robot_radius, settings, grow);
}

}  // namespace fairway::baselines
