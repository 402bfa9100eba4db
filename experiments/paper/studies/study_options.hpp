// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::reproduction {

/// The inputs of a study.
struct StudyOptions {
  std::uint64_t seed = 0;  ///< of the map in the figures; see map_seed for the others
  int maps = 0;            ///< number of maps for the means; 0: the study's default
  int threads = 1;         ///< number of threads; it does not change the results
  Settings ours{};         ///< of the runs called "ours"; each case sets the body
  /// A new solver for each run; null makes the default.
  std::function<std::unique_ptr<ControlSolver>()> make_solver;
  /// Thread CPU time [s]; must work in every thread.
  std::function<double()> clock;
  /// Receives the current state of work; called by one thread at a time.
  std::function<void(const std::string&)> progress;
};

/// The seed of map `index` of a study.
[[nodiscard]] inline std::uint64_t map_seed(const StudyOptions& options,
                                            std::size_t index) noexcept {
  return options.seed + index;
}

}  // namespace fairway::reproduction
