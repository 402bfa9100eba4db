// SPDX-License-Identifier: Apache-2.0
#include "results/solve_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "fairway/simulation/recorded/metrics.hpp"

namespace fairway::app {

namespace {

template <typename Predicate>
ClassSummary summary_of(const std::string& kind,
                        std::span<const SolvedInstance> instances,
                        Predicate&& belongs) {
  ClassSummary summary{.kind = kind};
  std::vector<double> times;
  for (const SolvedInstance& instance : instances) {
    if (!belongs(instance)) continue;
    times.push_back(instance.time_us);
    if (instance.solution.status == SolveStatus::Solved) ++summary.solved;
  }
  const Quantiles q = quantiles(times);
  summary.count = times.size();
  summary.median_us = q.median;
  summary.p99_us = q.p99;
  summary.max_us = q.max;
  return summary;
}

// Rounds times to a nanosecond, without the digits of binary fractions.
double rounded(double time_us) { return std::round(1e3 * time_us) / 1e3; }

Json as_json(const ClassSummary& summary) {
  return {{"class", summary.kind},
          {"count", summary.count},
          {"solved", summary.solved},
          {"median_us", rounded(summary.median_us)},
          {"p99_us", rounded(summary.p99_us)},
          {"max_us", rounded(summary.max_us)}};
}

Json as_json(const SolvedInstance& instance) {
  const MpcSolution& solution = instance.solution;
  return {{"id", instance.id},
          {"class", instance.kind},
          {"status", to_text(solution.status)},
          {"iterations", solution.iterations},
          {"time_us", rounded(instance.time_us)},
          {"cost", solution.cost},
          {"max_violation", solution.max_violation},
          {"sum_violation", solution.sum_violation},
          {"limiting", to_text(solution.limiting.kind)},
          {"limiting_step", solution.limiting.step},
          {"limiting_index", solution.limiting.index}};
}

}  // namespace

std::vector<ClassSummary> summarise(std::span<const SolvedInstance> instances) {
  std::vector<std::string> kinds;
  for (const SolvedInstance& instance : instances) {
    if (std::find(kinds.begin(), kinds.end(), instance.kind) == kinds.end())
      kinds.push_back(instance.kind);
  }
  std::vector<ClassSummary> summaries;
  for (const std::string& kind : kinds) {
    summaries.push_back(
        summary_of(kind, instances, [&](const SolvedInstance& i) { return i.kind == kind; }));
  }
  if (kinds.size() > 1)
    summaries.push_back(summary_of("all", instances, [](const SolvedInstance&) { return true; }));
  return summaries;
}

Json solve_report(const std::string& solver,
                  int starts,
                  int repeat,
                  std::span<const SolvedInstance> instances) {
  Json report{{"solver", solver}, {"starts", starts}, {"repeat", repeat}};
  report["classes"] = Json::array();
  for (const ClassSummary& summary : summarise(instances))
    report["classes"].push_back(as_json(summary));
  report["instances"] = Json::array();
  for (const SolvedInstance& instance : instances)
    report["instances"].push_back(as_json(instance));
  return report;
}

std::string solve_table(std::span<const SolvedInstance> instances) {
  std::string table = "class        count  solved  median us     p99 us     max us\n";
  for (const ClassSummary& s : summarise(instances)) {
    table += fmt::format("{:<12} {:>5} {:>7} {:>10.1f} {:>10.1f} {:>10.1f}\n", s.kind, s.count,
                         s.solved, s.median_us, s.p99_us, s.max_us);
  }
  return table;
}

}  // namespace fairway::app
