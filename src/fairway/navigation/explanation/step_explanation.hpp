// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/navigator.hpp"

namespace fairway {

/// Explains the step that `navigator` returned last, for `input`.
///
/// A robot at standstill waits for the first moving obstacle or robot on the 2 m of its path ahead.
/// Otherwise the moving obstacle is the one whose barrier holds back the solver's answer; if there
/// is no answer, it is the nearest one. The robot counts as the disc of its settings. It allocates,
/// so it is for displays and logs. A robot without a plan is explained by the plan (`explain` of
/// planner.hpp).
/// @param speed  At which the robot moves [m/s].
/// @pre `step.plan` and all that `input` refers to are still valid.
[[nodiscard]] StepExplanation explain_step(const Navigator& navigator,
                                           const NavigationStep& step,
                                           const NavigationInput& input,
                                           double speed);

}  // namespace fairway
