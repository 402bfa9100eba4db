// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

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

}  // namespace fairway
