// SPDX-License-Identifier: Apache-2.0
// The parameter file and the behaviour tree that are installed, and the examples of the documents:
// the plugins accept every parameter, and know it.
#include <array>
#include <fstream>
#include <regex>
#include <sstream>

#include <yaml-cpp/yaml.h>

#include "nav2_fairway_controller/planner.hpp"
#include "ros/nav2/plugin/plugin_rig.hpp"

namespace fairway::nav2 {
namespace {

using Parameters = std::map<std::string, rclcpp::ParameterValue>;

const std::string kRoot = FAIRWAY_SOURCE_DIR "/";
const std::string kPackage = kRoot + "ros/nav2_fairway_controller/";

std::string read(const std::string& file) {
  const std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// As ROS 2 reads a scalar: a number with a point is real, without one it is whole.
rclcpp::ParameterValue value_of(const YAML::Node& node) {
  if (node.Tag() == "!") return rclcpp::ParameterValue(node.as<std::string>());  // quoted
  if (std::int64_t whole = 0; YAML::convert<std::int64_t>::decode(node, whole)) {
    return rclcpp::ParameterValue(whole);
  }
  if (double real = 0.0; YAML::convert<double>::decode(node, real)) {
    return rclcpp::ParameterValue(real);
  }
  if (bool flag = false; YAML::convert<bool>::decode(node, flag)) {
    return rclcpp::ParameterValue(flag);
  }
  return rclcpp::ParameterValue(node.as<std::string>());
}

void flatten(const YAML::Node& node, const std::string& prefix, Parameters& parameters) {
  if (node.IsScalar()) parameters.emplace(prefix, value_of(node));
  if (!node.IsMap()) return;
  for (const auto& entry : node)
    flatten(entry.second, prefix + "." + entry.first.as<std::string>(), parameters);
}

// A rectangle with its origin near the rear.
void set_footprint(PluginRig& rig) {
  rig.ros->footprint.clear();
  for (const auto& [x, y] : {std::pair(0.6, 0.25), std::pair(0.6, -0.25), std::pair(-0.2, -0.25),
                             std::pair(-0.2, 0.25)}) {
    rig.ros->footprint.emplace_back();
    rig.ros->footprint.back().x = x;
    rig.ros->footprint.back().y = y;
  }
}

// Configures the controller with a block, and checks that each of its parameters is declared.
void expect_accepted(const YAML::Node& block) {
  ASSERT_EQ(block["plugin"].as<std::string>(), "fairway::nav2::FairwayController");
  Parameters parameters;
  flatten(block, "FollowPath", parameters);
  parameters.erase("FollowPath.plugin");  // the server reads it
  for (const char* type : {"FollowPath.obstacles_type"})
    parameters.erase(type);  // some messages have no double
  // A thread would need as long as the machine takes.
  if (const auto threads = parameters.find("FollowPath.planning.background");
      threads != parameters.end())
    threads->second = rclcpp::ParameterValue(false);
  PluginRig rig(parameters);
  set_footprint(rig);
  ASSERT_NO_THROW(rig.configure());
  for (const auto& [name, value] : parameters)
    EXPECT_TRUE(rig.node->has_parameter(name)) << name;
  rig.set_path({{1, 3}, {3, 3}});
  EXPECT_TRUE(rig.drive_to({3, 3}, 40.0)) << rig.fault;
}

constexpr std::array kFiles{"config/nav2_params.yaml", "config/nav2_params_car.yaml",
                            "config/nav2_params_rectangle.yaml"};

TEST(ShippedConfiguration, OfTheControllerIsAcceptedAndDrives) {
  for (const char* name : kFiles) {
    SCOPED_TRACE(name);
    const YAML::Node file = YAML::LoadFile(kPackage + name);
    const YAML::Node server = file["controller_server"]["ros__parameters"];
    expect_accepted(server["FollowPath"]);
    EXPECT_EQ(server["controller_frequency"].as<double>(), 10.0);
    EXPECT_EQ(server["goal_checker"]["plugin"].as<std::string>(),
              "nav2_controller::StoppedGoalChecker");
  }
}

TEST(ShippedConfiguration, OfThePlannerIsAccepted) {
  for (const char* name : kFiles) {
    SCOPED_TRACE(name);
    const YAML::Node file = YAML::LoadFile(kPackage + name);
    const YAML::Node block = file["planner_server"]["ros__parameters"]["GridBased"];
    Parameters parameters;
    flatten(block, "GridBased", parameters);
    parameters.erase("GridBased.plugin");
    PluginRig rig(parameters);
    FairwayPlanner planner;
    ASSERT_NO_THROW(planner.configure(rig.node, "GridBased", rig.transforms, rig.ros));
    for (const auto& [parameter, value] : parameters)
      EXPECT_TRUE(rig.node->has_parameter(parameter)) << parameter;
  }
}

TEST(ShippedConfiguration, OfTheBehaviorTreeNamesThePluginsOfTheParameterFile) {
  const YAML::Node file = YAML::LoadFile(kPackage + "config/nav2_params.yaml");
  const YAML::Node controllers = file["controller_server"]["ros__parameters"];
  const YAML::Node planners = file["planner_server"]["ros__parameters"];
  const std::string tree = read(kPackage + "behavior_trees/navigate_with_fairway.xml");
  const auto attribute = [&](const std::string& name) {
    std::smatch found;
    return std::regex_search(tree, found, std::regex(name + "=\"([^\"]+)\"")) ? found[1].str() : "";
  };
  EXPECT_EQ(controllers["controller_plugins"][0].as<std::string>(), attribute("controller_id"));
  EXPECT_EQ(controllers["goal_checker_plugins"][0].as<std::string>(), attribute("goal_checker_id"));
  EXPECT_EQ(planners["planner_plugins"][0].as<std::string>(), attribute("planner_id"));
  const std::string plugins = read(kPackage + "plugins.xml");
  for (const YAML::Node& block : {controllers["FollowPath"], planners["GridBased"]})
    EXPECT_NE(plugins.find(block["plugin"].as<std::string>()), std::string::npos);
}

TEST(ShippedConfiguration, OfTheDocumentsIsAcceptedAndDrives) {
  int blocks = 0;
  for (const char* page : {"docs/how_to/replace_a_nav2_controller.md", "docs/ros.md"}) {
    const std::string text = read(kRoot + page);
    const std::string begin = "```yaml\nFollowPath:";
    for (std::size_t at = text.find(begin); at != std::string::npos;
         at = text.find(begin, at + 1)) {
      SCOPED_TRACE(std::string(page) + " at byte " + std::to_string(at));
      const std::size_t first = at + 8;
      expect_accepted(
          YAML::Load(text.substr(first, text.find("```", first) - first))["FollowPath"]);
      ++blocks;
    }
  }
  EXPECT_EQ(blocks, 8);
}

}  // namespace
}  // namespace fairway::nav2
