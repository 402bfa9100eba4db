// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/barn/barn.hpp"

namespace fairway {

/// One trial of one world with its reported values.
struct BarnTrial {
  BarnScore score;
  double clearance = 0.0;   ///< least distance to a static obstacle [m]
  double separation = 0.0;  ///< least distance to a moving body [m]; infinite without any
};

/// All trials, and the pooled times of their control cycles.
struct BarnSummary {
  std::vector<BarnTrial> trials;
  std::vector<double> arrivals;  ///< of the successful trials [s]
  std::vector<double> cycle_seconds;
  std::vector<double> sense_seconds;
  std::vector<double> plan_seconds;

  /// @pre `result` is of a scenario with one robot.
  void add(const BarnScore& score, const EpisodeResult& result);

  // Means over all trials; 0 without trials.
  [[nodiscard]] double success_rate() const;
  [[nodiscard]] double contact_rate() const;
  [[nodiscard]] double mean_score() const;
};

}  // namespace fairway
