// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/zone_obstruction.hpp"

#include <algorithm>

#include "fairway/map/free_space.hpp"
#include "fairway/planning/obstruction_text.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

std::optional<std::string> end_in_zone(const ZoneMap& zones,
                                       const char* end,
                                       const Vector2d& point,
                                       double radius) {
  const auto zone =
      zones.forbidding(segment_rectangle(point, point), radius + kFreeSpaceSkin, ZoneSubject::Disc);
  if (!zone) return std::nullopt;
  const Zone& cause = zones.zones()[*zone];
  const std::string named = joined_text({"the ", end, " ", place_text(point)});
  const bool centre = cause.reference == ZoneReference::Centre;
  if (cause.kind == ZoneKind::Strip && centre)
    return joined_text(
        {named, " is ", length_text(zones.excursion(point)), " outside of the strips"});
  const double less = centre ? radius : 0.0;
  const std::string found =
      length_text(std::max(0.0, zones.clearance_at(point, radius + 1.0) - less));
  const std::string needed =
      joined_text({length_text(radius - less), centre ? "" : " (robot.radius)"});
  if (cause.kind == ZoneKind::Strip) {
    return joined_text({named, " is ", found, " inside the strips and the robot needs ", needed});
  }
  return joined_text({named, " is ", found, " from the keep-out zone ",
                      title_of(zones.zones(), *zone), " and the robot needs ", needed});
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
