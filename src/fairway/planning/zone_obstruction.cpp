// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/zone_obstruction.hpp"

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
  const bool strip = cause.kind == ZoneKind::Strip;
  const std::string title = title_of(zones.zones(), *zone);
  if (cause.reference == ZoneReference::Centre) {
    if (!strip) return joined_text({named, " is inside the keep-out zone ", title});
    const std::string distance = length_text(zones.excursion(point));
    return joined_text({named, " is ", distance, " outside of the strips"});
  }
  return joined_text({named, " is ", length_text(zones.clearance_at(point, radius + 1.0)),
                      strip ? " inside the strips" : " from the keep-out zone ", strip ? "" : title,
                      " and the robot needs ", length_text(radius), " (robot.radius)"});
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
