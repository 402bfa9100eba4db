// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/simulation/episode.hpp"
#include "simulation/run_control.hpp"
#include "simulation/run_scenario.hpp"
#include "simulation/trace_array.hpp"

namespace fairway::python {

namespace {

py::dict status_counts(const RobotResult& robot) {
  py::dict counts;
  for (std::size_t i = 0; i < robot.status_counts.size(); ++i) {
    if (robot.status_counts[i] > 0)
      counts[py::cast(static_cast<NavigationStatus>(i))] = robot.status_counts[i];
  }
  return counts;
}

template <std::vector<double> RobotResult::*kTimes>
py::array_t<double> seconds(const RobotResult& robot) {
  const std::vector<double>& times = robot.*kTimes;
  return py::array_t<double>(static_cast<py::ssize_t>(times.size()), times.data());
}

}  // namespace

void bind_episode(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(TraceRecord, time, x, y, heading, linear, angular, command_linear,
                       command_angular, clearance, robot, status, limit, rectangle);
  py::class_<RobotResult>(module, "RobotResult", "The result of one robot.")
      .def_readonly("name", &RobotResult::name, "Name of the robot.")
      .def_readonly("reached", &RobotResult::reached, "Whether it has stopped at its goal.")
      .def_readonly("collided", &RobotResult::collided,
                    "Whether it touched something, judged by the simulator.")
      .def_readonly("time", &RobotResult::time,
                    "When it stopped at the goal, or when the run ended [s].")
      .def_readonly("length", &RobotResult::length, "Of the driven path [m].")
      .def_readonly("min_clearance", &RobotResult::min_clearance,
                    "Least distance from the body to static obstacles [m].")
      .def_readonly("min_separation", &RobotResult::min_separation,
                    "Least distance to other bodies; infinite when alone [m].")
      .def_readonly("cycles", &RobotResult::cycles, "Number of control cycles.")
      .def_property_readonly("status_counts", &status_counts, "Number of cycles per status.")
      .def_property_readonly("cycle_seconds", &seconds<&RobotResult::cycle_seconds>,
                             "Computing time of each cycle [s].")
      .def_property_readonly("solve_seconds", &seconds<&RobotResult::solve_seconds>,
                             "Of these, the time in the solver [s].")
      .def_readonly("plan", &RobotResult::plan, "The last plan that the robot followed.");

  py::class_<EpisodeResult>(module, "Episode", "The result of a whole run.")
      .def_readonly("success", &EpisodeResult::success,
                    "Whether every robot reached its goal and none touched anything.")
      .def_readonly("time", &EpisodeResult::time, "Simulated [s].")
      .def_readonly("robots", &EpisodeResult::robots, "Results of the robots.")
      .def_property_readonly(
          "trace", &trace_array,
          "A structured array with one row per robot and cycle: time, robot, x, y, heading, "
          "linear, angular (true motion), command_linear, command_angular, status, limit, "
          "rectangle, clearance.");

  bind_run_control(module);
  module.def("simulate", &run_scenario, py::arg("scenario"), py::kw_only(),
             py::arg("on_cycle") = py::none(), py::arg("on_plan") = py::none(),
             py::arg("on_step") = py::none(), py::arg("play") = py::none(),
             py::arg("log") = py::none(), py::arg("report") = py::none(),
             "Runs a scenario until every robot has stopped at its goal or collided, or the time "
             "is up. on_cycle(time), after every cycle, ends the run by returning False. "
             "on_plan(time, robot, plan) and on_step(time, robot, pose, twist, step) receive what "
             "the robots do. play(control) may change the run and ends it by returning False; it "
             "then has no time limit and no trace. `log` names a recording for `replay`, `report` "
             "a page that plays the run.");
}

}  // namespace fairway::python
