// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/simulation/scenario.hpp"

namespace fairway {

/// Returns the default radius of the circle for N robots [m]. It is 4 m, or 1.5 m of circumference
/// per robot if that is larger.
[[nodiscard]] double swap_radius(int robots) noexcept;

/// Robots on a circle in open space that swap places with the opposite robot and keep their
/// heading.
///
/// @param seed  Shifts every start by up to 0.05 m along each axis and turns it by up to 0.1 rad;
///             goals do not change. 0: exactly symmetric starts.
/// @pre robots >= 2; radius > 0.
[[nodiscard]] Scenario swap_scenario(int robots,
                                     double radius,
                                     const Settings& settings,
                                     std::uint64_t seed);

}  // namespace fairway
