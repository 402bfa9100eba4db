// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/settings.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/safety/braking_profile.hpp"

namespace fairway {

Settings paper_settings() {
  Settings s;
  s.robot.radius = 0.3;  // the paper gives the body only through Delta_s
  s.path = {.margin = 0.0, .comfort_distance = 0.3, .comfort_weight = 1.5, .any_angle = true};
  s.corridor.method = CorridorMethod::Mdsrc;
  s.corridor.space = CorridorSpace::Workspace;
  s.corridor.num_orientations = 10;
  s.corridor.growth_step = 0.1;
  s.corridor.max_growth = 8.0;
  s.corridor.inward_offset = 0.3;
  s.mpc.horizon = 10;
  s.mpc.step_length = 0.1;
  s.mpc.integration = Integration::Euler;
  s.robot.linear_min = 0.05;
  s.robot.linear_max = 1.0;
  s.robot.angular_max = 1.5;
  s.robot.linear_acceleration_max = 1000.0;  // the paper has no such limit
  s.robot.angular_acceleration_max = 1000.0;
  s.mpc.weight_position = 20.0;
  s.mpc.weight_heading = 0.1;
  s.mpc.weight_next_position = 5.0;
  s.mpc.weight_next_heading = 0.05;
  s.mpc.penalise_first_change = false;
  s.mpc.decay_rate = 5.0;
  s.tracking.target_mode = TargetMode::DualWaypoints;
  s.tracking.step_regions = false;
  s.tracking.space_time_horizon = 0.0;  // the plan in space and time is not of the paper
  s.navigation.goal_tolerance = 0.2;    // d_max is not given
  s.navigation.heading_tolerance = 3.15;
  s.safety.actuation_lag = 0.0;
  s.prediction.obstacle_growth = 0.0;
  s.prediction.obstacle_margin = 0.2;  // two robots of radius 0.3 then keep R_o = 0.8
  return s;
}

namespace {

// The braking from the greatest speed must fit into a StopSequence.
Expected<void> check_stop_length(const Settings& settings) {
  constexpr int kMostCycles = static_cast<int>(StopSequence::capacity()) - kMaxHorizon - 2;
  const auto check = [&](const char* names, double speed, double braking) -> Expected<void> {
    const double cycles = speed / (braking * settings.navigation.control_period);
    if (cycles <= kMostCycles) return {};
    std::ostringstream text;
    text << names << ": expected enough to stop within " << kMostCycles
         << " cycles of navigation.control_period, found " << std::ceil(cycles);
    return fail(text.str());
  };
  const RobotSettings& robot = settings.robot;
  const double linear = std::max(std::abs(robot.linear_max), std::abs(robot.linear_min));
  if (const Expected<void> good =
          check(robot.linear_braking_max > 0.0 ? "robot.linear_braking_max"
                                               : "robot.linear_acceleration_max",
                linear, linear_actuation(robot).braking);
      !good) {
    return good;
  }
  return check(robot.angular_braking_max > 0.0 ? "robot.angular_braking_max"
                                               : "robot.angular_acceleration_max",
               robot.angular_max, angular_actuation(robot).braking);
}

}  // namespace

Expected<void> validate(const Settings& settings) {
  std::string error;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
        const auto number = static_cast<double>(value);
        // This form also rejects NaN.
        if (error.empty() && !(number >= info.min && number <= info.max)) {
          std::ostringstream text;
          text << group << '.' << info.name << ": expected a number from " << info.min << " to "
               << info.max << ", found " << number;
          error = text.str();
        }
      }
    });
  });
  if (!error.empty()) return fail(error);
  constexpr double kMostCells = 4096.0;  // along a side of the rolling map
  if (settings.perception.window > kMostCells * settings.perception.resolution) {
    return fail("perception.window: expected at most 4096 cells of perception.resolution");
  }
  if ((settings.robot.length > 0.0) != (settings.robot.width > 0.0)) {
    return fail("robot.width: expected both robot.length and robot.width, or neither");
  }
  if (!is_valid(settings.robot.discs)) {
    return fail(std::string("robot.discs: expected ") + kBodyDiscsExpected);
  }
  if (settings.robot.discs.count > 0 && settings.robot.length > 0.0) {
    return fail("robot.discs: expected no robot.length and robot.width together with discs");
  }
  if (settings.robot.linear_min > settings.robot.linear_max) {
    return fail("robot.linear_min: expected at most robot.linear_max");
  }
  if (settings.mpc.decay_rate * settings.mpc.step_length > 1.0) {
    std::ostringstream text;
    text << "mpc.decay_rate: expected at most 1 / mpc.step_length = "
         << 1.0 / settings.mpc.step_length << " (Eq. 14), found " << settings.mpc.decay_rate;
    return fail(text.str());
  }
  return check_stop_length(settings);
}

const Settings& checked(const Settings& settings) {
  if (const Expected<void> valid = validate(settings); !valid) {
    throw std::invalid_argument(valid.error().message);
  }
  return settings;
}

}  // namespace fairway
