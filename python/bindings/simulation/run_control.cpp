// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_control.hpp"

#include <memory>
#include <string>
#include <vector>

#include "casters.hpp"
#include "fairway/navigation/settings.hpp"
#include "results.hpp"
#include "simulation/key_frames.hpp"

namespace fairway::python {

namespace {

std::size_t checked_index(std::size_t index, std::size_t count, const char* name) {
  if (index >= count) {
    refuse(name, "an index below " + std::to_string(count), py::int_(index));
  }
  return index;
}

void set_goal_of(const RunControl& run, std::size_t robot, const Goal& goal) {
  EpisodeControl& control = run.get();
  control.set_goal(checked_index(robot, control.world().robots().size(), "robot"), goal);
}

void set_cells_of(const RunControl& run, const py::object& cells, bool blocked) {
  const NumberTable table = read_table(cells, "cells", 2);
  std::vector<CellIndex> list;
  for (std::size_t i = 0; i < table.rows; ++i) {
    const double* const n = table.row(i);
    // Cells outside the map are skipped; a number that is no index lies outside.
    const auto index = [](double value) {
      return value >= 0.0 && value < OccupancyGrid::kMaxSide ? static_cast<int>(value) : -1;
    };
    list.push_back({.x = index(n[1]), .y = index(n[0])});
  }
  run.get().set_cells(list, blocked);
}

void set_obstacle(const RunControl& run,
                  std::size_t index,
                  const py::object& key_frames,
                  double radius,
                  bool loop) {
  EpisodeControl& control = run.get();
  checked_index(index, control.world().num_bodies() + 1, "index");
  control.set_body(index, make_body(key_frames, radius, "obstacle", loop, false));
}

void remove_obstacle(const RunControl& run, std::size_t index) {
  EpisodeControl& control = run.get();
  control.remove_body(checked_index(index, control.world().num_bodies(), "index"));
}

py::array_t<double> true_poses(const RunControl& run) {
  const std::vector<UnicycleRobot>& robots = run.get().world().robots();
  py::array_t<double> array = new_table(robots.size(), 3);
  double* out = array.mutable_data();
  for (const UnicycleRobot& robot : robots) {
    *out++ = robot.pose.position.x();
    *out++ = robot.pose.position.y();
    *out++ = robot.pose.heading;
  }
  return array;
}

py::array_t<double> obstacles_now(const RunControl& run) {
  std::vector<MovingObstacle> seen;
  run.get().world().moving_bodies(seen);
  return obstacles_array(seen);
}

}  // namespace

void bind_run_control(py::module_& module) {
  py::class_<RunControl, std::shared_ptr<RunControl>>(
      module, "RunControl", "The run as a callback of `simulate` sees it, during the call only.")
      .def_property_readonly(
          "time", [](const RunControl& run) { return run.get().world().time(); },
          "Time of the run [s].")
      .def_property_readonly("poses", &true_poses, "True pose of each robot: x, y, heading.")
      .def_property_readonly("obstacles", &obstacles_now,
                             "Moving obstacles: x, y, velocity in x and y, radius.")
      .def("set_goal", &set_goal_of, py::arg("robot"), py::arg("goal"), "Gives a robot a new goal.")
      .def("set_cells", &set_cells_of, py::arg("cells"), py::arg("blocked"),
           "Makes cells obstacles, or free: n x 2, row and column. Cells under a robot do not "
           "become obstacles.")
      .def("set_obstacle", &set_obstacle, py::arg("index"), py::arg("key_frames"),
           py::arg("radius") = 0.3, py::arg("loop") = false,
           "Replaces the motion of a moving obstacle; the index after the last adds one.")
      .def("remove_obstacle", &remove_obstacle, py::arg("index"),
           "Removes a moving obstacle; the indices after it decrease by one.")
      .def(
          "set_settings",
          [](const RunControl& run, const Settings& settings) {
            run.get().set_settings(checked(settings));
          },
          py::arg("settings"), "Continues with other settings.");
}

}  // namespace fairway::python
