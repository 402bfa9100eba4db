// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway::app {

/// An instance and its result.
struct SolvedInstance {
  int id = 0;
  std::string kind;      ///< its class: free, dyn, tight, ...
  double time_us = 0.0;  ///< fastest repeat: CPU time of the thread for all starts [us]
  MpcSolution solution;
};

/// The number of solved instances of a class, and their times.
struct ClassSummary {
  std::string kind;
  std::size_t count = 0;
  std::size_t solved = 0;
  double median_us = 0.0;
  double p99_us = 0.0;
  double max_us = 0.0;
};

/// One summary per class in order of appearance, and one for `all` with several classes.
[[nodiscard]] std::vector<ClassSummary> summarise(std::span<const SolvedInstance> instances);

/// The results and summaries as JSON.
[[nodiscard]] Json solve_report(const std::string& solver,
                                int starts,
                                int repeat,
                                std::span<const SolvedInstance> instances);

/// The summaries as a table for the user.
[[nodiscard]] std::string solve_table(std::span<const SolvedInstance> instances);

}  // namespace fairway::app
