// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"

namespace fairway::python {

PYBIND11_MODULE(_fairway, module) {
  module.doc() = "Compiled part of the package fairway.";
  module.attr("__version__") = FAIRWAY_VERSION;
  bind_settings(module);  // in this order: a signature names only types that are already known
  bind_map(module);
  bind_rectangle(module);
  bind_corridor(module);
  bind_corridor_builder(module);
  bind_plan(module);
  bind_status(module);
  bind_problem(module);
  bind_solver(module);
  bind_step(module);
  bind_map_navigator(module);
  bind_mapless_navigator(module);
  bind_body_navigator(module);
  bind_map_localization(module);
  bind_safety_monitor(module);
  bind_scenario(module);
  bind_episode(module);
  bind_recording(module);
  bind_barn(module);
}

}  // namespace fairway::python
