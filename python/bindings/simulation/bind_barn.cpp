// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>
#include <vector>

#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "casters.hpp"
#include "experiments/barn/barn_file.hpp"
#include "experiments/solver/ocp_instances.hpp"
#include "results.hpp"

namespace fairway::python {

namespace {

Scenario scenario_of(const BarnWorld& world,
                     const std::optional<Settings>& settings,
                     const std::string& sensing,
                     std::uint64_t seed,
                     int trial) {
  if (sensing != "map" && sensing != "lidar") refuse("sensing", "map or lidar", py::str(sensing));
  BarnOptions options;
  use_jackal(options.settings);
  if (settings) options.settings = *settings;
  options.sensing.sensing = sensing == "map" ? Sensing::Map : Sensing::Lidar;
  options.seed = seed;
  return barn_scenario(world, options, trial);
}

Settings jackal_settings() {
  Settings settings;
  use_jackal(settings);
  return settings;
}

BarnScore score_of(const BarnWorld& world, int trial, const EpisodeResult& result) {
  if (result.robots.empty()) throw py::value_error("result: expected a robot, found none");
  return barn_score(world, trial, result);
}

std::vector<BarnWorld> read_worlds(const std::filesystem::path& path,
                                   const std::vector<int>& worlds) {
  return value_of(without_gil([&] {
    return path.extension() == ".json" ? io::read_dynabarn(path.string(), worlds)
                                       : io::read_barn(path.string(), worlds);
  }));
}

std::vector<ControlProblem> read_problems(const std::filesystem::path& path) {
  std::vector<ControlProblem> problems;
  for (const io::OcpInstance& instance : value_of(io::read_ocp_instances(path.string())))
    problems.push_back(io::control_problem(instance));
  return problems;
}

}  // namespace

void bind_barn(py::module_& module) {
  py::class_<BarnWorld>(module, "BarnWorld", "One world of the BARN or DynaBARN dataset.")
      .def_readonly("number", &BarnWorld::number, "Number of the world in BARN.")
      .def_readonly("map", &BarnWorld::map, "Its map.")
      .def_readonly("start", &BarnWorld::start, "x, y [m], heading [rad].")
      .def_readonly("goal", &BarnWorld::goal, "x, y [m].")
      .def_readonly("optimal_time", &BarnWorld::optimal_time,
                    "Length of the reference path at 2 m/s [s].")
      .def("scenario", &scenario_of, py::arg("settings") = py::none(), py::arg("sensing") = "map",
           py::arg("seed") = 1, py::arg("trial") = 0,
           "Returns the scenario of one trial; the default settings are `jackal_settings()`.")
      .def("score", &score_of, py::arg("trial"), py::arg("result"), kBarnNote);
  py::class_<BarnScore>(module, "BarnScore", kBarnNote)
      .def_readonly("world", &BarnScore::world, "Number of the world.")
      .def_readonly("trial", &BarnScore::trial, "Number of the run in this world.")
      .def_readonly("success", &BarnScore::success,
                    "Whether the robot reached the goal in time without a contact.")
      .def_readonly("collided", &BarnScore::collided, "Whether the robot touched an obstacle.")
      .def_readonly("time", &BarnScore::time, "From the first motion to the arrival [s].")
      .def_readonly("score", &BarnScore::score, "At most 0.5.");
  module.def("jackal_settings", &jackal_settings, "Settings of the robot of the BARN challenge.");
  module.def("read_barn", &read_worlds, py::arg("path"), py::arg("worlds") = std::vector<int>{},
             "Reads worlds of BARN (a folder) or DynaBARN (a .json file); all without `worlds`.");
  module.def("read_problems", &read_problems, py::arg("path"),
             "Reads instances of the control problem, as `fairway solve` does.");
}

}  // namespace fairway::python
