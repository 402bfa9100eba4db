// SPDX-License-Identifier: Apache-2.0
#include <mutex>
#include <utility>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::python {

namespace {

using Cell = std::pair<int, int>;  // row, column

/// A builder with its settings; calls of several threads run one after the other.
class Builder {
 public:
  explicit Builder(const std::optional<Settings>& settings)
      : settings_(checked(settings.value_or(Settings{}))) {}

  [[nodiscard]] CorridorResult build(const OccupancyGrid& map, const Path& path) {
    const py::gil_scoped_release release;
    const std::scoped_lock lock(mutex_);
    return builder_.build(obstacles(map), path, settings_.robot.radius, settings_.corridor);
  }

  [[nodiscard]] CorridorResult update(const OccupancyGrid& map,
                                      const Cell& first,
                                      const Cell& last) {
    const py::gil_scoped_release release;
    const std::scoped_lock lock(mutex_);
    return builder_.update(obstacles(map), {.first = {.x = first.second, .y = first.first},
                                            .last = {.x = last.second, .y = last.first}});
  }

 private:
  [[nodiscard]] BitGrid obstacles(const OccupancyGrid& map) const {
    return BitGrid(map, unknown_cells(settings_.map));
  }

  std::mutex mutex_;
  Settings settings_;
  CorridorBuilder builder_;
};

}  // namespace

void bind_corridor_builder(py::module_& module) {
  py::class_<Builder>(module, "CorridorBuilder",
                      "Keeps a corridor up to date while the map changes.")
      .def(py::init<const std::optional<Settings>&>(), py::arg("settings") = py::none())
      .def("build", &Builder::build, py::arg("map"), py::arg("path"),
           "Builds a corridor along a path, as `build_corridor` does.")
      .def("update", &Builder::update, py::arg("map"), py::arg("first"), py::arg("last"),
           "Updates the corridor after cells between two corners (row, column) may have changed; "
           "it rebuilds only what the change affects.");
}

}  // namespace fairway::python
