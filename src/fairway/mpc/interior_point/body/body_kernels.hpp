// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/body/body_workspace.hpp"
#include "fairway/mpc/interior_point/workspace/filter.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"

namespace fairway::interior_point {

/// Steps for which a drive without a guess holds an input.
inline constexpr std::size_t kDriveHold = 3;

/// Twists of four inputs, and the cost of each input.
struct FourInputs {
  Pack4d linear, lateral, angular, cost;
};

/// Inputs that a drive without a guess chooses from.
template <typename Motion>
struct Candidates {
  static constexpr std::size_t kCount = 28;
  std::array<typename Motion::Input, kCount> inputs;
  std::array<FourInputs, kCount / kLanes> fours;

  void set(const BodyWorkspace<Motion>& w,
           std::size_t i,
           const typename Motion::Input& input) noexcept {
    const PlanarTwist twist = w.problem->motion.twist(input);
    FourInputs& four = fours[i / kLanes];
    inputs[i] = input;
    four.linear[i % kLanes] = twist.linear;
    four.lateral[i % kLanes] = twist.lateral;
    four.angular[i % kLanes] = twist.angular;
    four.cost[i % kLanes] = w.problem->input_weight.dot(input.cwiseAbs2());
  }
};

/// The parts of one iteration for a base, compiled for one register type, as SimdKernels.
template <typename Motion>
struct BodyKernels {
  /// Returns the candidate that is best if it is held from step `first` on.
  std::size_t (*best_candidate)(const BodyWorkspace<Motion>& w,
                                const Pose2& pose,
                                std::size_t first,
                                const Candidates<Motion>& candidates) noexcept;
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
