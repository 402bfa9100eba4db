// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/tables/drive_tables.hpp"

namespace fairway::reproduction {

/// Figure 5: corridors, targets and trajectories of all three, and the trajectories on one map.
[[nodiscard]] Figure trajectory_figure(const std::shared_ptr<const DriveRuns>& runs);

/// Figure 6: both speeds of all three with their bounds.
[[nodiscard]] Figure speed_figure(const std::shared_ptr<const DriveRuns>& runs);

/// Every map's change against SMPC, with means and intervals.
[[nodiscard]] Figure change_figure(const std::shared_ptr<const DriveRuns>& runs);

/// Where dual targets leave the robot stuck: the first map of each course; none when it never was.
[[nodiscard]] std::optional<Figure> stuck_figure(
    const std::vector<std::shared_ptr<const DriveRuns>>& courses);

}  // namespace fairway::reproduction
