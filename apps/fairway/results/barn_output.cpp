// SPDX-License-Identifier: Apache-2.0
#include "results/barn_output.hpp"

#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "experiments/barn/barn.hpp"
#include "fairway/simulation/recorded/metrics.hpp"

namespace fairway::app {

namespace {

Json microseconds(const std::vector<double>& seconds) {
  const Quantiles q = quantiles(seconds);
  return Json{{"median", 1e6 * q.median}, {"p99", 1e6 * q.p99}, {"max", 1e6 * q.max}};
}

}  // namespace

Json barn_json(const BarnSummary& summary, const BarnConditions& conditions) {
  Json all = Json::array();
  for (const BarnTrial& trial : summary.trials) {
    const BarnScore& score = trial.score;
    Json row{{"world", score.world},
             {"trial", score.trial},
             {"success", score.success},
             {"collided", score.collided},
             {"time", score.time},
             {"score", score.score},
             {"min_clearance", trial.clearance}};
    if (std::isfinite(trial.separation)) row["min_separation"] = trial.separation;
    all.push_back(std::move(row));
  }
  return Json{{"worlds", std::move(all)},
              {"success_rate", summary.success_rate()},
              {"contact_rate", summary.contact_rate()},
              {"mean_score", summary.mean_score()},
              {"median_arrival", quantiles(summary.arrivals).median},
              {"sensing", conditions.sensing},
              {"physics", conditions.physics},
              {"noise", conditions.noise},
              {"cycle_us", microseconds(summary.cycle_seconds)},
              {"sense_us", microseconds(summary.sense_seconds)},
              {"plan_us", microseconds(summary.plan_seconds)},
              {"note", kBarnNote}};
}

std::string barn_text(const BarnSummary& summary) {
  const Quantiles arrival = quantiles(summary.arrivals);
  const Quantiles cycle = quantiles(summary.cycle_seconds);
  return fmt::format(
      "{} runs: success {:.1f} %, contact {:.1f} %, score {:.4f} of 0.5, median arrival "
      "{:.2f} s, cycle {:.0f}/{:.0f} us median/p99\nNote: {}\n",
      summary.trials.size(), 100.0 * summary.success_rate(), 100.0 * summary.contact_rate(),
      summary.mean_score(), arrival.median, 1e6 * cycle.median, 1e6 * cycle.p99, kBarnNote);
}

}  // namespace fairway::app
