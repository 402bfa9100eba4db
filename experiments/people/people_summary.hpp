// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/people/people_runs.hpp"

namespace fairway {

/// The runs of a benchmark, and what is published about them: means over successful runs.
struct PeopleSummary {
  std::vector<PeopleRun> runs;  ///< without rows and cycles
  std::vector<double> cycle_seconds;

  /// Adds a run; keeps its cycles, and drops its rows.
  void add(PeopleRun run);

  [[nodiscard]] std::size_t count(PeopleOutcome outcome) const noexcept;
  [[nodiscard]] double share(PeopleOutcome outcome) const noexcept;
  [[nodiscard]] double mean_time() const noexcept;     ///< of successes [s]
  [[nodiscard]] double mean_path() const noexcept;     ///< of successes [m]
  [[nodiscard]] double mean_closest() const noexcept;  ///< of successes [m]
  [[nodiscard]] double danger_rate() const noexcept;   ///< share of all steps
  /// Share of the runs whose true motion touched a person, also between steps.
  [[nodiscard]] double contact_between_steps_rate() const noexcept;
};

/// The rows of a run as CSV lines: case,time,x,y,heading.
[[nodiscard]] std::string people_rows_csv(const PeopleRun& run);

}  // namespace fairway
