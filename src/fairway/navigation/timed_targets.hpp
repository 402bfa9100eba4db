// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/navigation/corridor_string.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway {

/// One target per step, moving along the string as fast as the robot may and can: our default.
///
/// Speed: from `speed` up with the acceleration limit to linear_max, down in time for the string's
/// turns and for the goal. At a turn by angle a, a circle that leaves the corner by at most
/// `corner_deviation` has radius deviation / (1 / cos(a/2) - 1), and the angular speed limit bounds
/// the speed on it. A robot that looks elsewhere turns first: the targets wait. Heading: the chord
/// from the target to the point `chord_length` further on, which does not jump where the string
/// does; at the goal the goal's heading, if it has one. Not wrapped: within pi of `heading` and of
/// the step before.
///
/// @param free_length  Arc length up to which the string is known to be free [m]; the speed is such
///        that the robot can stand before it.
void set_timed_targets(const StringAhead& string,
                       double speed,
                       double heading,
                       const std::optional<double>& goal_heading,
                       const Settings& settings,
                       ControlProblem& problem,
                       double free_length = std::numeric_limits<double>::infinity()) noexcept;

}  // namespace fairway
