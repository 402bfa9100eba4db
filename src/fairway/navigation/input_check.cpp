// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/input_check.hpp"

#include <cmath>

namespace fairway {

LimitingFactor check_input(const NavigationInput& input,
                           const SafetySettings& settings,
                           DeadReckoning& reckoning) noexcept {
  if (!is_plausible(input.pose) || !std::isfinite(input.time)) return LimitingFactor::InvalidPose;
  // This form also treats a non-finite stamp as stale. A stamp in the future is stale too.
  const auto fresh = [&](double stamp, double timeout) {
    return std::abs(input.time - stamp) <= timeout;
  };
  if (!fresh(input.pose_time, settings.pose_timeout)) return LimitingFactor::StalePose;
  if (!reckoning.fits(input.pose, input.pose_time, settings.pose_jump))
    return LimitingFactor::PoseJump;
  if (input.map == nullptr || !fresh(input.map_time, settings.map_timeout))
    return LimitingFactor::StaleMap;
  for (const MovingObstacle& obstacle : input.obstacles) {
    if (!is_plausible(obstacle)) return LimitingFactor::InvalidTracks;
  }
  if ((input.obstacles_due || !input.obstacles.empty()) &&
      !fresh(input.obstacles_time, settings.tracks_timeout)) {
    return LimitingFactor::StaleTracks;
  }
  for (const FleetMember& member : input.fleet) {
    if (!is_plausible(*member.motion)) return LimitingFactor::InvalidTracks;
    if (!fresh(member.motion->time, settings.tracks_timeout)) return LimitingFactor::StaleTracks;
  }
  return LimitingFactor::None;
}

NavigationStatus status_for(LimitingFactor bad_input) noexcept {
  return bad_input == LimitingFactor::InvalidPose || bad_input == LimitingFactor::InvalidTracks ||
                 bad_input == LimitingFactor::PoseJump || bad_input == LimitingFactor::InvalidTime
             ? NavigationStatus::BadInput
             : NavigationStatus::Stale;
}

}  // namespace fairway
