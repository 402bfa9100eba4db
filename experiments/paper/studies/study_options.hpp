// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "fairway/mpc/control_solver.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::reproduction {

/// What a study is run with.
struct StudyOptions {
  std::uint64_t seed = 0;  ///< of the map that the figures show; see map_seed for the others
  int maps = 0;     ///< how many maps the means are taken over; 0: as many as the study likes
  int threads = 1;  ///< results do not depend on it
  Settings ours{};  ///< of the runs called "ours"; each case sets the body
  /// A new solver for each run; null makes the default.
  std::function<std::unique_ptr<ControlSolver>()> make_solver;
  /// Thread CPU time [s]; must work in every thread.
  std::function<double()> clock;
  /// Told what is being done; called by one thread at a time.
  std::function<void(const std::string&)> progress;
};

/// The seed of map `index` of a study.
[[nodiscard]] inline std::uint64_t map_seed(const StudyOptions& options,
                                            std::size_t index) noexcept {
  return options.seed + index;
}

}  // namespace fairway::reproduction
