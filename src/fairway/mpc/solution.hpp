// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "fairway/mpc/control_problem.hpp"

namespace fairway {

/// Reason why a solve ended.
enum class SolveStatus : std::uint8_t {
  Solved,          ///< optimal to tolerance, and every constraint is satisfied
  LeastViolation,  ///< optimal to tolerance, but the constraints cannot all hold: the least
                   ///< violation
  IterationLimit,  ///< the iteration budget ran out; the best iterate is returned
  Stalled,  ///< no further progress was possible before reaching the tolerance; the best iterate is
            ///< returned
  InvalidProblem,  ///< a number is not finite, or sizes or bounds contradict each other; commands
                   ///< are zero
};

[[nodiscard]] constexpr const char* to_text(SolveStatus status) noexcept {
  switch (status) {
    case SolveStatus::Solved:
      return "solved";
    case SolveStatus::LeastViolation:
      return "least violation";
    case SolveStatus::IterationLimit:
      return "iteration limit";
    case SolveStatus::Stalled:
      return "stalled";
    case SolveStatus::InvalidProblem:
      return "invalid problem";
  }
  return "unknown";
}

/// Kind of the constraint that limits the solution most.
enum class ConstraintKind : std::uint8_t {
  None,
  LinearSpeed,
  AngularSpeed,
  LinearChange,
  AngularChange,
  Corridor,
  Barrier
};

[[nodiscard]] constexpr const char* to_text(ConstraintKind kind) noexcept {
  switch (kind) {
    case ConstraintKind::None:
      return "none";
    case ConstraintKind::LinearSpeed:
      return "linear speed";
    case ConstraintKind::AngularSpeed:
      return "angular speed";
    case ConstraintKind::LinearChange:
      return "linear acceleration";
    case ConstraintKind::AngularChange:
      return "angular acceleration";
    case ConstraintKind::Corridor:
      return "corridor";
    case ConstraintKind::Barrier:
      return "moving obstacle";
  }
  return "unknown";
}

/// Identifies a constraint of the problem by kind and step. For Barrier, `index` is the obstacle.
/// For Corridor it is the side: 0..3 for min x, max x, min y, max y in the rectangle's frame, + 4
/// for the second rectangle.
struct ConstraintName {
  ConstraintKind kind = ConstraintKind::None;
  int step = 0;
  int index = 0;
};

/// The result of a solver. It is always finite and always satisfies the hard constraints.
struct MpcSolution {
  SolveStatus status = SolveStatus::InvalidProblem;
  int horizon = 0;
  int iterations = 0;
  double cost = 0.0;  ///< objective at the commands, with cost_offset and without the penalty
  double max_violation = 0.0;  ///< greatest violation of a soft constraint [m or m^2]
  double sum_violation = 0.0;  ///< sum of the violations, as in the penalty
  ConstraintName limiting;     ///< the constraint with the greatest multiplier
  std::array<Twist2, kMaxHorizon> commands;
  std::array<Pose2, kMaxHorizon + 1> poses;  ///< the rollout, entry 0 is the start
};

/// Commands from which a solver starts: a shifted earlier solution, clipped to the hard
/// constraints.
struct InitialGuess {
  int count = 0;  ///< number of commands; the last one is repeated, and 0 means a cold start
  std::array<Twist2, kMaxHorizon> commands;
};

struct SpaceTimeWorkspace;

/// Interface of the solvers of the optimal control problem: the real-time solver and IPOPT.
///
/// Navigators that share a solver also share the memory of their plans in space and time. It holds
/// nothing from one cycle to the next.
class ControlSolver {
 public:
  ControlSolver() = default;
  ControlSolver(const ControlSolver&) = delete;
  ControlSolver& operator=(const ControlSolver&) = delete;
  virtual ~ControlSolver() = default;

  /// Solves `problem` from `guess`. The result is finite and satisfies the hard constraints; it
  /// stays valid until the next call.
  [[nodiscard]] virtual const MpcSolution& solve(const ControlProblem& problem,
                                                 const InitialGuess& guess) noexcept = 0;

 private:
  friend class Navigator;
  std::shared_ptr<SpaceTimeWorkspace> plan_memory_;  // of the navigators; null until the first one
};

}  // namespace fairway
