// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/collision_environment.hpp"

#include <algorithm>

#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

CollisionEnvironment static_environment(const BitGrid& obstacles,
                                        const Footprint& body,
                                        const Pose2& pose,
                                        double plan_margin,
                                        double radius,
                                        const SafetySettings& settings) noexcept {
  constexpr double kLeastMargin = 5e-4;  // [m]
  const bool disc = body.inscribed_radius() >= body.circumscribed_radius();
  const double margin =
      disc ? std::min(settings.stop_margin, std::max(kLeastMargin, 0.5 * plan_margin))
           : settings.stop_margin;
  const double clearance =
      footprint_clearance(obstacles, body, pose, margin + 4.0 * kFreeSpaceSkin) -
      2.0 * kFreeSpaceSkin;
  CollisionEnvironment around{.obstacles = &obstacles,
                              .body = clearance < 0.0 ? body.shrunk(-clearance) : body,
                              .static_margin = std::clamp(clearance, 0.0, margin),
                              .moving = {}};
  if (disc || radius < body.circumscribed_radius()) return around;
  // The plan keeps the covering disc free, so that the robot can turn anywhere. As long as the body
  // is free, a little of that may be lost during the stop, but no more than is lost already. Where
  // the disc has less clearance than the margin, the margin must not forbid to turn.
  const double disc_room =
      distance_to_blocked(obstacles, pose.position, radius + margin, ZoneSubject::Body) -
      2.0 * kFreeSpaceSkin;
  around.turning_radius = std::min(radius - settings.turn_clearance_tolerance, disc_room);
  const double turning_margin = disc_room - body.circumscribed_radius();
  if (turning_margin > 0.0) around.static_margin = std::min(around.static_margin, turning_margin);
  return around;
}

}  // namespace fairway
