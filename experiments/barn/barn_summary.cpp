// SPDX-License-Identifier: Apache-2.0
#include "experiments/barn/barn_summary.hpp"

namespace fairway {

namespace {

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

template <typename Value>
double mean_over(const std::vector<BarnTrial>& trials, Value BarnScore::*value) {
  double sum = 0.0;
  for (const BarnTrial& trial : trials)
    sum += static_cast<double>(trial.score.*value);
  return trials.empty() ? 0.0 : sum / static_cast<double>(trials.size());
}

}  // namespace

void BarnSummary::add(const BarnScore& score, const EpisodeResult& result) {
  const RobotResult& robot = result.robots.front();
  trials.push_back({score, robot.min_clearance, robot.min_separation});
  if (score.success) arrivals.push_back(score.time);
  append(cycle_seconds, robot.cycle_seconds);
  append(sense_seconds, robot.sense_seconds);
  append(plan_seconds, robot.plan_seconds);
}

double BarnSummary::success_rate() const { return mean_over(trials, &BarnScore::success); }

double BarnSummary::contact_rate() const { return mean_over(trials, &BarnScore::collided); }

double BarnSummary::mean_score() const { return mean_over(trials, &BarnScore::score); }

}  // namespace fairway
