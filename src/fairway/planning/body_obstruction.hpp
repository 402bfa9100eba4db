// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/planning/path_obstruction.hpp"

namespace fairway {

/// Finds the obstruction that keeps a body of any shape from the goal of `plan`.
///
/// A start or goal counts by the distance of the reference point from the nearest obstacle;
/// `needed` is then the covering radius. A gap counts against the width of the body where it is
/// narrower than that, and otherwise against the diameter of the covering disc, since the body or
/// its base cannot turn there. It takes O(cells); do not call it in a control cycle.
/// @return none if the plan has a path, an end outside the map, or an invalid input.
[[nodiscard]] std::optional<PathObstruction> find_body_obstruction(const PreparedMap& map,
                                                                   const BodyShape& body,
                                                                   const Eigen::Vector2d& start,
                                                                   const Plan& plan);

/// Explains in one sentence with numbers why a body has no drive. The text is empty if the plan is
/// usable. Parameters are as in find_body_obstruction.
[[nodiscard]] std::string explain_body(const PreparedMap& map,
                                       const BodyShape& body,
                                       const Eigen::Vector2d& start,
                                       const Plan& plan);

}  // namespace fairway
