// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/drive_runs.hpp"

namespace fairway::reproduction {

/// Means of every measure for every driver.
[[nodiscard]] Table drive_table(const DriveRuns& runs);
/// The single map of Figures 5 and 6.
[[nodiscard]] Table drive_example_table(const DriveComparison& map);
/// Changes between drivers with the test.
[[nodiscard]] Table drive_change_table(const DriveRuns& runs);
/// The arrivals of every driver on every course.
[[nodiscard]] Table arrival_table(const std::vector<DriveRuns>& courses);
/// Times per solve.
[[nodiscard]] Table solve_times(const std::vector<DriveRuns>& courses);

[[nodiscard]] Json drive_numbers(const std::vector<DriveRuns>& courses);
[[nodiscard]] Json drive_timing(const std::vector<DriveRuns>& courses);

}  // namespace fairway::reproduction
