// SPDX-License-Identifier: Apache-2.0
#include "simulation/callbacks.hpp"

#include <utility>

#include "casters.hpp"
#include "navigation/step.hpp"

namespace fairway::python {

Callbacks::Callbacks(py::object on_plan, py::object on_step)
    : on_plan_(std::move(on_plan)),
      on_step_(std::move(on_step)) {}

bool Callbacks::run(const std::function<void()>& call) noexcept {
  if (error_) return false;
  const py::gil_scoped_acquire acquire;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    call();
  } catch (...) {
    error_ = std::current_exception();
  }
  return error_ == nullptr;
}

void Callbacks::on_start(const Scenario& /*scenario*/) {}
void Callbacks::on_navigators(double /*time*/,
                              const Settings& /*settings*/,
                              std::span<const NavigatorStart> /*starts*/) {}
void Callbacks::on_world(const WorldView& /*world*/) {}

void Callbacks::on_plan(double time, std::size_t robot, const Plan& plan) {
  if (!on_plan_.is_none()) run([&] { on_plan_(time, robot, plan); });
}

void Callbacks::on_cycle(const NavigationCycle& cycle) {
  if (on_step_.is_none()) return;
  run([&] {
    on_step_(cycle.input.time, cycle.robot, cycle.input.pose, cycle.twist, Step(cycle.step));
  });
}

}  // namespace fairway::python
