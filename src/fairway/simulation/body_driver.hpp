// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/simulation/robot_driver.hpp"

namespace fairway {

/// Makes the driver of a robot with a model, a BodyNavigator: it knows the map, its pose and all
/// moving obstacles, or only its lidar scans and odometry. @pre the robot has a model.
[[nodiscard]] std::unique_ptr<RobotDriver> make_body_driver(const DriverContext& context,
                                                            const World& world,
                                                            std::size_t robot,
                                                            RobotResult& result);

}  // namespace fairway
