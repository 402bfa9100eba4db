// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

#include "fairway/map/bit_grid.hpp"
#include "fairway/simulation/episode_observer.hpp"

// The inputs of a run as exact JSON. A number has as many digits as its double needs, and a number
// that is not finite is "NaN", "Infinity" or "-Infinity". The readers throw
// nlohmann::json::exception or std::invalid_argument where a value is missing or has the wrong
// type; `read_recording` turns these into an Error.
namespace fairway::io::exact {

using Json = nlohmann::json;

[[nodiscard]] Json to_json(double value);
[[nodiscard]] double to_number(const Json& json);

[[nodiscard]] Json to_json(const Eigen::Vector2d& point);  ///< [x, y]
[[nodiscard]] Eigen::Vector2d to_point(const Json& json);

[[nodiscard]] Json to_json(const Pose2& pose);  ///< {x, y, heading}
[[nodiscard]] Pose2 to_pose(const Json& json);

[[nodiscard]] Json to_json(const Twist2& twist);  ///< {linear, angular}
[[nodiscard]] Twist2 to_twist(const Json& json);

[[nodiscard]] Json to_json(const MovingObstacle& obstacle);
[[nodiscard]] MovingObstacle to_obstacle(const Json& json);

[[nodiscard]] Json to_json(const OrientedRectangle& rectangle);
[[nodiscard]] OrientedRectangle to_rectangle(const Json& json);

[[nodiscard]] Json to_json(const Goal& goal);
[[nodiscard]] Goal to_goal(const Json& json);

[[nodiscard]] Json to_json(const Plan& plan);
/// @param of_body  Whether it is of a robot with a model, whose plans have no corridor.
[[nodiscard]] Plan to_plan(const Json& json, bool of_body = false);

[[nodiscard]] Json to_json(const GridFrame& frame);
/// @throws std::invalid_argument under the same conditions as OccupancyGrid.
[[nodiscard]] GridFrame to_frame(const Json& json);

/// All cells: frame and bits.
[[nodiscard]] Json to_json(const BitGrid& grid);
[[nodiscard]] BitGrid to_grid(const Json& json);

/// The cells of `now` that differ from `before`, as runs [y, first x, count, blocked, ...].
/// @pre the same frame.
[[nodiscard]] Json changed_cells(const BitGrid& before, const BitGrid& now);
/// Applies such changes.
void change_cells(const Json& runs, BitGrid& grid);

/// The predicted plan of a navigator: its poses, commands and limiting constraint. It is for
/// display, not an input: values are rounded to 1e-4 m, rad, m/s, rad/s.
[[nodiscard]] Json to_json(const MpcSolution& solution);
[[nodiscard]] MpcSolution to_solution(const Json& json);

[[nodiscard]] Json to_json(const LimitMark& mark);
[[nodiscard]] LimitMark to_mark(const Json& json);

}  // namespace fairway::io::exact
