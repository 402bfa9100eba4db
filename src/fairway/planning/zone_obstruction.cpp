// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/zone_obstruction.hpp"

#include <array>
#include <cstdio>

#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

std::string place(const Vector2d& point) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "(%.2f, %.2f)", point.x(), point.y());
  return text.data();
}

std::optional<std::string> end_in_zone(const ZoneMap& zones,
                                       const char* end,
                                       const Vector2d& point,
                                       double radius) {
  const auto zone =
      zones.forbidding(segment_rectangle(point, point), radius + kFreeSpaceSkin, ZoneSubject::Disc);
  if (!zone) return std::nullopt;
  std::string text = std::string("the ") + end + " " + place(point);
  if (zones.zones()[*zone].kind == ZoneKind::Strip) {
    text += " is not inside the strips with the robot";
  } else {
    text += " is inside a keep-out zone with the robot, or too near to it: ";
    text += title_of(zones.zones(), *zone);
  }
  return text;
}

}  // namespace

std::optional<std::string> explain_zones(const PreparedMap& map,
                                         const Vector2d& start,
                                         const Plan& plan,
                                         double radius) {
  const ZoneMap* zones = map.obstacles.zones();
  if (zones == nullptr || plan.usable()) return std::nullopt;
  if (plan.path_status == PathStatus::StartBlocked)
    return end_in_zone(*zones, "start", start, radius);
  if (plan.path_status == PathStatus::GoalBlocked)
    return end_in_zone(*zones, "goal", plan.goal.position, radius);
  if (plan.path_status != PathStatus::NoConnection) return std::nullopt;
  BitGrid bare = map.obstacles;
  bare.set_zones(nullptr);
  Planner planner;
  const PreparedMap without(std::move(bare));
  const Plan other = planner.plan(without, start, plan.goal, {.radius = radius});
  if (other.path_status != PathStatus::Found) return std::nullopt;
  return std::string("there is no path that the zones allow; without them there is one, of ") +
         std::to_string(static_cast<int>(other.path.length() + 0.5)) + " m";
}

}  // namespace fairway
