// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/people_summary.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace fairway {

namespace {

double mean_of_successes(const std::vector<PeopleRun>& runs, double PeopleRun::*value) noexcept {
  double sum = 0.0;
  double count = 0.0;
  for (const PeopleRun& run : runs) {
    if (run.outcome != PeopleOutcome::Success) continue;
    sum += run.*value;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

void PeopleSummary::add(PeopleRun run) {
  cycle_seconds.insert(cycle_seconds.end(), run.cycle_seconds.begin(), run.cycle_seconds.end());
  run.cycle_seconds = {};
  run.rows = {};
  runs.push_back(std::move(run));
}

std::size_t PeopleSummary::count(PeopleOutcome outcome) const noexcept {
  return static_cast<std::size_t>(std::count_if(
      runs.begin(), runs.end(), [&](const PeopleRun& run) { return run.outcome == outcome; }));
}

double PeopleSummary::share(PeopleOutcome outcome) const noexcept {
  return runs.empty() ? 0.0
                      : static_cast<double>(count(outcome)) / static_cast<double>(runs.size());
}

double PeopleSummary::mean_time() const noexcept {
  return mean_of_successes(runs, &PeopleRun::time);
}

double PeopleSummary::mean_path() const noexcept {
  return mean_of_successes(runs, &PeopleRun::path);
}

double PeopleSummary::mean_closest() const noexcept {
  return mean_of_successes(runs, &PeopleRun::closest);
}

double PeopleSummary::danger_rate() const noexcept {
  double danger = 0.0;
  double steps = 0.0;
  for (const PeopleRun& run : runs) {
    danger += run.danger;
    steps += run.steps;
  }
  return steps > 0.0 ? danger / steps : 0.0;
}

double PeopleSummary::contact_between_steps_rate() const noexcept {
  const auto touched = std::count_if(
      runs.begin(), runs.end(), [](const PeopleRun& run) { return run.contact_between_steps; });
  return runs.empty() ? 0.0 : static_cast<double>(touched) / static_cast<double>(runs.size());
}

std::string people_rows_csv(const PeopleRun& run) {
  std::string text;
  for (const PeopleRow& row : run.rows) {
    text += fmt::format("{},{:.3f},{:.7f},{:.7f},{:.7f}\n", run.number, row.time,
                        row.pose.position.x(), row.pose.position.y(), row.pose.heading);
  }
  return text;
}

}  // namespace fairway
