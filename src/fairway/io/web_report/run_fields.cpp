// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/web_report/run_fields.hpp"

#include <algorithm>

namespace fairway::io {

void append_frame(CompactFields& out, const GridFrame& frame) {
  out.count(static_cast<std::uint64_t>(frame.width));
  out.count(static_cast<std::uint64_t>(frame.height));
  out.real(frame.resolution);
  out.real(frame.origin.position.x());
  out.real(frame.origin.position.y());
  out.real(frame.origin.heading);
}

std::string seen_map_fields(std::uint64_t slot, double time, const BitGrid& grid) {
  std::string fields;
  CompactFields out(fields);
  const auto width = static_cast<std::size_t>(grid.frame().width);
  append_whole_map(out, slot, time, grid.frame(), [&](std::size_t i) {
    const CellIndex cell{.x = static_cast<int>(i % width), .y = static_cast<int>(i / width)};
    return grid.blocked(cell) ? std::uint64_t{1} : std::uint64_t{0};
  });
  return fields;
}

void append_mark(CompactFields& out, const LimitMark& mark) {
  out.count(static_cast<std::uint64_t>(mark.row.kind));
  out.count(static_cast<std::uint64_t>(mark.shape));
  if (mark.shape == LimitMark::Shape::None) return;
  out.point(mark.a);
  if (mark.shape == LimitMark::Shape::Side) out.point(mark.b);
  if (mark.shape == LimitMark::Shape::Disc) out.millis(mark.radius);
}

void append_prediction(CompactFields& out, const MpcSolution* plan) {
  if (plan == nullptr) return out.count(0);
  out.count(static_cast<std::uint64_t>(plan->horizon));
  out.count(static_cast<std::uint64_t>(std::max(0, plan->iterations)));
  out.millis(plan->max_violation);
  PointDeltas points(out, plan->poses[0].position);
  for (int k = 1; k <= plan->horizon; ++k)
    points.append(plan->poses[static_cast<std::size_t>(k)].position);
}

void append_obstacles(CompactFields& out, std::span<const MovingObstacle> obstacles) {
  out.count(obstacles.size());
  for (const MovingObstacle& obstacle : obstacles) {
    out.point(obstacle.position);
    out.point(obstacle.velocity);
    out.millis(obstacle.radius);
  }
}

void append_goal(CompactFields& out, const Goal& goal, unsigned flags) {
  out.count(flags | (goal.heading ? 2U : 0U));
  out.point(goal.position);
  if (goal.heading) out.angle(*goal.heading);
}

}  // namespace fairway::io
