// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <rclcpp/rclcpp.hpp>

#include "fairway/navigation/settings.hpp"
#include "nav2_fairway_controller/nav2_versions.hpp"

namespace fairway::nav2 {

/// The settings of one plugin as parameters of its node: `PLUGIN.group.name`, each with its
/// meaning, unit and range, and changeable at run time.
class Parameters {
 public:
  /// Declares all parameters and reads the node's values.
  /// @throws ControllerSetupError when the values are inconsistent; the message names the
  /// parameter.
  Parameters(std::shared_ptr<LifecycleNode> node, std::string plugin);

  /// The current settings.
  [[nodiscard]] Settings settings() const;

  /// The settings, once after each change.
  [[nodiscard]] std::optional<Settings> take_change();

 private:
  rcl_interfaces::msg::SetParametersResult on_change(const std::vector<rclcpp::Parameter>& changes);

  std::string prefix_;
  mutable std::mutex mutex_;  // callbacks come from the executor's threads
  Settings settings_;
  bool changed_ = false;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr callback_;
};

}  // namespace fairway::nav2
