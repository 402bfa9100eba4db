// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// The command range and the change bounds. They are hard: their slacks are the distances to the
// bounds, and the iterates stay strictly inside.

namespace fairway::interior_point {

/// Returns the quantity that constraints of kind `kind` (index of Workspace::bounds) bound, for
/// four steps from k.
template <typename Lanes>
FAIRWAY_LANES Lanes bounded(const std::array<PoseArray, 2>& commands,
                            std::size_t kind,
                            std::size_t k) noexcept {
  const PoseArray& command = commands[kind % 2];
  const Lanes now = lanes<Lanes>(command, k + 1);
  return kind < 2 ? now : now - lanes<Lanes>(command, k);
}

/// The distances to both bounds: the slacks of hard constraints.
template <typename Lanes>
struct BoundSlacks {
  Lanes below, above;
};

template <typename Lanes>
FAIRWAY_LANES BoundSlacks<Lanes> slacks_of(const Bounds::Block& block, const Lanes& t) noexcept {
  constexpr double kLeastSlack = 1e-15;  // avoids 0 after rounding at a bound
  return {.below = greatest(t - block.low, Lanes(kLeastSlack)),
          .above = greatest(block.high - t, Lanes(kLeastSlack))};
}

/// Adds the logarithms of the slacks of all bounds at the commands of `point`.
template <typename Lanes>
FAIRWAY_LANES void add_bound_logs(const Workspace& w,
                                  const Point& point,
                                  LogSum<Lanes>& logs) noexcept {
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      const Lanes t = bounded<Lanes>(point.commands, kind, kLanes * b);
      const BoundSlacks<Lanes> slack = slacks_of(w.bounds[kind].blocks[b], t);
      logs.add(slack.below * slack.above);
    }
  }
}

/// Initialises the duals on the central path of `mu`.
template <typename Lanes>
FAIRWAY_LANES void start_bounds(Workspace& w, double mu) noexcept {
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      Bounds::Block& block = w.bounds[kind].blocks[b];
      const BoundSlacks<Lanes> slack =
          slacks_of(block, bounded<Lanes>(w.now->commands, kind, kLanes * b));
      block.dual_low = mu / slack.below;
      block.dual_high = mu / slack.above;
    }
  }
}

/// Computes the terms that one block of bounds of `t` adds to the model. Before, the duals are kept
/// near the central path of `mu`, Eq. (S13).
template <typename Lanes>
FAIRWAY_LANES void linearise_bound(Bounds& bounds,
                                   std::size_t b,
                                   const Lanes& t,
                                   double mu,
                                   ConstraintErrors<Lanes>& errors) noexcept {
  const double most = kCentrality * mu;
  const double least_product = mu / kCentrality;
  Bounds::Block& block = bounds.blocks[b];
  const BoundSlacks<Lanes> slack = slacks_of(block, t);
  const Lanes inverse = 1.0 / (slack.below * slack.above);
  const Lanes below = slack.above * inverse;  // 1 / below
  const Lanes above = slack.below * inverse;
  const Lanes low = least(greatest(Lanes(block.dual_low), least_product * below), most * below);
  const Lanes high = least(greatest(Lanes(block.dual_high), least_product * above), most * above);
  block.inverse_below = below;
  block.inverse_above = above;
  block.dual_low = low;
  block.dual_high = high;
  put(bounds.curvature, kLanes * b, low * below + high * above);
  put(bounds.by_mu, kLanes * b, above - below);
  put(bounds.dual, kLanes * b, high - low);
  const Lanes low_product = slack.below * low;
  const Lanes high_product = slack.above * high;
  errors.least_product = least(errors.least_product, least(low_product, high_product));
  errors.greatest_product = greatest(errors.greatest_product, greatest(low_product, high_product));
}

/// Computes the terms that the bounds add to the model at `w.now`.
template <typename Lanes>
FAIRWAY_LANES void linearise_bounds(Workspace& w,
                                    double mu,
                                    ConstraintErrors<Lanes>& errors) noexcept {
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t b = 0; b < w.num_blocks; ++b)
      linearise_bound(w.bounds[kind], b, bounded<Lanes>(w.now->commands, kind, kLanes * b), mu,
                      errors);
  }
}

/// Computes the duals of one block after a step that changes its quantity by `change`.
/// @return The share of a slack that the step would use up.
template <typename Lanes>
FAIRWAY_LANES Lanes step_bound(Bounds::Block& block, const Lanes& change, double mu) noexcept {
  const Lanes down = -change * block.inverse_below;
  const Lanes up = change * block.inverse_above;
  block.dual_low = mu * Lanes(block.inverse_below) + block.dual_low * down;
  block.dual_high = mu * Lanes(block.inverse_above) + block.dual_high * up;
  return greatest(down, up);
}

/// Computes the duals after the Newton step.
/// @return The greatest share of any slack that the step would use up.
template <typename Lanes>
FAIRWAY_LANES double step_bounds(Workspace& w, double mu) noexcept {
  Lanes used = 0.0;
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t b = 0; b < w.num_blocks; ++b)
      used = greatest(used, step_bound(w.bounds[kind].blocks[b],
                                       bounded<Lanes>(w.step.commands, kind, kLanes * b), mu));
  }
  return greatest_of(used);
}

}  // namespace fairway::interior_point
