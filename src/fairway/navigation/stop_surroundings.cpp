// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/stop_surroundings.hpp"

#include <algorithm>

#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

StopSurroundings static_surroundings(const BitGrid& obstacles,
                                     const Footprint& body,
                                     const Pose2& pose,
                                     double plan_margin,
                                     const Settings& settings) noexcept {
  constexpr double kLeastMargin = 5e-4;  // [m]
  const NavigationSettings& nav = settings.navigation;
  const bool disc = body.inscribed_radius() >= body.circumscribed_radius();
  const double margin =
      disc ? std::min(nav.stop_margin, std::max(kLeastMargin, 0.5 * plan_margin)) : nav.stop_margin;
  const double room = footprint_clearance(obstacles, body, pose, margin + 4.0 * kFreeSpaceSkin) -
                      2.0 * kFreeSpaceSkin;
  StopSurroundings around{.obstacles = &obstacles,
                          .body = room < 0.0 ? body.shrunk(-room) : body,
                          .static_margin = std::clamp(room, 0.0, margin),
                          .moving = {}};
  const double radius = settings.robot.radius;
  if (disc || radius < body.circumscribed_radius()) return around;
  // The plan keeps the covering disc free, so that the robot can turn anywhere. As long as the body
  // is free a little of that may be lost on the way, but no more than is lost already. Where the
  // disc has less room than the margin, the margin must not forbid to turn.
  const double disc_room =
      distance_to_blocked(obstacles, pose.position, radius + margin) - 2.0 * kFreeSpaceSkin;
  around.turning_radius = std::min(radius - nav.turning_play, disc_room);
  const double turning_margin = disc_room - body.circumscribed_radius();
  if (turning_margin > 0.0) around.static_margin = std::min(around.static_margin, turning_margin);
  return around;
}

}  // namespace fairway
