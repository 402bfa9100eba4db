// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/exchange_study.hpp"

namespace fairway::reproduction {

using ExchangeRuns = std::vector<ExchangeComparison>;

/// Figure 11: four moments of the first run, with tracks, predicted trajectories and keep-out
/// discs.
[[nodiscard]] Figure snapshot_figure(const std::shared_ptr<const ExchangeRuns>& runs,
                                     ExchangeKind kind);

/// The distance from each robot to its nearest neighbour over time, in the first run.
[[nodiscard]] Figure separation_figure(const std::shared_ptr<const ExchangeRuns>& runs);

}  // namespace fairway::reproduction
