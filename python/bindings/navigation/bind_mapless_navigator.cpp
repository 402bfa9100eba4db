// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "navigation/navigator_calls.hpp"

namespace fairway::python {

void bind_mapless_navigator(py::module_& module) {
  using Shared = SharedNavigator<MaplessNavigator>;
  py::class_<Shared> type(module, "MaplessNavigator",
                          "Drives one robot to a goal without a map, on what its lidar has "
                          "measured so far.");
  type.def(py::init([](const Settings& settings, const Eigen::Vector2d& position) {
             const py::gil_scoped_release release;
             return std::make_unique<Shared>(settings, position);
           }),
           py::arg("settings"), py::arg("position") = Eigen::Vector2d(0.0, 0.0),
           "`position` is that of the robot at the start, if known [m]. Raises a ValueError if "
           "the settings are invalid.");
  bind_navigator_calls(type);
}

}  // namespace fairway::python
