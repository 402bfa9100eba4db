// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/people/walkers.hpp"

#include <cmath>
#include <utility>

#include "fairway/simulation/people/orca.hpp"
#include "fairway/simulation/people/social_force.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kStep = 0.1;  // [s]

Vector2d preferred_velocity(const Walker& walker, const Vector2d& position) noexcept {
  const Vector2d to_goal = walker.goal - position;
  const double distance = to_goal.norm();
  return distance > walker.speed ? Vector2d(to_goal * (walker.speed / distance)) : to_goal;
}

}  // namespace

std::vector<MovingBody> walk(std::span<const Walker> people, WalkingModel model, double duration) {
  constexpr double kMoreSpeed = 1.3;  // a person may hurry to avoid others
  constexpr double kSpace = 0.1;      // added to the radii that people assume [m]
  std::vector<Walker> walkers(people.begin(), people.end());
  std::vector<MovingBody> bodies;
  std::vector<OrcaNeighbour> now;
  for (const Walker& walker : walkers) {
    bodies.push_back({.name = walker.name,
                      .radius = walker.radius,
                      .key_frames = {{.time = 0.0, .position = walker.start}}});
    now.push_back({.position = walker.start, .radius = walker.radius + kSpace});
  }
  const int steps = static_cast<int>(std::ceil(duration / kStep));
  for (int k = 1; k <= steps; ++k) {
    std::vector<OrcaNeighbour> next = now;
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      const OrcaAgent agent{.position = now[i].position,
                            .velocity = now[i].velocity,
                            .preferred = preferred_velocity(walkers[i], now[i].position),
                            .radius = now[i].radius,
                            .speed_max = kMoreSpeed * walkers[i].speed};
      std::vector<OrcaNeighbour> others = now;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      next[i].velocity = model == WalkingModel::Orca
                             ? orca_velocity(agent, others, {.horizon = 3.0, .step = kStep})
                             : social_force_velocity(agent, others, {.step = kStep});
      next[i].position += kStep * next[i].velocity;
      bodies[i].key_frames.push_back({.time = k * kStep, .position = next[i].position});
      const bool arrived = (next[i].position - walkers[i].goal).norm() < walkers[i].radius;
      if (walkers[i].returns && arrived) std::swap(walkers[i].start, walkers[i].goal);
    }
    now = std::move(next);
  }
  return bodies;
}

}  // namespace fairway
