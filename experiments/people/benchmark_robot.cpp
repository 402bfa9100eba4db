// SPDX-License-Identifier: Apache-2.0
// The robots of the benchmarks: what they can do, and how often they are commanded.
#include <cmath>

#include <fmt/core.h>

#include "experiments/people/people_runs.hpp"

namespace fairway {

void use_recorded_robot(Settings& settings) {
  settings.robot.radius = 0.25;
  settings.robot.linear_min = -0.5;
  settings.robot.linear_max = 1.75;
  settings.robot.angular_max = 4.0;
  settings.robot.linear_acceleration_max = 2.0;
  settings.robot.angular_acceleration_max = 4.0;
  settings.navigation.control_period = PeopleRecording::kFrame;
}

void use_crowd_robot(CrowdBenchmark benchmark, Kinematics kinematics, Settings& settings) {
  const bool wheeled = benchmark == CrowdBenchmark::DsRnn;
  settings.robot.radius = 0.3;
  settings.robot.linear_max = 1.0;
  settings.robot.linear_min = wheeled ? -1.0 : -0.5;
  settings.robot.angular_max = wheeled ? 1.0 : 4.0;
  settings.robot.linear_acceleration_max = wheeled ? 1.0 : 2.0;
  settings.robot.angular_acceleration_max = 4.0;
  settings.navigation.control_period = wheeled ? 0.1 : 0.05;
  if (kinematics == Kinematics::Jumps) {
    settings.robot.angular_acceleration_max = 20.0;
    settings.safety.actuation_lag = 0.0;
  }
}

Expected<void> check_period(const Settings& settings, double step) {
  const double period = settings.navigation.control_period;
  const double cycles = std::round(step / period);
  if (cycles >= 1.0 && std::abs(cycles * period - step) < 1e-9) return {};
  return fail(fmt::format(
      "navigation.control_period: expected {} s or a whole part of it, found {}", step, period));
}

}  // namespace fairway
