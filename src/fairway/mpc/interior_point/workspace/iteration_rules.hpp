// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point/workspace/optimality.hpp"
#include "fairway/mpc/interior_point/workspace/settings.hpp"

// How the barrier parameter falls and when an iteration ends, docs/solver.md section 6.

namespace fairway::interior_point {

/// Residuals must be far below what counts as a violation.
inline constexpr double kResidualTolerance = 1e-8;
/// A step of the commands below this is only rounding.
inline constexpr double kRoundingStep = 1e-14;
/// mu is reduced when the error of its barrier problem is below this times mu, Eq. (S17).
inline constexpr double kSolvedEnough = 30.0;

/// Returns the first barrier parameter. It is greater if the start violates constraints, because
/// the duals then change much, some up to the penalty weight.
[[nodiscard]] inline double first_barrier(const InteriorPointSettings& settings,
                                          double violation,
                                          double penalty_weight) noexcept {
  constexpr double kMostViolated = 0.1;  // greatest violation considered [m or m^2]
  return std::max(
      settings.initial_barrier,
      std::min(kMostViolated, settings.barrier_by_violation * violation) * penalty_weight);
}

/// Returns the least barrier parameter.
[[nodiscard]] inline double least_barrier(const InteriorPointSettings& settings) noexcept {
  constexpr double kLastBarrier = 0.1;     // of the tolerance
  constexpr double kLeastBarrier = 1e-12;  // products of slacks and duals below it are rounding
  return std::max(kLastBarrier * settings.tolerance, kLeastBarrier);
}

/// Lowers the barrier parameter as far as its problem is solved, Eq. (S17).
[[nodiscard]] inline double next_barrier(double mu,
                                         double least,
                                         const OptimalityError& error) noexcept {
  constexpr double kLinearDecrease = 0.2;
  while (mu > least && error.at(mu) < kSolvedEnough * mu)
    mu = std::max(least, std::min(kLinearDecrease * mu, mu * std::sqrt(mu)));
  return mu;
}

/// Returns the greatest share of a slack that a step may use. It increases as mu decreases: a slack
/// left far below mu over its dual would increase its dual afterwards.
[[nodiscard]] inline double fraction_of_slack(double mu, const OptimalityError& error) noexcept {
  constexpr double kLeastFraction = 0.99;
  constexpr double kFractionByDecrease = 0.5;
  return std::max(kLeastFraction, 1.0 - kFractionByDecrease * mu / error.greatest_product);
}

}  // namespace fairway::interior_point
