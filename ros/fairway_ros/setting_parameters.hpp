// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dynamic_reconfigure/Reconfigure.h>

#include <functional>

#include <ros/node_handle.h>

#include "bridge/pilot.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::ros1 {

/// The options of a node from its private parameters, fixed at its start.
struct NodeOptions {
  bridge::PilotOptions pilot;
  std::string map_frame = "map";
  std::string base_frame = "base_link";
  bool cancel_with_client = true;  ///< a goal ends when its client disconnects
};

/// Reads every private parameter of the node: its options, `preset`, and the groups of settings.
/// They are spelled as in a settings file, so that `rosparam load` accepts such a file. A parameter
/// that is unknown, has another type or lies out of range is an error that names it.
[[nodiscard]] Expected<void> read_parameters(const ros::NodeHandle& node,
                                             NodeOptions& options,
                                             Settings& settings);

/// Settings that can be changed at run time by dynamic_reconfigure's clients. Parameters are named
/// `group.name`, with the unit, meaning and range of the settings table.
class SettingParameters {
 public:
  /// @param changed  Called with new, valid settings. Must outlive the callbacks of `node`.
  SettingParameters(ros::NodeHandle node,
                    const Settings& settings,
                    std::function<void(const Settings&)> changed);

 private:
  bool reconfigure(dynamic_reconfigure::Reconfigure::Request& request,
                   dynamic_reconfigure::Reconfigure::Response& response);
  void store() const;

  ros::NodeHandle node_;
  Settings settings_;
  std::function<void(const Settings&)> changed_;
  ros::Publisher descriptions_;
  ros::Publisher updates_;
  ros::ServiceServer service_;
};

}  // namespace fairway::ros1
