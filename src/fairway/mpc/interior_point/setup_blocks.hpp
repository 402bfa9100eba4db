// SPDX-License-Identifier: Apache-2.0
// Parts of the workspace that the solvers of all robots fill in the same way.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Bounds of constraints that are not needed: so far away that they have no weight.
inline constexpr double kFarBound = 1e8;

/// Sets the entries from `first` on to zero, as far as the blocks of lanes read.
template <typename AnyWorkspace, std::size_t n>
void clear_beyond(std::size_t first, const AnyWorkspace& w, std::array<double, n>& array) noexcept {
  for (std::size_t k = first; k < std::min(n, kLanes * w.num_blocks + 2); ++k)
    array[k] = 0.0;
}

/// Sets the bounds of step `k`.
inline void set_bounds(Bounds& bounds, std::size_t k, double low, double high) noexcept {
  bounds.blocks[k / kLanes].low[k % kLanes] = low;
  bounds.blocks[k / kLanes].high[k % kLanes] = high;
}

/// Loads the targets of the poses and their weights, relative to the start.
template <typename Problem, typename AnyWorkspace>
void load_pose_targets(const Problem& problem, AnyWorkspace& w) noexcept {
  const auto& origin = problem.start.position;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const StepTarget& target = problem.targets[k + 1];
    w.target_x[k] = target.position.x() - origin.x();
    w.target_y[k] = target.position.y() - origin.y();
    w.target_heading[k] = target.heading - w.full_turns;
    w.weight_x[k] = target.weight.x();
    w.weight_y[k] = target.weight.y();
    w.weight_heading[k] = target.weight.z();
  }
  for (StepArray* array :
       {&w.target_x, &w.target_y, &w.target_heading, &w.weight_x, &w.weight_y, &w.weight_heading})
    clear_beyond(w.horizon, w, *array);
}

}  // namespace fairway::interior_point
