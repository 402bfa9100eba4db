// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_workspace.hpp"

// Corridor sides and obstacles: elastic, c + e = s with price w on every e. docs/solver.md derives
// the formulas.

namespace fairway::interior_point {

/// Values of the rows at the poses of `point`, Eq. (S3).
void evaluate_elastic_rows(const Workspace& w, Point& point) noexcept;

/// Slacks and duals to start from at `mu`, given the values in `w.now`.
void start_elastic_rows(Workspace& w, double mu) noexcept;

/// Sums of `point` over the elastic rows, for the merit function.
/// @return Sum of the logarithms of s and e.
double sum_elastic_rows(const Workspace& w, Point& point) noexcept;

/// Gradients and curvatures, and what they add to the model with the present duals. Everything in
/// the model that belongs to positions is overwritten. Eq. (S5).
void linearise_elastic_rows(Workspace& w) noexcept;

/// Duals that the Newton step aims at, Eq. (S7), subtracted from the gradient of the model.
void aim_elastic_rows(Workspace& w, double mu) noexcept;

/// What the Newton step does to the rows, Eq. (S12).
struct ElasticStep {
  double used = 0.0;     ///< greatest part of any s or e that it would use up
  double slope = 0.0;    ///< derivative of the barrier and the price along it
  double product = 0.0;  ///< sum of y hat dc
};
[[nodiscard]] ElasticStep step_elastic_rows(Workspace& w, double mu) noexcept;

/// Slacks of `w.trial` at `length` along the step, given its values; slacks that are too small for
/// their row are reset, which lowers every merit function.
void move_slacks(Workspace& w, double length) noexcept;

/// Takes the duals along the step and keeps them near the central path of `mu`, Eq. (S13).
void move_elastic_duals(Workspace& w, double mu) noexcept;

/// Raises every e to where its row has no residual.
void absorb_residuals(Workspace& w) noexcept;

}  // namespace fairway::interior_point
