// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <filesystem>

#include <pybind11/numpy.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/map/occupancy_grid.hpp"
#include "results.hpp"

namespace fairway::python {

namespace {

constexpr int kOccupied = 100;
constexpr int kUnknown = -1;

template <typename Number>
OccupancyGrid filled_map(const py::array& cells, double resolution, const Pose2& origin) {
  const auto values = py::array_t<Number, py::array::c_style | py::array::forcecast>::ensure(cells);
  if (!values) throw py::error_already_set();
  OccupancyGrid grid({.width = static_cast<int>(values.shape(1)),
                      .height = static_cast<int>(values.shape(0)),
                      .resolution = resolution,
                      .origin = origin});
  const Number* cell = values.data();
  for (int y = 0; y < grid.frame().height; ++y) {
    for (int x = 0; x < grid.frame().width; ++x, ++cell) {
      if (*cell == Number{0}) continue;
      const bool known = *cell == Number{kOccupied};
      if (!known && *cell != static_cast<Number>(kUnknown)) {
        refuse("cells[" + std::to_string(y) + ", " + std::to_string(x) + "]",
               "0 (free), 100 (occupied) or -1 (unknown)", py::cast(*cell));
      }
      grid.set({.x = x, .y = y}, known ? CellState::Occupied : CellState::Unknown);
    }
  }
  return grid;
}

OccupancyGrid map_from_array(const py::object& source, double resolution, const Goal& origin) {
  const py::array cells = py::array::ensure(source);
  if (!cells) throw py::error_already_set();
  const bool has_cells = cells.ndim() == 2 && cells.size() > 0;
  const bool fits = has_cells && cells.shape(0) <= OccupancyGrid::kMaxSide &&
                    cells.shape(1) <= OccupancyGrid::kMaxSide;
  if (!fits)
    refuse("cells", "an array of rows and columns, 1 to 32768 of each", cells.attr("shape"));
  const char kind = cells.dtype().kind();
  const Pose2 pose{.position = origin.position, .heading = origin.heading.value_or(0.0)};
  if (kind == 'b')
    return filled_map<std::int16_t>(cells.attr("__mul__")(kOccupied), resolution, pose);
  if (kind != 'i' && kind != 'u' && kind != 'f')
    refuse("cells", "an array of numbers", cells.dtype());
  // Larger types as double, which is exact for all values that are accepted.
  return cells.itemsize() == 1 ? filled_map<std::int16_t>(cells, resolution, pose)
                               : filled_map<double>(cells, resolution, pose);
}

py::array_t<std::int8_t> map_to_array(const OccupancyGrid& grid) {
  py::array_t<std::int8_t> array({grid.frame().height, grid.frame().width});
  std::int8_t* out = array.mutable_data();
  for (const CellState state : grid.cells()) {
    *out++ = static_cast<std::int8_t>(state == CellState::Free       ? 0
                                      : state == CellState::Occupied ? kOccupied
                                                                     : kUnknown);
  }
  return array;
}

OccupancyGrid read_map_file(const std::filesystem::path& path) {
  io::FileNotes notes;
  OccupancyGrid map = value_of(without_gil([&] { return io::read_map(path.string(), &notes); }));
  warn(notes);
  return map;
}

}  // namespace

void bind_map(py::module_& module) {
  py::class_<OccupancyGrid>(module, "Map", "The static world: one state per cell.")
      .def_static("from_array", &map_from_array, py::arg("cells"), py::arg("resolution"),
                  py::arg("origin") = Goal{},
                  "Makes a map from cells[row, column]: 0 free, 100 occupied, -1 unknown; of an "
                  "array of bool, True is occupied. Row 0 is the lowest y and begins at `origin`, "
                  "the pose of its lower-left corner.")
      .def_static("read", &read_map_file, py::arg("path"),
                  "Reads a map_server map from its YAML file and the picture named there.")
      .def("to_array", &map_to_array, "Returns the cells as `from_array` takes them, as int8.")
      .def_property_readonly(
          "shape",
          [](const OccupancyGrid& map) {
            return py::make_tuple(map.frame().height, map.frame().width);
          },
          "Number of rows and of columns.")
      .def_property_readonly(
          "resolution", [](const OccupancyGrid& map) { return map.frame().resolution; },
          "Side of a cell [m].")
      .def_property_readonly(
          "origin", [](const OccupancyGrid& map) { return map.frame().origin; },
          "Pose of the lower-left corner of cell (0, 0): x, y [m], heading [rad].")
      .def(
          "cell_at",
          [](const OccupancyGrid& map, const Eigen::Vector2d& point) {
            const CellIndex cell = map.frame().cell_at(point);
            return py::make_tuple(cell.y, cell.x);
          },
          py::arg("point"),
          "Returns row and column of the cell that contains a point, which may lie outside.")
      .def(
          "center",
          [](const OccupancyGrid& map, int row, int column) {
            return map.frame().center({.x = column, .y = row});
          },
          py::arg("row"), py::arg("column"), "Returns the centre of a cell [m].");
}

}  // namespace fairway::python
