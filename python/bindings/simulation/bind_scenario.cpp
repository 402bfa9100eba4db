// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>

#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/simulation/scenario.hpp"
#include "results.hpp"
#include "simulation/key_frames.hpp"

namespace fairway::python {

namespace {

Scenario read_scenario_file(const std::filesystem::path& path) {
  io::FileNotes notes;
  Scenario scenario =
      value_of(without_gil([&] { return io::read_scenario(path.string(), &notes); }));
  warn(notes);
  return scenario;
}

Scenario make_scenario(const OccupancyGrid& map, const std::optional<Settings>& settings) {
  Scenario scenario;
  scenario.map = map;
  scenario.settings = settings.value_or(Settings{});
  return scenario;
}

// One of the names of an enumeration of settings.
template <typename Value>
Value choice(const char* key, const std::string& name) {
  const auto names = setting_names(Value{});
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i]) return static_cast<Value>(i);
  }
  refuse(key, std::string(names[0]) + " or " + names[1], py::str(name));
}

template <typename Value>
const char* name_of(Value value) {
  return setting_names(value)[static_cast<std::size_t>(value)];
}

}  // namespace

void bind_scenario(py::module_& module) {
  py::class_<Scenario>(module, "Scenario",
                       "Everything that a simulated run depends on: equal scenarios give equal "
                       "bits.")
      .def(py::init(&make_scenario), py::arg("map"), py::arg("settings") = py::none())
      .def_static("read", &read_scenario_file, py::arg("path"),
                  "Reads a scenario and the map that it names.")
      .def_readwrite("name", &Scenario::name, "Name of the scenario.")
      .def_readwrite("map", &Scenario::map, "The true map.")
      .def_readwrite("settings", &Scenario::settings, "Of every robot.")
      .def_readwrite("time_limit", &Scenario::time_limit, "The run ends at this time [s].")
      .def_readwrite("seed", &Scenario::seed, "Of all random numbers.")
      .def_property(
          "sensing", [](const Scenario& s) { return name_of(s.sensing.sensing); },
          [](Scenario& s, const std::string& name) {
            s.sensing.sensing = choice<Sensing>("sensing", name);
          },
          "map: a robot knows its pose, the map and all moving obstacles; lidar: only its scans "
          "and odometry.")
      .def_property(
          "noise", [](const Scenario& s) { return name_of(noise_of(s.sensing)); },
          [](Scenario& s, const std::string& name) {
            use_noise(s.sensing, choice<SensorNoise>("noise", name));
          },
          "Errors of lidar and odometry: none or standard.")
      .def(
          "add_robot",
          [](Scenario& s, const Pose2& start, const Goal& goal, const std::string& name) {
            s.robots.push_back({.name = name, .start = start, .goal = goal});
          },
          py::arg("start"), py::arg("goal"), py::arg("name") = "robot",
          "Adds a robot with its start (x, y, heading) and its goal.")
      .def(
          "add_obstacle",
          [](Scenario& s, const py::object& key_frames, double radius, const std::string& name,
             bool loop, bool passing) {
            s.bodies.push_back(make_body(key_frames, radius, name, loop, passing));
          },
          py::arg("key_frames"), py::arg("radius") = 0.3, py::arg("name") = "person",
          py::arg("loop") = false, py::arg("passing") = false,
          "Adds a disc that moves along key frames: time [s], x, y [m], n x 3. One frame: it does "
          "not move. `passing`: it is present only from the first frame to the last.")
      .def_property_readonly(
          "robots",
          [](const Scenario& s) {
            py::list robots;
            for (const RobotTask& task : s.robots)
              robots.append(py::make_tuple(task.name, task.start, task.goal));
            return robots;
          },
          "Name, start and goal of each robot.")
      .def_property_readonly(
          "num_obstacles", [](const Scenario& s) { return s.bodies.size(); },
          "Number of moving obstacles.");
}

}  // namespace fairway::python
