// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_plan_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fairway::internal {

using Eigen::Vector2d;

namespace {

// Marks the cells that a disc touches.
void block_disc(const Vector2d& center, double radius, BitGrid& obstacles, CellWindow& changed) {
  const GridFrame& frame = obstacles.frame();
  const Vector2d at = frame.to_grid(center);
  const double reach = radius / frame.resolution;
  const CellWindow window = clipped({.first = {.x = static_cast<int>(std::floor(at.x() - reach)),
                                               .y = static_cast<int>(std::floor(at.y() - reach))},
                                     .last = {.x = static_cast<int>(std::floor(at.x() + reach)),
                                              .y = static_cast<int>(std::floor(at.y() + reach))}},
                                    frame);
  if (is_empty(window)) return;
  for (int y = window.first.y; y <= window.last.y; ++y) {
    for (int x = window.first.x; x <= window.last.x; ++x) {
      const Vector2d corner(x, y);
      const Vector2d nearest = at.cwiseMax(corner).cwiseMin(Vector2d(corner + Vector2d::Ones()));
      if ((nearest - at).norm() <= reach) obstacles.set({.x = x, .y = y}, true);
    }
  }
  changed = united(changed, window);
}

}  // namespace

PreparedMap with_obstacles(const PreparedMap& map,
                           const BodyShape& body,
                           const BodyPlanRequest& request) {
  BitGrid obstacles = map.obstacles;
  CellWindow changed = kNoCells;
  for (const MovingObstacle& obstacle : request.standing) {
    const double apart = body.distance(inverse_transform(request.start, obstacle.position));
    // A cell reaches beyond the disc by up to its diagonal.
    const double free = apart - 1.5 * obstacles.frame().resolution;
    const double radius = std::min(obstacle.radius + request.kept, free);
    if (radius <= 0.0) continue;
    block_disc(obstacle.position, radius, obstacles, changed);
  }
  PreparedMap result = map;
  result.update(obstacles, changed);
  return result;
}

Trajectory lead_of(const BodyPlanRequest& request) {
  if (!request.lead.stop.inputs.empty()) return request.lead.stop;
  return {.start = request.start, .inputs = {BaseInput{}}, .steps = {}};
}

void begin_with(const DriveLead& lead, const BaseModel& base, double period, BodyPlan& plan) {
  plan.moving = !lead.stop.steps.empty() || !lead.ahead.steps.empty();
  if (lead.ahead.inputs.empty() || plan.drive.rows.empty()) return;
  plan.begin = lead.ahead.inputs.front();
  std::vector<TrajectoryRow> rows = sampled(base, lead.ahead, period);
  rows.pop_back();  // the pose at its end, where the drive begins
  rows.insert(rows.end(), plan.drive.rows.begin(), plan.drive.rows.end());
  plan.drive.rows = std::move(rows);
}

}  // namespace fairway::internal
