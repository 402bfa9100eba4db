// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/navigation/navigation_step.hpp"
#include "fairway/perception/perception.hpp"

namespace fairway {

/// The time that represents a missing measurement [s].
inline constexpr double kNeverMeasured = -1e9;

/// Makes the input of a cycle from its measurements, without a map.
[[nodiscard]] NavigationInput input_of(const Measurements& measurements) noexcept;

/// Adds the obstacles that the robot's own lidar tracks to those of other trackers. All positions
/// are predicted to the older of the two times. @param merged  Storage for the result until the
/// next call; keeps its memory.
void merge_tracked(const Perception& perception,
                   std::vector<MovingObstacle>& merged,
                   NavigationInput& input);

}  // namespace fairway
