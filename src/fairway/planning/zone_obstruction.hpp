// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/planning/planner.hpp"

namespace fairway {

/// Explains why zones leave no plan: because of the start, the goal, or every path between them.
/// None if zones are not the reason.
[[nodiscard]] std::optional<std::string> explain_zones(const PreparedMap& map,
                                                       const Eigen::Vector2d& start,
                                                       const Plan& plan,
                                                       double radius);

}  // namespace fairway
