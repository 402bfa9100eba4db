// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/navigation_step.hpp"

namespace fairway::python {

/// The result of a cycle with a copy of the predicted motion, which the navigator overwrites.
struct Step {
  NavigationStep step;
  MpcSolution plan;  ///< without steps if there is none

  explicit Step(const NavigationStep& made) : step(made) {
    step.plan = nullptr;
    if (made.plan != nullptr) plan = *made.plan;
  }
  [[nodiscard]] bool has_plan() const noexcept { return plan.horizon > 0; }
};

}  // namespace fairway::python
