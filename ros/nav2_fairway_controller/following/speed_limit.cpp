// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/following/speed_limit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fairway::nav2 {

namespace {

constexpr double kLeastSpeed = 0.01;    // [m/s], the least value of robot.linear_max
constexpr double kLeastPeriod = 0.005;  // [s], as navigation.control_period
constexpr double kMostPeriod = 1.0;

std::string text_of(double number) {
  char text[32];
  std::snprintf(static_cast<char*>(text), sizeof(text), "%.4g", number);
  return static_cast<const char*>(text);
}

}  // namespace

LimitedSettings limited(const Settings& settings, const SpeedLimit& limit) {
  LimitedSettings answer{.settings = settings, .holds = false, .fault = {}};
  if (limit.value == 0.0) return answer;
  const double full = settings.robot.linear_max;
  const double most = limit.percentage ? 0.01 * limit.value * full : limit.value;
  if (!std::isfinite(most) || most < 0.0) {
    answer.fault = "the speed limit " + text_of(limit.value) +
                   " is ignored: expected a positive number, or 0 for no limit";
    return answer;
  }
  if (most < kLeastSpeed) {
    answer.holds = true;
    answer.fault = "the speed limit of " + text_of(most) +
                   " m/s is below the least speed that can be driven, " + text_of(kLeastSpeed) +
                   " m/s";
    return answer;
  }
  limit_speed(most, answer.settings.robot);
  return answer;
}

void limit_speed(double most, RobotSettings& robot) noexcept {
  robot.linear_max = std::min(robot.linear_max, most);
  robot.linear_min = std::clamp(robot.linear_min, -robot.linear_max, robot.linear_max);
}

void narrow_tolerances(const GoalTolerance& checker, NavigationSettings& navigation) noexcept {
  constexpr double kShare = 0.8;
  constexpr double kLeast = 0.001;  // the least value of both settings
  const auto narrow = [&](double other, double& own) {
    if (other > 0.0) own = std::min(own, std::max(kLeast, kShare * other));
  };
  narrow(checker.distance, navigation.goal_tolerance);
  narrow(checker.heading, navigation.heading_tolerance);
}

std::optional<double> approach_speed(const Settings& settings,
                                     const GoalTolerance& checker,
                                     double distance,
                                     double speed) noexcept {
  if (checker.requires_stop || !(checker.distance > 0.0)) return std::nullopt;
  const double acceleration = settings.robot.linear_acceleration_max;
  const double period = settings.navigation.control_period;
  const double slow = std::max(kLeastSpeed, acceleration * period);
  if (slow >= settings.robot.linear_max) return std::nullopt;
  // Braking from the present speed, and two periods until the base follows.
  const double fast = std::max(slow, std::abs(speed));
  const double braking = (fast * fast - slow * slow) / (2.0 * acceleration);
  if (distance > checker.distance + braking + 2.0 * period * fast) return std::nullopt;
  return slow;
}

std::string frequency_fault(double control_period, double frequency) {
  constexpr double kShare = 0.01;  // of the period; less is rounding of a frequency in a file
  if (!(frequency > 0.0)) {
    return "controller_frequency: expected a positive number, found " + text_of(frequency);
  }
  if (frequency < 1.0 / kMostPeriod || frequency > 1.0 / kLeastPeriod) {
    return "controller_frequency: expected " + text_of(1.0 / kMostPeriod) + " to " +
           text_of(1.0 / kLeastPeriod) + " Hz, found " + text_of(frequency);
  }
  if (std::abs(control_period * frequency - 1.0) <= kShare) return {};
  return "navigation.control_period: expected " + text_of(1.0 / frequency) +
         " (1 / controller_frequency; leave it out to get this value), found " +
         text_of(control_period);
}

double period_of(double frequency) noexcept {
  return frequency > 0.0 ? std::clamp(1.0 / frequency, kLeastPeriod, kMostPeriod) : kMostPeriod;
}

}  // namespace fairway::nav2
