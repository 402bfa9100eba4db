// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/path_obstruction.hpp"
#include "fairway/planning/planner.hpp"
#include "results.hpp"

namespace fairway::python {

namespace {

/// A planner with the map that it plans on, so that the map is prepared once.
class MapPlanner {
 public:
  MapPlanner(const OccupancyGrid& map, const std::optional<Settings>& settings)
      : settings_(checked(settings.value_or(Settings{}))),
        map_(map, unknown_cells(settings_.map)) {}

  [[nodiscard]] Plan plan(const Goal& start, const Goal& goal) {
    const py::gil_scoped_release release;
    // A planner reuses its memory: one for each call, since several threads may hold this object.
    return Planner().plan(map_, start.position, goal, planner_settings(settings_));
  }

  [[nodiscard]] std::optional<PathObstruction> find_obstruction(const Goal& start,
                                                                const Plan& plan) const {
    const py::gil_scoped_release release;
    return fairway::find_obstruction(map_, start.position, plan,
                                     planner_settings(settings_).radius);
  }

  [[nodiscard]] std::string explain(const Goal& start, const Plan& plan) const {
    const py::gil_scoped_release release;
    return fairway::explain(map_, start.position, plan, planner_settings(settings_).radius);
  }

 private:
  Settings settings_;
  PreparedMap map_;
};

void bind_path_status(py::module_& module) {
  using enum PathStatus;
  py::enum_<PathStatus>(module, "PathStatus", "Result of a path search.")
      .value("Found", Found)
      .value("StartOutsideMap", StartOutsideMap)
      .value("GoalOutsideMap", GoalOutsideMap)
      .value("StartBlocked", StartBlocked)
      .value("GoalBlocked", GoalBlocked)
      .value("NoConnection", NoConnection)
      .value("InvalidInput", InvalidInput)
      .def_property_readonly(
          "text", [](PathStatus status) { return to_text(status); },
          "As files of the tool write it.");
}

}  // namespace

void bind_plan(py::module_& module) {
  bind_path_status(module);
  py::class_<Plan>(module, "Plan", "A path to a goal and its corridor, or why there is none.")
      .def_property_readonly("usable", &Plan::usable, "Whether there is a path and a corridor.")
      .def_property_readonly("reason", &Plan::reason,
                             "Explains to the user why the plan is not usable.")
      .def_readonly("path_status", &Plan::path_status, "What became of the search of a path.")
      .def_readonly("corridor_status", &Plan::corridor_status,
                    "What became of the corridor along it.")
      .def_readonly("path", &Plan::path, "Waypoints from start to goal, n x 2 [m].")
      .def_property_readonly(
          "length", [](const Plan& plan) { return plan.path.length(); }, "Of the path [m].")
      .def_readonly("corridor", &Plan::corridor, "The rectangles along the path.")
      .def_property_readonly(
          "rectangles", [](const Plan& plan) { return plan.corridor.rectangles; },
          "Those of the corridor, in travel order.")
      .def_readonly("goal", &Plan::goal, "Where the plan ends: (x, y) or (x, y, heading).")
      .def_readonly("whole", &Plan::whole, "Whether the corridor covers the whole path.")
      .def_readonly("margin", &Plan::margin, "Clearance of the path beyond the robot's radius [m].")
      .def_readonly("stuck_at", &Plan::stuck_at,
                    "Arc length at which building the corridor stopped, if it did [m].");

  py::class_<PathObstruction>(module, "PathObstruction",
                              "The obstruction that keeps a robot from its goal.")
      .def_property_readonly(
          "kind", [](const PathObstruction& o) { return to_text(o.kind); },
          "\"start clearance\", \"goal clearance\", \"narrow gap\" or \"closed route\".")
      .def_readonly("position", &PathObstruction::position, "Its place on the map [m].")
      .def_readonly("found", &PathObstruction::found,
                    "Distance to the nearest obstacle, or width of the gap [m].")
      .def_readonly("needed", &PathObstruction::needed, "The same, as the robot needs it [m].");

  py::class_<MapPlanner>(module, "Planner", "Plans on one map, which is prepared once.")
      .def(py::init<const OccupancyGrid&, const std::optional<Settings>&>(), py::arg("map"),
           py::arg("settings") = py::none(), py::call_guard<py::gil_scoped_release>())
      .def("plan", &MapPlanner::plan, py::arg("start"), py::arg("goal"),
           "Finds a path from (x, y) to (x, y) or (x, y, heading), and its corridor. Always "
           "returns a plan; `usable` and `reason` say what became of it.")
      .def("find_obstruction", &MapPlanner::find_obstruction, py::arg("start"), py::arg("plan"),
           "Finds the obstruction because of which a plan of this planner has no path, or None. "
           "Reads the whole map: not for a control cycle.")
      .def("explain", &MapPlanner::explain, py::arg("start"), py::arg("plan"),
           "Says why a plan of this planner has no path, in one sentence with numbers; empty if "
           "it has one.");
  module.def(
      "plan",
      [](const OccupancyGrid& map, const Goal& start, const Goal& goal,
         const std::optional<Settings>& settings) {
        return without_gil([&] { return MapPlanner(map, settings); }).plan(start, goal);
      },
      py::arg("map"), py::arg("start"), py::arg("goal"), py::arg("settings") = py::none(),
      "Finds a path and its corridor on a map; see Planner.plan.");
}

}  // namespace fairway::python
