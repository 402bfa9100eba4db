// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/space_time_plan.hpp"

#include <algorithm>

namespace fairway {

SpaceTimePlan::State SpaceTimePlan::at(double time) const noexcept {
  if (stages == 0 || time <= 0.0) return states[0];
  const auto k = static_cast<std::size_t>(time / stage);
  if (k >= stages) return {.pose = states[stages].pose, .speed = 0.0};
  const State& from = states[k];
  const State& to = states[k + 1];
  const double within = time - static_cast<double>(k) * stage;
  const double turned = within / stage * (to.pose.heading - from.pose.heading);
  const double change =
      std::clamp(to.speed - from.speed, -acceleration * within, acceleration * within);
  const double driven = driven_in(within, from.speed, to.speed, acceleration);
  return {.pose = {.position =
                       from.pose.position + driven * direction(from.pose.heading + 0.5 * turned),
                   .heading = from.pose.heading + turned},
          .speed = from.speed + change};
}

}  // namespace fairway
