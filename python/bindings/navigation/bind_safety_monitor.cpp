// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/monitor/safety_monitor.hpp"
#include "numbers.hpp"

namespace fairway::python {

namespace {

Polygon points_of(py::handle source, const char* name) {
  const NumberTable table = read_table(source, name, 2);
  Polygon points;
  for (std::size_t i = 0; i < table.rows; ++i)
    points.emplace_back(table.row(i)[0], table.row(i)[1]);
  return points;
}

const char* text_of(MonitorReason reason) noexcept {
  switch (reason) {
    case MonitorReason::None:
      return "none";
    case MonitorReason::InvalidInput:
      return "invalid input";
    case MonitorReason::Stale:
      return "no new points";
    case MonitorReason::StopZone:
      return "stop zone";
    case MonitorReason::SlowZone:
      return "slow zone";
    case MonitorReason::Obstacle:
      return "obstacle";
  }
  return "unknown";
}

std::unique_ptr<SafetyMonitor> make_monitor(const py::sequence& footprint,
                                            const py::object& stop_zone,
                                            const py::object& slow_zone,
                                            MonitorSettings settings) {
  for (const py::handle& polygon : footprint)
    settings.footprint.push_back(points_of(polygon, "footprint"));
  settings.stop_zone = points_of(stop_zone, "stop_zone");
  settings.slow_zone = points_of(slow_zone, "slow_zone");
  if (const Expected<void> valid = validate(settings); !valid)
    throw py::value_error(valid.error().message);
  return std::make_unique<SafetyMonitor>(std::move(settings));
}

}  // namespace

void bind_safety_monitor(py::module_& module) {
  py::class_<MonitorVerdict>(module, "MonitorVerdict", "What a SafetyMonitor says of a command.")
      .def_readonly("command", &MonitorVerdict::command,
                    "(linear, angular) to send: `fraction` of the command that was asked for.")
      .def_readonly("fraction", &MonitorVerdict::fraction, "0 to 1.")
      .def_property_readonly(
          "reason", [](const MonitorVerdict& self) { return text_of(self.reason); },
          "Why it was reduced: 'none', 'invalid input', 'no new points', 'stop zone', 'slow zone' "
          "or 'obstacle'.");
  const MonitorSettings defaults;
  py::class_<SafetyMonitor>(
      module, "SafetyMonitor",
      "The last check of a command before the base. It shares no code with the navigators: it "
      "looks at the newest points only, and simulates the commands on their way, the new one, and "
      "braking. Not for several threads at once.")
      .def(
          py::init([](const py::sequence& footprint, const py::object& stop_zone,
                      const py::object& slow_zone, double slow_speed, double linear_acceleration,
                      double angular_acceleration, double linear_braking, double angular_braking,
                      double delay, const std::optional<double>& angular_delay, double linear_lag,
                      double angular_lag, double ramp, double hold, double margin, double max_age) {
            return make_monitor(footprint, stop_zone, slow_zone,
                                {.slow_speed = slow_speed,
                                 .linear_acceleration = linear_acceleration,
                                 .angular_acceleration = angular_acceleration,
                                 .linear_braking = linear_braking,
                                 .angular_braking = angular_braking,
                                 .delay = delay,
                                 .angular_delay = angular_delay,
                                 .linear_lag = linear_lag,
                                 .angular_lag = angular_lag,
                                 .ramp = ramp,
                                 .hold = hold,
                                 .margin = margin,
                                 .max_age = max_age});
          }),
          py::arg("footprint"), py::kw_only(), py::arg("stop_zone") = py::list(),
          py::arg("slow_zone") = py::list(), py::arg("slow_speed") = defaults.slow_speed,
          py::arg("linear_acceleration") = defaults.linear_acceleration,
          py::arg("angular_acceleration") = defaults.angular_acceleration,
          py::arg("linear_braking") = 0.0, py::arg("angular_braking") = 0.0, py::arg("delay") = 0.0,
          py::arg("angular_delay") = py::none(), py::arg("linear_lag") = 0.0,
          py::arg("angular_lag") = 0.0, py::arg("ramp") = 0.0, py::arg("hold") = defaults.hold,
          py::arg("margin") = defaults.margin, py::arg("max_age") = defaults.max_age,
          "`footprint` is a list of polygons in the robot's frame, whose union is the body; a "
          "point in `stop_zone` stops the robot, one in `slow_zone` limits it to `slow_speed`. "
          "Braking of 0 is as the acceleration. Units and meanings are those of C++.")
      .def(
          "see",
          [](SafetyMonitor& self, double time, const py::object& points) {
            return self.see(time, points_of(points, "points"));
          },
          py::arg("time"), py::arg("points"),
          "Takes in the newest obstacle points, in the frame of the poses. More than 8192, or one "
          "that is not finite, are refused, and the older ones stay.")
      .def("check", &SafetyMonitor::check, py::arg("time"), py::arg("pose"), py::arg("current"),
           py::arg("command"),
           "Returns what may be sent. `current` is the command that was sent in the cycle before; "
           "at first, and after `reset`, the twist of the base. Call it for every command.")
      .def("reset", &SafetyMonitor::reset,
           "Forgets the commands on their way, after others have driven the robot.");
}

}  // namespace fairway::python
