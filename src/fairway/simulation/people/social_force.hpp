// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/simulation/people/orca.hpp"

namespace fairway {

/// Parameters of the social force model.
struct SocialForceSettings {
  double relaxation = 0.5;  ///< time in which a person returns to the preferred velocity [s]
  double strength = 3.0;    ///< acceleration away from a body that is touched [m/s^2]
  double range = 0.4;       ///< distance in which it falls to 1/e [m]
  double behind = 0.3;      ///< share of it for people behind, 0 to 1
  double step = 0.1;        ///< length of a step [s]
};

/// Returns the velocity of a person after a step under social forces (Helbing and Molnar 1995,
/// circular bodies). One force pulls to the preferred velocity. Each neighbour pushes away with a
/// force that falls exponentially with the gap between the bodies and is weaker for those behind.
[[nodiscard]] Eigen::Vector2d social_force_velocity(const OrcaAgent& agent,
                                                    std::span<const OrcaNeighbour> neighbours,
                                                    const SocialForceSettings& settings) noexcept;

}  // namespace fairway
