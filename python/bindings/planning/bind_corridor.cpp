// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/navigation/settings.hpp"
#include "results.hpp"

namespace fairway::python {

namespace {

void bind_status_of_corridors(py::module_& module) {
  using enum CorridorStatus;
  py::enum_<CorridorStatus>(module, "CorridorStatus", "Result of building a corridor.")
      .value("Built", Built)
      .value("EmptyPath", EmptyPath)
      .value("SeedBlocked", SeedBlocked)
      .value("NoOverlap", NoOverlap)
      .value("InvalidInput", InvalidInput)
      .def_property_readonly(
          "text", [](CorridorStatus status) { return to_text(status); },
          "As files of the tool write it.");
}

py::array_t<double> spans_array(const Corridor& corridor) {
  py::array_t<double> array = new_table(corridor.spans.size(), 2);
  double* out = array.mutable_data();
  for (const PathSpan& span : corridor.spans) {
    *out++ = span.from;
    *out++ = span.to;
  }
  return array;
}

OrientedRectangle admissible_rectangle(const Corridor& corridor, std::size_t index) {
  if (index >= corridor.rectangles.size()) throw py::index_error("no such rectangle");
  return corridor.admissible(index);
}

CorridorResult corridor_along(const OccupancyGrid& map,
                              const Path& path,
                              const std::optional<Settings>& given) {
  const py::gil_scoped_release release;
  const Settings settings = checked(given.value_or(Settings{}));
  return build_corridor(BitGrid(map, unknown_cells(settings.map)), path, settings.robot.radius,
                        settings.corridor);
}

}  // namespace

void bind_corridor(py::module_& module) {
  bind_status_of_corridors(module);
  py::class_<Corridor>(module, "Corridor",
                       "The free space along a path: rectangles in travel order, each with its "
                       "seed on the path.")
      .def_readonly("rectangles", &Corridor::rectangles, "In travel order.")
      .def_property_readonly(
          "space", [](const Corridor& corridor) { return to_text(corridor.space); },
          "\"configuration\": the centre of a disc of `robot_radius` may be everywhere in a "
          "rectangle; \"workspace\": it must stay `inward_offset` inside.")
      .def_readonly("robot_radius", &Corridor::robot_radius,
                    "Radius that the rectangles keep free [m].")
      .def_readonly("inward_offset", &Corridor::inward_offset,
                    "Distance that the rectangles keep from their sides [m].")
      .def_property_readonly("mean_area", &Corridor::mean_area, "[m^2]; 0 without a rectangle.")
      .def_property_readonly("spans", &spans_array,
                             "The part of the path of each rectangle, by arc length: from, to [m].")
      .def("admissible", &admissible_rectangle, py::arg("index"),
           "Returns a rectangle moved inward by `inward_offset`: the region of the robot's centre.")
      .def("__len__", [](const Corridor& corridor) { return corridor.rectangles.size(); });

  py::class_<CorridorResult>(module, "CorridorResult",
                             "A corridor, or where and why the path could not be covered.")
      .def_readonly("status", &CorridorResult::status, "What became of the corridor.")
      .def_property_readonly(
          "built", [](const CorridorResult& r) { return r.status == CorridorStatus::Built; },
          "Whether the corridor covers the whole path.")
      .def_property_readonly(
          "reason", [](const CorridorResult& r) { return to_text(r.status); },
          "The status as a text for users.")
      .def_readonly("corridor", &CorridorResult::corridor,
                    "Complete only if built; otherwise the part before `stuck_at`.")
      .def_readonly("stuck_at", &CorridorResult::stuck_at,
                    "Arc length along the path at which building stopped [m].");
  module.def("build_corridor", &corridor_along, py::arg("map"), py::arg("path"),
             py::arg("settings") = py::none(),
             "Covers a path with rectangles that are free for the disc of `robot.radius`.");
}

}  // namespace fairway::python
