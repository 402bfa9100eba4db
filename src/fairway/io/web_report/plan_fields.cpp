// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/web_report/plan_fields.hpp"

#include <cmath>
#include <string_view>

#include "fairway/io/web_report/run_fields.hpp"

namespace fairway::io {

namespace {

std::size_t hash_of(const BitGrid& grid) {
  std::size_t hash = 0;
  for (int y = 0; y < grid.frame().height; ++y) {
    for (const auto word : grid.row(y))
      hash = (hash ^ static_cast<std::size_t>(word)) * 1099511628211U;  // FNV
  }
  return hash;
}

}  // namespace

const PlanExplanation& PlanExplainer::explain(const BitGrid& obstacles,
                                              const Eigen::Vector2d& start,
                                              const Plan& plan,
                                              double radius) {
  const GridFrame& frame = obstacles.frame();
  const std::int64_t cells = static_cast<std::int64_t>(frame.width) * frame.height;
  const bool known = plan.usable() || is_dropped(plan) || cells > kMostCells;
  if (known) {
    question_.reset();
    answer_ = {.text = plan.usable() ? "" : plan.reason(), .obstruction = {}};
    return answer_;
  }
  const Question question{.start = start,
                          .goal = plan.goal.position,
                          .path = plan.path_status,
                          .corridor = plan.corridor_status,
                          .radius = radius,
                          .margin = plan.margin,
                          .cells = hash_of(obstacles)};
  if (question_ == question) return answer_;
  question_ = question;
  const PreparedMap map(obstacles);
  answer_ = {.text = fairway::explain(map, start, plan, radius),
             .obstruction = find_obstruction(map, start, plan, radius)};
  return answer_;
}

bool is_dropped(const Plan& plan) noexcept {
  return plan.path_status == PathStatus::NoConnection &&
         plan.corridor_status == CorridorStatus::EmptyPath && plan.margin == 0.0 &&
         plan.path.waypoints.empty() && plan.goal.position.isZero(0.0) && !plan.goal.heading;
}

void append_plan(CompactFields& out, const Plan& plan) {
  append_goal(out, plan.goal, (plan.usable() ? 1U : 0U) | (is_dropped(plan) ? 4U : 0U));
  out.count(plan.path.waypoints.size());
  PointDeltas points(out);
  for (const Eigen::Vector2d& waypoint : plan.path.waypoints)
    points.append(waypoint);
  out.count(plan.corridor.rectangles.size());
  PointDeltas seeds(out);
  for (std::size_t i = 0; i < plan.corridor.rectangles.size(); ++i) {
    const OrientedRectangle rectangle = plan.corridor.admissible(i);
    seeds.append(rectangle.seed);
    out.angle(rectangle.orientation);
    out.point(rectangle.min);
    out.point(rectangle.max);
  }
}

void append_obstruction(CompactFields& out, const Plan& plan, const PlanExplanation& why) {
  out.text(plan.usable() ? std::string_view() : std::string_view(why.text));
  if (plan.usable() || !why.obstruction) return out.count(0);
  const PathObstruction& found = *why.obstruction;
  out.count(1U + static_cast<std::uint64_t>(found.kind));
  out.point(found.position);
  out.millis(found.found);
  out.millis(found.needed);
}

void append_encounter(CompactFields& out, const Encounter& met) {
  out.count((met.collided ? 1U : 0U) | (met.absent ? 2U : 0U));
  if (!met.collided) return;
  out.count(static_cast<std::uint64_t>(met.contact.with));
  out.count(met.contact.other);
  out.time(met.collision_time);
  out.millis(met.approach);
  out.millis(met.contact.other_approach);
}

}  // namespace fairway::io
