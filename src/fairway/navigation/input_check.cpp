// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/input_check.hpp"

#include <cmath>

namespace fairway {

LimitingFactor check_input(const NavigationInput& input,
                           const SafetySettings& settings,
                           DeadReckoning& reckoning) noexcept {
  if (!is_finite(input.pose) || !std::isfinite(input.time)) return LimitingFactor::NonFinitePose;
  // Written so that a stamp that is not finite is stale. A stamp from the future is no better.
  const auto fresh = [&](double stamp, double timeout) {
    return std::abs(input.time - stamp) <= timeout;
  };
  if (!fresh(input.pose_time, settings.pose_timeout)) return LimitingFactor::StalePose;
  if (!reckoning.fits(input.pose, input.pose_time, settings.pose_jump))
    return LimitingFactor::PoseJump;
  if (input.map == nullptr || !fresh(input.map_time, settings.map_timeout))
    return LimitingFactor::StaleMap;
  for (const MovingObstacle& obstacle : input.obstacles) {
    if (!is_finite(obstacle.position) || !is_finite(obstacle.velocity) ||
        !std::isfinite(obstacle.radius)) {
      return LimitingFactor::NonFiniteTracks;
    }
  }
  if ((input.obstacles_due || !input.obstacles.empty()) &&
      !fresh(input.obstacles_time, settings.tracks_timeout)) {
    return LimitingFactor::StaleTracks;
  }
  for (const FleetMember& member : input.fleet) {
    if (!is_finite(*member.motion)) return LimitingFactor::NonFiniteTracks;
    if (!fresh(member.motion->time, settings.tracks_timeout)) return LimitingFactor::StaleTracks;
  }
  return LimitingFactor::None;
}

NavigationStatus status_for(LimitingFactor bad_input) noexcept {
  return bad_input == LimitingFactor::NonFinitePose ||
                 bad_input == LimitingFactor::NonFiniteTracks ||
                 bad_input == LimitingFactor::PoseJump
             ? NavigationStatus::BadInput
             : NavigationStatus::Stale;
}

}  // namespace fairway
