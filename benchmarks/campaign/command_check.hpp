// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::campaign {

/// Notes the commands that are not finite or outside the limits of the base.
class CommandCheck {
 public:
  CommandCheck(const Settings& settings, const std::optional<RobotModel>& model)
      : settings_(settings),
        model_(model) {}

  /// @param elapsed  Since the command before [s].
  [[nodiscard]] bool good(const NavigationStep& step, double elapsed) {
    const double period = std::max(settings_.navigation.control_period, elapsed);
    const bool within = model_ ? good_for_model(step, period) : good_for_disc(step.command, period);
    last_ = {
        .linear = step.command.linear, .lateral = step.lateral, .angular = step.command.angular};
    steering_ = step.steering;
    return within;
  }

  /// Notes what was sent in place of the last command.
  void replace_last(const Twist2& sent) noexcept {
    last_.linear = sent.linear;
    last_.angular = sent.angular;
  }

 private:
  static constexpr double kRounding = 1e-9;

  static bool changes_by(double from, double to, double most) {
    return std::abs(to - from) <= most + kRounding;
  }

  [[nodiscard]] bool good_for_disc(const Twist2& command, double period) const {
    const RobotSettings& robot = settings_.robot;
    const double linear =
        std::max(linear_actuation(robot).acceleration, linear_actuation(robot).braking);
    const double angular =
        std::max(angular_actuation(robot).acceleration, angular_actuation(robot).braking);
    return is_finite(command) && command.linear <= robot.linear_max + kRounding &&
           command.linear >= std::min(0.0, robot.linear_min) - kRounding &&
           std::abs(command.angular) <= robot.angular_max + kRounding &&
           changes_by(last_.linear, command.linear, linear * period) &&
           changes_by(last_.angular, command.angular, angular * period);
  }

  // A steered base has no command of its angular speed: that follows from the steering angle.
  [[nodiscard]] bool good_for_model(const NavigationStep& step, double period) const {
    const BaseModel& base = model_->base;
    const PlanarTwist twist{
        .linear = step.command.linear, .lateral = step.lateral, .angular = step.command.angular};
    if (!is_finite(twist) || !std::isfinite(step.steering)) return false;
    constexpr double kRoundedLoad = 1e-6;
    const bool turns =
        is_steered(base)
            ? std::abs(step.steering) <= base.steering_max + kRounding &&
                  changes_by(steering_, step.steering, base.steering_rate_max * period)
            : std::abs(twist.angular) <= base.angular_max + kRounding &&
                  changes_by(last_.angular, twist.angular, base.angular_acceleration * period);
    const bool slides =
        base.kind == BaseKind::Omni
            ? std::abs(twist.lateral) <= base.lateral_max + kRounding &&
                  changes_by(last_.lateral, twist.lateral, base.lateral_acceleration * period)
            : twist.lateral == 0.0;
    return turns && slides && twist.linear <= base.linear_max + kRounding &&
           twist.linear >= base.linear_min - kRounding &&
           changes_by(last_.linear, twist.linear, base.linear_acceleration * period) &&
           wheel_load(base, twist) <= 1.0 + kRoundedLoad;
  }

  Settings settings_;
  std::optional<RobotModel> model_;
  PlanarTwist last_;
  double steering_ = 0.0;
};

}  // namespace fairway::campaign
