// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>
#include <utility>

#include "navigation/shared_navigator.hpp"
#include "navigation/zone_list.hpp"

namespace fairway::python {

template <typename Navigator>
Step update(SharedNavigator<Navigator>& self,
            double time,
            const Pose2& pose,
            const py::object& obstacles,
            const py::object& fleet,
            std::uint32_t robot,
            const std::optional<double>& pose_time,
            const std::optional<double>& obstacles_time,
            bool obstacles_due,
            const std::optional<double>& map_time) {
  OwnedMeasurements owned{.measurements = {.time = time,
                                           .pose = pose,
                                           .pose_time = pose_time,
                                           .obstacles_time = obstacles_time,
                                           .obstacles_due = obstacles_due,
                                           .map_time = map_time,
                                           .robot = robot},
                          .obstacles = {},
                          .motions = {},
                          .fleet = {}};
  owned.read(obstacles, fleet);
  return self.run([&](Navigator& n) { return Step(n.update(owned.measurements)); });
}

template <typename Navigator>
bool observe(SharedNavigator<Navigator>& self,
             double time,
             const py::object& ranges,
             const Pose2& pose,
             double first_angle,
             const std::optional<double>& angle_step,
             double min_range,
             double max_range,
             const std::optional<Pose2>& last_pose,
             const std::optional<Eigen::Vector2d>& position) {
  const Scan scan = make_scan(time, ranges, pose, first_angle, angle_step, {min_range, max_range},
                              last_pose, position);
  return self.run([&](Navigator& n) { return n.observe(scan.scan, scan.position); });
}

template <typename Navigator>
py::array_t<double> tracked(SharedNavigator<Navigator>& self) {
  const auto copied = self.run([](Navigator& n) {
    return std::vector<MovingObstacle>(n.tracked().begin(), n.tracked().end());
  });
  return obstacles_array(copied);
}

/// Adds the calls that both navigators have.
template <typename Navigator>
void bind_navigator_calls(py::class_<SharedNavigator<Navigator>>& type) {
  using Shared = SharedNavigator<Navigator>;
  type.def(
          "set_goal",
          [](Shared& self, double x, double y, const std::optional<double>& heading) {
            self.run([&](Navigator& n) { n.set_goal({.position = {x, y}, .heading = heading}); });
          },
          py::arg("x"), py::arg("y"), py::arg("heading") = py::none(),
          "Sets the goal [m, m, rad], or replaces it. Without a heading every heading will do.")
      .def(
          "follow",
          [](Shared& self, const Path& path, const std::optional<double>& heading) {
            self.run([&](Navigator& n) { n.follow(path, heading); });
          },
          py::arg("path"), py::arg("heading") = py::none(),
          "Follows a path from another planner, n x 2 [m]. If the robot does not fit along it, "
          "the navigator searches its own path to the same end.")
      .def(
          "cancel", [](Shared& self) { self.run([](Navigator& n) { n.cancel(); }); },
          "Drops the goal: the robot brakes to a standstill.")
      .def(
          "set_zones",
          [](Shared& self, const py::sequence& zones) {
            const Zones read = zones_of(zones);
            self.run([&](Navigator& n) { n.set_zones(read); });
          },
          py::arg("zones"),
          "Replaces the zones. Each is a mapping with the keys of a scenario file: kind, polygon, "
          "and as the kind needs reference, speed, weight, direction, name.")
      .def(
          "hold", [](Shared& self) { self.run([](Navigator& n) { n.hold(); }); },
          "Stops the robot along its corridor and keeps it there; goal and plan are kept.")
      .def(
          "resume", [](Shared& self) { self.run([](Navigator& n) { n.resume(); }); },
          "Ends a hold.")
      .def_property_readonly(
          "on_hold",
          [](Shared& self) { return self.run([](Navigator& n) { return n.on_hold(); }); },
          "Whether the robot is on hold.")
      .def(
          "reset",
          [](Shared& self, double linear, double angular) {
            self.run([&](Navigator& n) { n.reset({.linear = linear, .angular = angular}); });
          },
          py::arg("linear") = 0.0, py::arg("angular") = 0.0,
          "Sets the actual twist, after the robot was held or moved by other means.")
      .def("observe", &observe<Navigator>, py::arg("time"), py::arg("ranges"), py::arg("pose"),
           py::kw_only(), py::arg("first_angle") = -std::numbers::pi,
           py::arg("angle_step") = py::none(), py::arg("min_range") = 0.0,
           py::arg("max_range") = 30.0, py::arg("last_pose") = py::none(),
           py::arg("position") = py::none(),
           "Processes one lidar scan, and returns whether it was taken in. `pose` is that of the "
           "sensor at the first beam, `last_pose` "
           "at the last; `position` is that of the robot. The default `angle_step` spreads the "
           "beams over a full turn. An infinite range is free up to `max_range`; NaN is invalid.")
      .def("update", &update<Navigator>, py::arg("time"), py::arg("pose"), py::kw_only(),
           py::arg("obstacles") = py::none(), py::arg("fleet") = py::none(), py::arg("robot") = 0,
           py::arg("pose_time") = py::none(), py::arg("obstacles_time") = py::none(),
           py::arg("obstacles_due") = false, py::arg("map_time") = py::none(),
           "Runs one control cycle: plans if needed, then drives. Never fails: the command is "
           "finite, within the limits, and followed by a stop that was checked.")
      .def(
          "share",
          [](Shared& self, std::uint32_t robot, double time, const Pose2& pose) {
            return self.run([&](Navigator& n) { return n.share(robot, time, pose); });
          },
          py::arg("robot"), py::arg("time"), py::arg("pose"),
          "Returns the message to the other robots of a fleet, after `update`.")
      .def_property(
          "settings",
          [](Shared& self) { return self.run([](Navigator& n) { return n.settings(); }); },
          [](Shared& self, const Settings& settings) {
            self.run([&](Navigator& n) { n.set_settings(settings); });
          },
          "A copy of the settings; assign one to change them and keep the goal.")
      .def_property_readonly(
          "plan", [](Shared& self) { return self.run([](Navigator& n) { return n.plan(); }); },
          "A copy of the plan that is followed; it may be unusable.")
      .def_property_readonly(
          "plan_is_current",
          [](Shared& self) { return self.run([](Navigator& n) { return n.plan_is_current(); }); },
          "Whether the plan is for the present goal.")
      .def_property_readonly("tracked", &tracked<Navigator>,
                             "Moving obstacles of the own lidar: x, y, velocity, radius.")
      .def(
          "wait_for_plan", [](Shared& self) { self.run([](Navigator& n) { n.wait_for_plan(); }); },
          "Waits for a plan that a thread makes (`planning.background`), in simulations.");
}

}  // namespace fairway::python
