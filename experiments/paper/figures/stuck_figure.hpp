// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/drive_runs.hpp"

namespace fairway::reproduction {

/// Where dual targets leave the robot stuck, on the first such map of each course; none without
/// one.
[[nodiscard]] std::optional<Figure> stuck_figure(
    const std::vector<std::shared_ptr<const DriveRuns>>& courses);

}  // namespace fairway::reproduction
