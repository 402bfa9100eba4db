// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/people/social_force.hpp"

#include <cmath>

namespace fairway {

using Eigen::Vector2d;

Vector2d social_force_velocity(const OrcaAgent& agent,
                               std::span<const OrcaNeighbour> neighbours,
                               const SocialForceSettings& settings) noexcept {
  Vector2d acceleration = (agent.preferred - agent.velocity) / settings.relaxation;
  const double speed = agent.preferred.norm();
  for (const OrcaNeighbour& other : neighbours) {
    const Vector2d apart = agent.position - other.position;
    const double distance = apart.norm();
    const Vector2d away = distance > 0.0 ? Vector2d(apart / distance) : Vector2d::UnitX();
    const double ahead = speed > 0.0 ? -agent.preferred.dot(away) / speed : 0.0;
    const double weight = settings.behind + (1.0 - settings.behind) * 0.5 * (1.0 + ahead);
    const double gap = distance - agent.radius - other.radius;
    acceleration += weight * settings.strength * std::exp(-gap / settings.range) * away;
  }
  const Vector2d velocity = agent.velocity + settings.step * acceleration;
  const double fast = velocity.norm();
  return fast > agent.speed_max ? Vector2d(velocity * (agent.speed_max / fast)) : velocity;
}

}  // namespace fairway
