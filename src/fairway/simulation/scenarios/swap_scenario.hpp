// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/simulation/scenario.hpp"

namespace fairway {

/// The radius that N robots on a circle are given by default [m]: the larger of 4 m and 1.5 m of
/// circle per robot.
[[nodiscard]] double swap_radius(int robots) noexcept;

/// Robots on a circle in the open that exchange places with their opposites, looking there.
///
/// @param seed  Moves every start by up to 0.05 m along each axis and turns it by up to 0.1 rad;
///              goals stay. 0 leaves all as it is: exactly symmetric.
/// @pre robots >= 2; radius > 0.
[[nodiscard]] Scenario swap_scenario(int robots,
                                     double radius,
                                     const Settings& settings,
                                     std::uint64_t seed);

}  // namespace fairway
