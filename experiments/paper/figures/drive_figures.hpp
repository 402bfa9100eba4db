// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/drive_runs.hpp"

namespace fairway::reproduction {

/// Figure 5: corridors, targets and trajectories of all three, and the trajectories on one map.
[[nodiscard]] Figure trajectory_figure(const std::shared_ptr<const DriveRuns>& runs);

/// Figure 6: both speeds of all three with their bounds.
[[nodiscard]] Figure speed_figure(const std::shared_ptr<const DriveRuns>& runs);

/// Every map's change against SMPC, with means and intervals.
[[nodiscard]] Figure change_figure(const std::shared_ptr<const DriveRuns>& runs);

}  // namespace fairway::reproduction
