// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/space_time_plan.hpp"

#include <algorithm>

namespace fairway {

Eigen::Vector2d position_in_stage(const SpaceTimePlan::State& from,
                                  const SpaceTimePlan::State& to,
                                  double stage,
                                  double time) noexcept {
  const double share = time / stage;
  const double driven = time * (from.speed + 0.5 * share * (to.speed - from.speed));
  const double along = from.pose.heading + 0.5 * share * (to.pose.heading - from.pose.heading);
  return from.pose.position + driven * direction(along);
}

SpaceTimePlan::State SpaceTimePlan::at(double time) const noexcept {
  if (stages == 0 || time <= 0.0) return states[0];
  const auto k = static_cast<std::size_t>(time / stage);
  if (k >= stages) return {.pose = states[stages].pose, .speed = 0.0};
  const State& from = states[k];
  const State& to = states[k + 1];
  const double within = time - static_cast<double>(k) * stage;
  const double share = within / stage;
  return {.pose = {.position = position_in_stage(from, to, stage, within),
                   .heading = from.pose.heading + share * (to.pose.heading - from.pose.heading)},
          .speed = from.speed + share * (to.speed - from.speed)};
}

}  // namespace fairway
