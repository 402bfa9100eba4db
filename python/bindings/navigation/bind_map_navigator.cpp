// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "navigation/navigator_calls.hpp"

namespace fairway::python {

namespace {

using SharedMapNavigator = SharedNavigator<MapNavigator>;

std::unique_ptr<SharedMapNavigator> make_map_navigator(const Settings& settings,
                                                       const OccupancyGrid* map) {
  const py::gil_scoped_release release;
  return map != nullptr ? std::make_unique<SharedMapNavigator>(settings, *map)
                        : std::make_unique<SharedMapNavigator>(settings);
}

py::object blocked_cells(SharedMapNavigator& self) {
  const std::optional<BitGrid> grid = self.run([](MapNavigator& n) {
    return n.obstacles() != nullptr ? std::optional<BitGrid>(*n.obstacles()) : std::nullopt;
  });
  if (!grid) return py::none();
  const GridFrame& frame = grid->frame();
  py::array_t<bool> array({frame.height, frame.width});
  bool* out = array.mutable_data();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x)
      *out++ = grid->blocked({.x = x, .y = y});
  }
  return array;
}

}  // namespace

void bind_map_navigator(py::module_& module) {
  py::class_<SharedMotion>(module, "SharedMotion",
                           "What a robot publishes to the others of its fleet in every cycle.")
      .def_readonly("robot", &SharedMotion::robot, "Number of the robot.")
      .def_readonly("time", &SharedMotion::time, "Time of the message [s].")
      .def_readonly("position", &SharedMotion::position, "Position of the robot [m].")
      .def_readonly("speed", &SharedMotion::speed, "Speed of the robot [m/s].")
      .def_readonly("radius", &SharedMotion::radius, "Radius of the disc around the robot [m].");

  py::class_<SharedMapNavigator> type(
      module, "MapNavigator",
      "Drives one robot to a goal, or along a path, on a map that may change.");
  type.def(py::init(&make_map_navigator), py::arg("settings"), py::arg("map") = py::none(),
           "Raises a ValueError if the settings are invalid. Without a map the robot stays "
           "stopped.");
  bind_navigator_calls(type);
  type.def(
          "set_map",
          [](SharedMapNavigator& self, const OccupancyGrid& map) {
            self.run([&](MapNavigator& n) { n.set_map(map); });
          },
          py::arg("map"), "Replaces the map; the new one may have another frame.")
      .def(
          "update_map",
          [](SharedMapNavigator& self, const OccupancyGrid& map, std::pair<int, int> first,
             std::pair<int, int> last) {
            self.run([&](MapNavigator& n) {
              n.update_map(map, {.x = first.second, .y = first.first},
                           {.x = last.second, .y = last.first});
            });
          },
          py::arg("map"), py::arg("first"), py::arg("last"),
          "Updates the map inside a window of cells, both corners (row, column) included.")
      .def_property_readonly("obstacles", &blocked_cells,
                             "Cells of the map that are blocked, those of scans included; "
                             "bool[row, column], or None without a map.")
      .def_property_readonly(
          "explanation",
          [](SharedMapNavigator& self) {
            return self.run([](MapNavigator& n) { return n.explanation(); });
          },
          "Why there is no path, in one sentence with numbers; empty while there is one, and "
          "without `planning.background`. Planner.explain has it at any time.");
}

}  // namespace fairway::python
