// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/body/body_evaluation.hpp"
#include "fairway/mpc/interior_point/body/body_kernels.hpp"
#include "fairway/mpc/interior_point/body/body_workspace.hpp"
#include "fairway/mpc/interior_point/workspace/settings.hpp"

namespace fairway {

/// The real-time solver of a body with its true outline: the interior-point method of
/// `InteriorPointSolver` for `BodyProblem`, compiled for one base.
///
/// Every result is finite, and its inputs satisfy all hard limits; `status` gives its quality. The
/// same input gives the same bits, whatever was solved before. The solver does not allocate, lock
/// or throw. An object has a few MB, so keep it off stacks. Use one solver per thread.
///
/// A previous input outside the limits is allowed: the inputs return as fast as nine tenths of the
/// change bound allow, and the status is LeastViolation.
template <typename Motion>
class BodySolver {
 public:
  /// Selects the widest registers of this processor; the results do not depend on them.
  BodySolver() noexcept;
  explicit BodySolver(const interior_point::BodyKernels<Motion>& kernels) noexcept
      : kernels_(&kernels) {}

  /// Solves from a guess, or without one from a drive towards the targets. The reference stays
  /// valid until the next call.
  const BodySolution<Motion>& solve(const BodyProblem<Motion>& problem,
                                    const BodyGuess<Motion>& guess = {},
                                    const InteriorPointSettings& settings = {}) noexcept;

  /// Solves as `solve`. If that misses a feasible point, it tries other starts and keeps the best
  /// result: a stop, and turns to both sides. `iterations` is the sum over all starts.
  const BodySolution<Motion>& solve_with_restarts(
      const BodyProblem<Motion>& problem,
      const BodyGuess<Motion>& guess = {},
      const InteriorPointSettings& settings = {}) noexcept;

 private:
  const interior_point::BodyKernels<Motion>* kernels_;
  interior_point::BodyWorkspace<Motion> workspace_;
  BodySolution<Motion> solution_;
  BodySolution<Motion> best_;
};

}  // namespace fairway
