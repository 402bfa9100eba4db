// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway::app {

/// An instance and its answer.
struct SolvedInstance {
  int id = 0;
  std::string kind;      ///< its class: free, dyn, tight, ...
  double time_us = 0.0;  ///< fastest repeat, CPU time of the thread, all starts together [us]
  MpcSolution solution;
};

/// How many of a class were solved, and how fast.
struct ClassSummary {
  std::string kind;
  std::size_t count = 0;
  std::size_t solved = 0;
  double median_us = 0.0;
  double p99_us = 0.0;
  double max_us = 0.0;
};

/// One summary per class in order of appearance, and one for `all` where there are several.
[[nodiscard]] std::vector<ClassSummary> summarise(std::span<const SolvedInstance> instances);

/// All of it as JSON.
[[nodiscard]] Json solve_report(const std::string& solver,
                                int starts,
                                int repeat,
                                std::span<const SolvedInstance> instances);

/// The summaries as a table for people.
[[nodiscard]] std::string solve_table(std::span<const SolvedInstance> instances);

}  // namespace fairway::app
