// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/geometry/robot_model.hpp"

namespace fairway::test {

/// A robot with its name.
struct NamedRobot {
  const char* name;
  RobotModel model;
};

/// The robots of scenarios/robots.
inline std::array<NamedRobot, 8> robot_presets() {
  const auto platform = [](double length, double width, BaseModel base) {
    return RobotModel{.body = BodyShape::rectangle(length, width, 0.5 * length), .base = base};
  };
  const BaseModel car{.kind = BaseKind::Car,
                      .wheelbase = 1.0,
                      .steering_max = 0.6,
                      .steering_rate_max = 0.8,
                      .linear_min = -0.6,
                      .linear_max = 1.2,
                      .angular_max = 1.5,
                      .linear_acceleration = 0.8,
                      .angular_acceleration = 3.0};
  const BaseModel truck{.kind = BaseKind::Tricycle,
                        .wheelbase = 1.3,
                        .steering_max = 1.2,
                        .steering_rate_max = 1.0,
                        .linear_min = -0.8,
                        .linear_max = 1.2,
                        .angular_max = 1.0,
                        .linear_acceleration = 0.6,
                        .angular_acceleration = 2.0,
                        .wheels = {.kind = WheelKind::Steered, .speed_max = 1.3}};
  const BaseModel mecanum{
      .kind = BaseKind::Omni,
      .linear_min = -1.0,
      .linear_max = 1.0,
      .lateral_max = 0.6,
      .angular_max = 1.2,
      .linear_acceleration = 0.8,
      .lateral_acceleration = 0.8,
      .angular_acceleration = 2.0,
      .wheels = {.kind = WheelKind::Mecanum, .speed_max = 1.2, .half_sum = 0.9}};
  const auto wheeled = [](double back, double ahead, double turn, double change, double spin) {
    return BaseModel{.kind = BaseKind::Unicycle,
                     .linear_min = -back,
                     .linear_max = ahead,
                     .angular_max = turn,
                     .linear_acceleration = change,
                     .angular_acceleration = spin};
  };
  return {{{"car", {.body = BodyShape::rectangle(1.6, 0.7, 1.3), .base = car}},
           {"jackal", platform(0.458, 0.416, wheeled(0.5, 2.0, 4.0, 2.0, 4.0))},
           {"mecanum", platform(1.2, 0.8, mecanum)},
           {"mir250", platform(0.8, 0.58, wheeled(0.5, 1.5, 1.5, 1.0, 2.0))},
           {"mir600", platform(1.35, 0.91, wheeled(0.5, 1.5, 1.2, 0.8, 1.5))},
           {"pallet_truck", {.body = BodyShape::rectangle(1.9, 0.8, 1.5), .base = truck}},
           {"platform_1200", platform(1.2, 0.6, wheeled(0.6, 1.0, 1.2, 0.8, 2.0))},
           {"platform_1800", platform(1.8, 1.2, wheeled(0.5, 1.2, 1.0, 0.6, 1.2))}}};
}

}  // namespace fairway::test
