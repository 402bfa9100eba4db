// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"
#include "navigation/step.hpp"
#include "results.hpp"
#include "simulation/callbacks.hpp"

namespace fairway::python {

namespace {

struct Replay {
  long cycles = 0;
  long different = 0;
  std::optional<ReplayCheck::Difference> first_difference;
};

Replay replay_recording(const std::filesystem::path& path,
                        const py::object& on_plan,
                        const py::object& on_step) {
  Callbacks callbacks(on_plan, on_step);
  ReplayCheck check;
  ObserverList observers;
  observers.add(check);
  observers.add(callbacks);
  const Expected<void> read =
      without_gil([&] { return io::read_recording(path.string(), observers); });
  callbacks.rethrow();
  value_of(read);
  return {.cycles = check.cycles(),
          .different = check.different(),
          .first_difference = check.first_difference()};
}

py::object first_difference(const Replay& replay) {
  if (!replay.first_difference) return py::none();
  const ReplayCheck::Difference& first = *replay.first_difference;
  return py::make_tuple(first.time, first.robot, Step(first.recorded), Step(first.replayed));
}

}  // namespace

void bind_recording(py::module_& module) {
  py::class_<Replay>(module, "Replay", "What running a recording again has shown.")
      .def_readonly("cycles", &Replay::cycles, "Number of control cycles.")
      .def_readonly("different", &Replay::different, "Number of cycles whose output differs.")
      .def_property_readonly(
          "same", [](const Replay& r) { return r.cycles > 0 && r.different == 0; },
          "Whether every command is the same to the bit.")
      .def_property_readonly("first_difference", &first_difference,
                             "Time, robot, recorded and replayed step, or None.");
  module.def("replay", &replay_recording, py::arg("path"), py::kw_only(),
             py::arg("on_plan") = py::none(), py::arg("on_step") = py::none(),
             "Runs the navigators of a recording again on its inputs and compares all outputs. "
             "The callbacks are those of `simulate` and receive what was recorded.");
}

}  // namespace fairway::python
