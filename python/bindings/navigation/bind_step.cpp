// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "casters.hpp"
#include "mpc/trajectory_arrays.hpp"
#include "navigation/step.hpp"

namespace fairway::python {

void bind_step(py::module_& module) {
  py::class_<Step>(module, "Step", "The result of a control cycle.")
      .def_property_readonly(
          "linear", [](const Step& s) { return s.step.command.linear; },
          "Linear speed to send until the next cycle [m/s].")
      .def_property_readonly(
          "angular", [](const Step& s) { return s.step.command.angular; },
          "Angular speed to send until the next cycle [rad/s].")
      .def_property_readonly(
          "lateral", [](const Step& s) { return s.step.lateral; },
          "Lateral speed to the left, of an omnidirectional base [m/s]; otherwise 0.")
      .def_property_readonly(
          "steering", [](const Step& s) { return s.step.steering; },
          "Angle of the steered wheel, of a car or tricycle [rad]; otherwise 0.")
      .def_property_readonly(
          "command", [](const Step& s) { return s.step.command; },
          "Both: finite and within the limits in every status.")
      .def_property_readonly(
          "status", [](const Step& s) { return s.step.status; },
          "State of the navigator in this cycle.")
      .def_property_readonly(
          "limit", [](const Step& s) { return s.step.limit; }, "Why the robot is not faster.")
      .def_property_readonly(
          "rectangle", [](const Step& s) { return s.step.rectangle; },
          "Index of the corridor's rectangle that contains the robot.")
      .def_property_readonly(
          "wants_plan", [](const Step& s) { return s.step.wants_plan; },
          "Whether the navigator requests a plan, which it makes itself.")
      .def_property_readonly(
          "poses",
          [](const Step& s) { return s.has_plan() ? poses_array(s.plan) : new_table(0, 3); },
          "Predicted motion: x, y, heading at each step; no row if there is none.")
      .def_property_readonly(
          "commands", [](const Step& s) { return commands_array(s.plan); },
          "Predicted commands: linear, angular; no row if there are none.")
      .def("__repr__", [](const Step& s) {
        return py::str("<Step linear={:.3f} angular={:.3f} {}>")
            .format(s.step.command.linear, s.step.command.angular, to_text(s.step.status));
      });
}

}  // namespace fairway::python
