// SPDX-License-Identifier: Apache-2.0
// Not Nav2: by hand.
#pragma once

#include "ros2_double.hpp"

namespace nav2 {
class LifecycleNode : public rclcpp_lifecycle::LifecycleNode {
 public:
  using WeakPtr = std::weak_ptr<LifecycleNode>;
};
}  // namespace nav2
