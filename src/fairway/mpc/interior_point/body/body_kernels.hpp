// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/body/body_workspace.hpp"
#include "fairway/mpc/interior_point/workspace/filter.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"

namespace fairway::interior_point {

/// The parts of one iteration for a base, compiled for one register type, as SimdKernels.
template <typename Motion>
struct BodyKernels {
  void (*evaluate)(const BodyWorkspace<Motion>& w, BodyPoint<Motion>& point) noexcept;
  void (*start)(BodyWorkspace<Motion>& w, double mu) noexcept;
  OptimalityError (*linearise)(BodyWorkspace<Motion>& w, double mu) noexcept;
  bool (*solve_newton_system)(BodyWorkspace<Motion>& w, double mu) noexcept;
  bool (*take_step)(BodyWorkspace<Motion>& w,
                    double mu,
                    double fraction_to_boundary,
                    Filter& filter) noexcept;
};

/// Returns the kernels for registers that every processor has.
template <typename Motion>
[[nodiscard]] const BodyKernels<Motion>& body_kernels_128() noexcept;

/// Returns the kernels for registers of 256 bits; null if this processor or this build has none.
template <typename Motion>
[[nodiscard]] const BodyKernels<Motion>* body_kernels_256() noexcept;

}  // namespace fairway::interior_point
