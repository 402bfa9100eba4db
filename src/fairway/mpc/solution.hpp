// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "fairway/mpc/control_problem.hpp"

namespace fairway {

/// Why a solve ended.
enum class SolveStatus : std::uint8_t {
  Solved,          ///< optimal to tolerance, every row satisfied
  LeastViolation,  ///< optimal to tolerance, but the rows cannot all hold: the least violation
  IterationLimit,  ///< the iteration budget ran out; the best iterate is returned
  Stalled,         ///< no further progress was possible before the tolerance; best iterate returned
  InvalidProblem,  ///< a number is not finite, or sizes or bounds contradict; commands are zero
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

/// Which row holds the solution back most.
enum class RowKind : std::uint8_t {
  None,
  LinearSpeed,
  AngularSpeed,
  LinearChange,
  AngularChange,
  Corridor,
  Barrier
};

[[nodiscard]] constexpr const char* to_text(RowKind kind) noexcept {
  switch (kind) {
    case RowKind::None:
      return "none";
    case RowKind::LinearSpeed:
      return "linear speed";
    case RowKind::AngularSpeed:
      return "angular speed";
    case RowKind::LinearChange:
      return "linear acceleration";
    case RowKind::AngularChange:
      return "angular acceleration";
    case RowKind::Corridor:
      return "corridor";
    case RowKind::Barrier:
      return "moving obstacle";
  }
  return "unknown";
}

/// A row of the problem: which kind, at which step, and for Barrier which obstacle, for Corridor
/// which side (0..3: min x, max x, min y, max y in the rectangle's frame; + 4 for the second
/// rectangle).
struct RowName {
  RowKind kind = RowKind::None;
  int step = 0;
  int index = 0;
};

/// What a solver returns: always finite, always within the hard rows.
struct MpcSolution {
  SolveStatus status = SolveStatus::InvalidProblem;
  int horizon = 0;
  int iterations = 0;
  double cost = 0.0;  ///< objective at the commands, cost_offset included, penalty excluded
  double max_violation = 0.0;  ///< greatest violation of an elastic row [m or m^2]
  double sum_violation = 0.0;  ///< their sum, as the penalty counts it
  RowName limiting;            ///< the row with the greatest multiplier
  std::array<Twist2, kMaxHorizon> commands;
  std::array<Pose2, kMaxHorizon + 1> poses;  ///< the rollout, entry 0 is the start
};

/// Where a solver starts: commands of an earlier solution, shifted. Clipped to the hard rows.
struct InitialGuess {
  int count = 0;  ///< commands given; the last is repeated, none means zero commands (cold)
  std::array<Twist2, kMaxHorizon> commands;
};

}  // namespace fairway
