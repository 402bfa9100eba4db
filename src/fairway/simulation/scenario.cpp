// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/scenario.hpp"

#include <algorithm>

namespace fairway {

bool has_models(const Scenario& scenario) noexcept {
  return std::any_of(scenario.robots.begin(), scenario.robots.end(),
                     [](const RobotTask& task) { return task.model.has_value(); });
}

Expected<void> check_models(const Scenario& scenario) {
  if (!has_models(scenario)) return {};
  if (scenario.engine != Engine::Unicycle)
    return fail("physics: expected unicycle for robots with their own body (robot:), found mujoco");
  return {};
}

void describe_models(Scenario& scenario) {
  const auto found = std::find_if(scenario.robots.begin(), scenario.robots.end(),
                                  [](const RobotTask& task) { return task.model.has_value(); });
  if (found == scenario.robots.end()) return;
  const BaseModel& base = found->model->base;
  const BodyShape& body = found->model->body;
  RobotSettings& robot = scenario.settings.robot;
  robot.linear_min = std::max(base.linear_min, -10.0);
  robot.linear_max = std::min(base.linear_max, 10.0);
  robot.angular_max = std::min(base.angular_max, 20.0);
  robot.linear_acceleration_max = base.linear_acceleration;
  robot.angular_acceleration_max = base.angular_acceleration;
  robot.radius = std::clamp(body.circumscribed_radius(), 0.01, 10.0);
  robot.length = 0.0;
  robot.width = 0.0;
  const auto cover = body.cover();
  const std::size_t most = robot.discs.discs.size();
  // Every second disc, or every third, where there are more than settings can hold.
  const std::size_t every = (cover.size() + most - 1) / most;
  robot.discs.count = 0;
  for (std::size_t i = 0; i < cover.size(); i += every)
    robot.discs.discs[static_cast<std::size_t>(robot.discs.count++)] = cover[i];
}

}  // namespace fairway
