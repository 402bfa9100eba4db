// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// The command range and the change bounds: hard, so their slacks are the rooms themselves, and the
// iterates stay strictly inside.

namespace fairway::interior_point {

/// What constraints of kind `kind` (index of Workspace::bounds) bound, for four steps from k.
template <typename Lanes>
FAIRWAY_LANES Lanes bounded(const std::array<PoseArray, 2>& commands,
                            std::size_t kind,
                            std::size_t k) noexcept {
  const PoseArray& command = commands[kind % 2];
  const Lanes now = lanes<Lanes>(command, k + 1);
  return kind < 2 ? now : now - lanes<Lanes>(command, k);
}

/// Distances to both bounds.
template <typename Lanes>
struct Room {
  Lanes below, above;
};

template <typename Lanes>
FAIRWAY_LANES Room<Lanes> room_of(const Bounds::Block& block, const Lanes& t) noexcept {
  constexpr double kLeastRoom = 1e-15;  // against rounding at a bound
  return {.below = greatest(t - block.low, Lanes(kLeastRoom)),
          .above = greatest(block.high - t, Lanes(kLeastRoom))};
}

/// Adds the logarithms of all rooms that the commands of `point` leave.
template <typename Lanes>
FAIRWAY_LANES void add_room_logs(const Workspace& w,
                                 const Point& point,
                                 LogSum<Lanes>& logs) noexcept {
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      const Lanes t = bounded<Lanes>(point.commands, kind, kLanes * b);
      const Room<Lanes> room = room_of(w.bounds[kind].blocks[b], t);
      logs.add(room.below * room.above);
    }
  }
}

/// Duals to start from: on the central path of `mu`.
template <typename Lanes>
FAIRWAY_LANES void start_bounds(Workspace& w, double mu) noexcept {
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      Bounds::Block& block = w.bounds[kind].blocks[b];
      const Room<Lanes> room = room_of(block, bounded<Lanes>(w.now->commands, kind, kLanes * b));
      block.dual_low = mu / room.below;
      block.dual_high = mu / room.above;
    }
  }
}

/// Keeps the duals near the central path of `mu`, Eq. (S13), and finds what the constraints add to
/// the model at `w.now`.
template <typename Lanes>
FAIRWAY_LANES void linearise_bounds(Workspace& w,
                                    double mu,
                                    ConstraintErrors<Lanes>& errors) noexcept {
  const double most = kCentrality * mu;
  const double least_product = mu / kCentrality;
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    Bounds& bounds = w.bounds[kind];
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      Bounds::Block& block = bounds.blocks[b];
      const Room<Lanes> room = room_of(block, bounded<Lanes>(w.now->commands, kind, kLanes * b));
      const Lanes inverse = 1.0 / (room.below * room.above);
      const Lanes below = room.above * inverse;  // 1 / below
      const Lanes above = room.below * inverse;
      const Lanes low = least(greatest(Lanes(block.dual_low), least_product * below), most * below);
      const Lanes high =
          least(greatest(Lanes(block.dual_high), least_product * above), most * above);
      block.inverse_below = below;
      block.inverse_above = above;
      block.dual_low = low;
      block.dual_high = high;
      put(bounds.curvature, kLanes * b, low * below + high * above);
      put(bounds.by_mu, kLanes * b, above - below);
      put(bounds.dual, kLanes * b, high - low);
      const Lanes low_product = room.below * low;
      const Lanes high_product = room.above * high;
      errors.least_product = least(errors.least_product, least(low_product, high_product));
      errors.greatest_product =
          greatest(errors.greatest_product, greatest(low_product, high_product));
    }
  }
}

/// Takes the duals along the Newton step.
/// @return The greatest part of any room that the step would use up.
template <typename Lanes>
FAIRWAY_LANES double step_bounds(Workspace& w, double mu) noexcept {
  Lanes used = 0.0;
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      Bounds::Block& block = w.bounds[kind].blocks[b];
      const Lanes change = bounded<Lanes>(w.step.commands, kind, kLanes * b);
      const Lanes down = -change * block.inverse_below;
      const Lanes up = change * block.inverse_above;
      used = greatest(used, greatest(down, up));
      block.dual_low = mu * Lanes(block.inverse_below) + block.dual_low * down;
      block.dual_high = mu * Lanes(block.inverse_above) + block.dual_high * up;
    }
  }
  return greatest_of(used);
}

}  // namespace fairway::interior_point
