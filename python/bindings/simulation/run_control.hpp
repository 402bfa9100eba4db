// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bindings.hpp"
#include "fairway/simulation/episode_control.hpp"

namespace fairway::python {

/// What a callback of `simulate` can change in a run. It is valid during the call only: a later use
/// is a ValueError.
class RunControl {
 public:
  void open(EpisodeControl* control) noexcept { control_ = control; }
  [[nodiscard]] EpisodeControl& get() const {
    if (control_ == nullptr)
      throw py::value_error("control: expected a use inside the callback, found one after it");
    return *control_;
  }

 private:
  EpisodeControl* control_ = nullptr;
};

void bind_run_control(py::module_& module);

}  // namespace fairway::python
