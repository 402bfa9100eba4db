// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

namespace {

constexpr double kMostClearance = 1000.0;  // a radius, an offset or a margin [m]

// Written so that NaN is none.
bool is_clearance(double value) noexcept { return value >= 0.0 && value <= kMostClearance; }

bool is_rectangle(const OrientedRectangle& r) noexcept {
  return is_plausible(Pose2{.position = r.seed, .heading = r.orientation}) && is_plausible(r.min) &&
         is_plausible(r.max) && !r.is_empty();
}

std::string wrong(std::size_t index, const char* expected) {
  return "rectangle " + std::to_string(index) + ": expected " + expected;
}

Expected<void> check_corridor(const Corridor& corridor) {
  if (corridor.rectangles.empty()) return fail("expected a corridor of at least one rectangle");
  if (!is_clearance(corridor.robot_radius) || !is_clearance(corridor.inward_offset))
    return fail("expected a corridor for a radius and an offset from 0 to 1000 m");
  for (std::size_t i = 0; i < corridor.rectangles.size(); ++i) {
    if (!is_rectangle(corridor.rectangles[i])) return fail(wrong(i, "plausible corners"));
    if (corridor.admissible(i).is_empty()) return fail(wrong(i, "a part that is admissible"));
    if (i > 0 && overlap(corridor.admissible(i - 1), corridor.admissible(i)).count == 0)
      return fail(wrong(i, "an overlap with the one before"));
  }
  return {};
}

}  // namespace

Expected<void> validate(const Plan& plan) {
  if (!plan.usable()) return {};
  const std::vector<Eigen::Vector2d>& points = plan.path.waypoints;
  const auto is_place = [](const Eigen::Vector2d& point) { return is_plausible(point); };
  if (points.empty() || !std::all_of(points.begin(), points.end(), is_place))
    return fail("expected a path of at least one plausible point");
  if (!is_plausible(plan.goal.position) ||
      (plan.goal.heading && !(std::abs(*plan.goal.heading) <= 2.0 * std::numbers::pi))) {
    return fail("expected a goal at a plausible place, with a heading in radians");
  }
  if (!is_clearance(plan.margin)) return fail("expected a margin from 0 to 1000 m");
  return check_corridor(plan.corridor);
}

}  // namespace fairway
