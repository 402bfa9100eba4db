// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "fairway/base/setting.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/geometry/robot_settings.hpp"

namespace fairway::nav2 {

/// How the base moves, as users of Nav2 call it.
enum class MotionModel : std::uint8_t {
  Disc,             ///< differential; the body is the group `robot`, and paths are those of a disc
  Differential,     ///< turns on the spot; the body is the footprint of the costmap
  Ackermann,        ///< a car; the origin of the footprint is the middle of the rear axle
  Tricycle,         ///< the origin of the footprint is the middle of the fixed axle
  Omnidirectional,  ///< mecanum or swerve
};

[[nodiscard]] constexpr std::array<const char*, 5> setting_names(MotionModel /*type*/) noexcept {
  return {"disc", "differential", "ackermann", "tricycle", "omnidirectional"};
}

/// The base, as far as the group `robot` does not describe it.
struct MotionSettings {
  MotionModel model = MotionModel::Disc;
  double wheelbase = 1.0;             ///< [m], 0.05 to 20
  double steering_max = 0.6;          ///< [rad], 0.01 to 1.5
  double steering_rate_max = 1.0;     ///< [rad/s], 0.01 to 20
  double lateral_max = 0.3;           ///< [m/s], 0.01 to 10
  double lateral_acceleration = 1.0;  ///< [m/s^2], 0.01 to 1000
};

template <typename Settings, typename Visitor>
void visit_motion(Settings& s, Visitor&& field) {
  field(s.model, SettingInfo{"model", "",
                             "how the base moves; except for disc, the body is the true footprint "
                             "of the costmap"});
  field(s.wheelbase, SettingInfo{"wheelbase", "m",
                                 "distance from the fixed axle to the steered wheels, of ackermann "
                                 "and tricycle",
                                 0.05, 20});
  field(s.steering_max,
        SettingInfo{"steering_max", "rad", "greatest steering angle, of the same", 0.01, 1.5});
  field(s.steering_rate_max,
        SettingInfo{"steering_rate_max", "rad/s", "its greatest rate, of the same", 0.01, 20});
  field(s.lateral_max, SettingInfo{"lateral_max", "m/s",
                                   "greatest speed to the sides, of omnidirectional", 0.01, 10});
  field(s.lateral_acceleration,
        SettingInfo{"lateral_acceleration", "m/s^2", "greatest change of that speed", 0.01, 1000});
}

/// The base that both groups describe. @pre the model is not Disc.
[[nodiscard]] inline BaseModel base_of(const MotionSettings& motion,
                                       const RobotSettings& robot) noexcept {
  const auto slower = [](double gain, double loss) {
    return loss > 0.0 ? std::min(gain, loss) : gain;
  };
  constexpr std::array<BaseKind, 5> kKinds{BaseKind::Unicycle, BaseKind::Unicycle, BaseKind::Car,
                                           BaseKind::Tricycle, BaseKind::Omni};
  BaseModel base;
  base.kind = kKinds[static_cast<std::size_t>(motion.model)];
  base.wheelbase = motion.wheelbase;
  base.steering_max = motion.steering_max;
  base.steering_rate_max = motion.steering_rate_max;
  base.linear_min = robot.linear_min;
  base.linear_max = robot.linear_max;
  base.lateral_max = motion.lateral_max;
  base.angular_max = robot.angular_max;
  base.linear_acceleration = slower(robot.linear_acceleration_max, robot.linear_braking_max);
  base.lateral_acceleration = motion.lateral_acceleration;
  base.angular_acceleration = slower(robot.angular_acceleration_max, robot.angular_braking_max);
  base.response_time = std::min(1.0, std::max(robot.linear_delay + robot.linear_lag,
                                              robot.angular_delay + robot.angular_lag));
  return base;
}

}  // namespace fairway::nav2
