// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rclcpp/rclcpp.hpp>

#include "nav2_fairway_controller/nav2_versions.hpp"
#include "nav2_fairway_controller/setting_store.hpp"

namespace fairway::nav2 {

/// The settings of one plugin as parameters of its node: `PLUGIN.group.name`, each with its
/// meaning, unit and range, and changeable at run time.
class Parameters {
 public:
  /// Declares all parameters and reads the node's values.
  /// @param frequency  Frequency of the server that calls the plugin [Hz]; none for a planner,
  /// which has no settings of the group `following`.
  /// @throws ControllerSetupError when a value is wrong; the message names the parameter.
  Parameters(std::shared_ptr<LifecycleNode> node,
             const std::string& plugin,
             const std::optional<double>& frequency);

  /// The current settings.
  [[nodiscard]] FollowerSettings settings() const { return store_.settings(); }

  /// The settings, once after each change that the node has accepted.
  [[nodiscard]] std::optional<FollowerSettings> take_change();

 private:
  [[nodiscard]] std::string fault_of(const std::vector<rclcpp::Parameter>& changes);

  std::shared_ptr<LifecycleNode> node_;
  std::string prefix_;
  std::optional<double> frequency_;
  SettingStore store_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr callback_;
};

/// Reads a text that is fixed while the plugin is configured.
[[nodiscard]] std::string read_text(LifecycleNode& node,
                                    const std::string& name,
                                    const std::string& otherwise,
                                    const std::string& meaning);

/// Reads a switch that is fixed while the plugin is configured.
[[nodiscard]] bool read_switch(LifecycleNode& node,
                               const std::string& name,
                               bool otherwise,
                               const std::string& meaning);

}  // namespace fairway::nav2
