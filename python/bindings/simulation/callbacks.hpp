// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>

#include "bindings.hpp"
#include "fairway/simulation/episode_observer.hpp"

namespace fairway::python {

/// Calls functions of Python from a run that does not hold the GIL.
///
/// An exception, Ctrl-C included, ends the run: `ended` becomes true, later calls are left out, and
/// `rethrow` passes it on after the run.
class Callbacks final : public EpisodeObserver {
 public:
  /// @param on_plan  Called with time, robot and plan; may be None.
  /// @param on_step  Called with time, robot, pose, twist and step of each cycle; may be None.
  Callbacks(py::object on_plan, py::object on_step);

  void on_start(const Scenario& scenario) override;
  void on_navigators(double time,
                     const Settings& settings,
                     std::span<const NavigatorStart> starts) override;
  void on_plan(double time, std::size_t robot, const Plan& plan) override;
  void on_world(const WorldView& world) override;
  void on_cycle(const NavigationCycle& cycle) override;

  /// Runs `call` with the GIL. @return false once an exception has ended the run.
  bool run(const std::function<void()>& call) noexcept;

  [[nodiscard]] bool ended() const noexcept { return error_ != nullptr; }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  py::object on_plan_;
  py::object on_step_;
  std::exception_ptr error_;
};

}  // namespace fairway::python
