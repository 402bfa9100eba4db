// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_workspace.hpp"

namespace fairway::interior_point {

/// Factorises the Newton system backwards over the steps, Eq. (S8) to (S11), with `damping` added
/// to the Hessian by every command.
/// @return Whether the reduced Hessian is positive definite; if not, `w.feedback` is unfinished.
[[nodiscard]] bool riccati_backward(Workspace& w, double exactness, double damping) noexcept;

/// The Newton step, forwards: fills the step arrays of `w.model`, Eq. (S12).
void riccati_forward(Workspace& w) noexcept;

}  // namespace fairway::interior_point
