// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway/navigation/body/body_navigator.hpp"
#include "navigation/navigator_calls.hpp"
#include "results.hpp"

namespace fairway::python {

namespace {

using SharedBodyNavigator = SharedNavigator<BodyNavigator>;

std::unique_ptr<SharedBodyNavigator> make_body_navigator(const Settings& settings,
                                                         const RobotModel& robot,
                                                         const OccupancyGrid* map) {
  const py::gil_scoped_release release;
  return map != nullptr ? std::make_unique<SharedBodyNavigator>(settings, robot, *map)
                        : std::make_unique<SharedBodyNavigator>(settings, robot);
}

// JSON is YAML, so that the keys of a file are read from a mapping by the same reader.
RobotModel model_of(const py::dict& keys) {
  const auto text = py::module_::import("json").attr("dumps")(keys).cast<std::string>();
  return value_of(io::parse_robot_model(text, "robot"));
}

py::array_t<double> outline_of(const RobotModel& robot) {
  std::vector<Eigen::Vector2d> points;
  for (const ConvexPart& part : robot.body.parts()) {
    for (int i = 0; i < part.count; ++i)
      points.push_back(part.vertex(i));
  }
  return points_array(points);
}

// The pose after a command was executed, for simulations that need no acceleration.
Pose2 pose_after(const RobotModel& /*robot*/,
                 const Pose2& pose,
                 const py::object& command,
                 double seconds) {
  std::array<double, 3> n{};
  read_numbers(command, "command", "linear, lateral, angular", 3, n);
  return moved(pose, {.linear = n[0], .lateral = n[1], .angular = n[2]}, seconds);
}

void bind_robot_model(py::module_& module) {
  py::class_<RobotModel>(module, "RobotModel",
                         "A robot with its true outline and its own kind of base.")
      .def(py::init(&model_of), py::arg("keys"),
           "Makes a model from a mapping with the keys of a robot file: kind, length, width, "
           "linear_max and so on.")
      .def_static(
          "read",
          [](const std::filesystem::path& path) {
            return value_of(without_gil([&] { return io::read_robot_model(path.string()); }));
          },
          py::arg("path"), "Reads a robot file, such as those in scenarios/robots.")
      .def_property_readonly(
          "kind", [](const RobotModel& robot) { return to_text(robot.base.kind); },
          "unicycle, car, tricycle or omni.")
      .def_property_readonly("outline", &outline_of,
                             "Corners of the outline about the reference point, n x 2 [m].")
      .def("moved", &pose_after, py::arg("pose"), py::arg("command"), py::arg("seconds"),
           "Returns the pose after a constant command (linear, lateral, angular).");
}

}  // namespace

void bind_body_navigator(py::module_& module) {
  bind_robot_model(module);
  py::class_<SharedBodyNavigator>(
      module, "BodyNavigator",
      "Drives a robot of any outline on any base to a goal on a map: long platforms, cars, "
      "tricycles, mecanum and swerve bases.")
      .def(py::init(&make_body_navigator), py::arg("settings"), py::arg("robot"),
           py::arg("map") = py::none(),
           "Raises a ValueError if settings or robot are invalid. Without a map the robot stays "
           "stopped.")
      .def(
          "set_map",
          [](SharedBodyNavigator& self, const OccupancyGrid& map) {
            self.run([&](BodyNavigator& n) { n.set_map(map); });
          },
          py::arg("map"), "Replaces the map; the new one may have another frame.")
      .def(
          "set_goal",
          [](SharedBodyNavigator& self, double x, double y, const std::optional<double>& heading) {
            self.run([&](BodyNavigator& n) {
              n.set_goal({.position = {x, y}, .heading = heading});
            });
          },
          py::arg("x"), py::arg("y"), py::arg("heading") = py::none(),
          "Sets the goal of the reference point [m, m, rad], or replaces it. Without a heading, "
          "one in which the robot fits is selected.")
      .def(
          "set_zones",
          [](SharedBodyNavigator& self, const py::sequence& zones) {
            const Zones read = zones_of(zones);
            self.run([&](BodyNavigator& n) { n.set_zones(read); });
          },
          py::arg("zones"),
          "Replaces the zones, as MapNavigator.set_zones; they hold for the true outline.")
      .def(
          "cancel",
          [](SharedBodyNavigator& self) { self.run([](BodyNavigator& n) { n.cancel(); }); },
          "Drops the goal: the robot brakes to a standstill.")
      .def(
          "reset",
          [](SharedBodyNavigator& self, double linear, double lateral, double angular,
             double steering) {
            self.run([&](BodyNavigator& n) {
              n.reset({.linear = linear, .lateral = lateral, .angular = angular}, steering);
            });
          },
          py::arg("linear") = 0.0, py::arg("lateral") = 0.0, py::arg("angular") = 0.0,
          py::arg("steering") = 0.0,
          "Sets the actual motion, after the robot was moved by other means; `steering` is the "
          "angle of the steered wheel of a car or tricycle [rad].")
      .def(
          "observe", &observe<BodyNavigator>, py::arg("time"), py::arg("ranges"), py::arg("pose"),
          py::kw_only(), py::arg("first_angle") = -std::numbers::pi,
          py::arg("angle_step") = py::none(), py::arg("min_range") = 0.0,
          py::arg("max_range") = 30.0, py::arg("last_pose") = py::none(),
          py::arg("position") = py::none(),
          "Processes one lidar scan, as MapNavigator.observe; without a map the robot drives on "
          "its scans. Give `position`, that of the reference point, where the sensor is elsewhere.")
      .def("update", &update<BodyNavigator>, py::arg("time"), py::arg("pose"), py::kw_only(),
           py::arg("obstacles") = py::none(), py::arg("fleet") = py::none(), py::arg("robot") = 0,
           py::arg("pose_time") = py::none(), py::arg("obstacles_time") = py::none(),
           py::arg("obstacles_due") = false, py::arg("map_time") = py::none(),
           "Runs one control cycle: plans if needed, then drives. Never fails: the command is "
           "finite, within the limits of the base, and followed by a stop that was checked.")
      .def(
          "share",
          [](SharedBodyNavigator& self, std::uint32_t robot, double time, const Pose2& pose) {
            return self.run([&](BodyNavigator& n) { return n.share(robot, time, pose); });
          },
          py::arg("robot"), py::arg("time"), py::arg("pose"),
          "Returns the message to the other robots of a fleet, after `update`.")
      .def_property_readonly(
          "settings",
          [](SharedBodyNavigator& self) {
            return self.run([](BodyNavigator& n) { return n.settings(); });
          },
          "A copy of the settings.")
      .def_property_readonly(
          "robot",
          [](SharedBodyNavigator& self) {
            return self.run([](BodyNavigator& n) { return n.robot(); });
          },
          "A copy of the robot model.")
      .def_property_readonly(
          "plan",
          [](SharedBodyNavigator& self) {
            return self.run([](BodyNavigator& n) { return n.plan(); });
          },
          "A copy of the plan that is followed: the path of the reference point.")
      .def_property_readonly("tracked", &tracked<BodyNavigator>,
                             "Moving obstacles of the own lidar: x, y, velocity, radius.")
      .def(
          "wait_for_plan",
          [](SharedBodyNavigator& self) { self.run([](BodyNavigator& n) { n.wait_for_plan(); }); },
          "Waits for a plan that a thread makes (`planning.background`), in simulations.");
}

}  // namespace fairway::python
