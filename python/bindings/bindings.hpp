// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

/// The Python package `fairway`. It converts and delegates; each function adds one class, or a few
/// that belong together, to the module.
namespace fairway::python {

namespace py = pybind11;

void bind_map(py::module_& module);
void bind_rectangle(py::module_& module);
void bind_corridor(py::module_& module);
void bind_corridor_builder(py::module_& module);
void bind_plan(py::module_& module);

void bind_settings(py::module_& module);
void bind_status(py::module_& module);
void bind_step(py::module_& module);
void bind_map_navigator(py::module_& module);
void bind_mapless_navigator(py::module_& module);
void bind_body_navigator(py::module_& module);
void bind_map_localization(py::module_& module);
void bind_safety_monitor(py::module_& module);

void bind_problem(py::module_& module);
void bind_solver(py::module_& module);

void bind_scenario(py::module_& module);
void bind_episode(py::module_& module);
void bind_recording(py::module_& module);
void bind_barn(py::module_& module);

}  // namespace fairway::python
