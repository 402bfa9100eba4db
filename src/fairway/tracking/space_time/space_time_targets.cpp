// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/space_time_targets.hpp"

#include "fairway/geometry/angle.hpp"

namespace fairway {

void set_space_time_targets(const SpaceTimePlan& plan,
                            double time,
                            const MpcSettings& mpc,
                            ControlProblem& problem) noexcept {
  double along = problem.start.heading;
  for (int k = 1; k <= problem.horizon; ++k) {
    const SpaceTimePlan::State aim = plan.at(time - plan.start + k * problem.dt);
    along += shortest_turn(along, aim.pose.heading);
    problem.targets[static_cast<std::size_t>(k)] = {
        .position = aim.pose.position,
        .heading = along,
        .weight = {mpc.weight_position, mpc.weight_position, mpc.weight_heading}};
  }
}

}  // namespace fairway
