// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/body/body_workspace.hpp"
#include "fairway/mpc/interior_point/constraints/bounds.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"

// Ranges, changes and limits of sums of the inputs. They are hard, as in constraints/bounds.hpp.

namespace fairway::interior_point {

/// Returns whether bounds of kind `kind` exist: inputs, then changes, then sums.
template <typename Motion>
[[nodiscard]] bool has_bounds(const BodyWorkspace<Motion>& w, std::size_t kind) noexcept {
  if (kind < Motion::kInputs) return true;
  if (kind < 2 * Motion::kInputs) return w.has_change_bounds;
  return kind - 2 * Motion::kInputs < w.num_limits;
}

/// Returns the quantity that bounds of kind `kind` limit, for four steps from k.
template <typename Lanes, typename Motion>
FAIRWAY_LANES Lanes bounded_input(const BodyWorkspace<Motion>& w,
                                  const std::array<PoseArray, Motion::kInputs>& inputs,
                                  std::size_t kind,
                                  std::size_t k) noexcept {
  constexpr std::size_t n = Motion::kInputs;
  if (kind < n) return lanes<Lanes>(inputs[kind], k + 1);
  if (kind < 2 * n)
    return lanes<Lanes>(inputs[kind - n], k + 1) - lanes<Lanes>(inputs[kind - n], k);
  const auto& normal = w.problem->input_limits[kind - 2 * n].normal;
  Lanes value = normal[0] * lanes<Lanes>(inputs[0], k + 1);
  for (std::size_t j = 1; j < n; ++j)
    value += normal[static_cast<Eigen::Index>(j)] * lanes<Lanes>(inputs[j], k + 1);
  return value;
}

template <typename Lanes, typename Motion>
FAIRWAY_LANES void add_input_logs(const BodyWorkspace<Motion>& w,
                                  const BodyPoint<Motion>& point,
                                  LogSum<Lanes>& logs) noexcept {
  for (std::size_t kind = 0; kind < w.kMaxBounds; ++kind) {
    if (!has_bounds(w, kind)) continue;
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      const BoundSlacks<Lanes> slack = slacks_of(
          w.bounds[kind].blocks[b], bounded_input<Lanes>(w, point.inputs, kind, kLanes * b));
      logs.add(slack.below * slack.above);
    }
  }
}

template <typename Lanes, typename Motion>
FAIRWAY_LANES void start_input_bounds(BodyWorkspace<Motion>& w, double mu) noexcept {
  for (std::size_t kind = 0; kind < w.kMaxBounds; ++kind) {
    if (!has_bounds(w, kind)) continue;
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      Bounds::Block& block = w.bounds[kind].blocks[b];
      const BoundSlacks<Lanes> slack =
          slacks_of(block, bounded_input<Lanes>(w, w.now->inputs, kind, kLanes * b));
      block.dual_low = mu / slack.below;
      block.dual_high = mu / slack.above;
    }
  }
}

template <typename Lanes, typename Motion>
FAIRWAY_LANES void linearise_input_bounds(BodyWorkspace<Motion>& w,
                                          double mu,
                                          ConstraintErrors<Lanes>& errors) noexcept {
  for (std::size_t kind = 0; kind < w.kMaxBounds; ++kind) {
    if (!has_bounds(w, kind)) continue;
    for (std::size_t b = 0; b < w.num_blocks; ++b)
      linearise_bound(w.bounds[kind], b, bounded_input<Lanes>(w, w.now->inputs, kind, kLanes * b),
                      mu, errors);
  }
}

/// Computes the duals after the Newton step.
/// @return The greatest share of any slack that the step would use up.
template <typename Lanes, typename Motion>
FAIRWAY_LANES double step_input_bounds(BodyWorkspace<Motion>& w, double mu) noexcept {
  Lanes used = 0.0;
  for (std::size_t kind = 0; kind < w.kMaxBounds; ++kind) {
    if (!has_bounds(w, kind)) continue;
    for (std::size_t b = 0; b < w.num_blocks; ++b)
      used =
          greatest(used, step_bound(w.bounds[kind].blocks[b],
                                    bounded_input<Lanes>(w, w.step.inputs, kind, kLanes * b), mu));
  }
  return greatest_of(used);
}

}  // namespace fairway::interior_point
