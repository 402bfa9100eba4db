// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/scenarios/swap_scenario.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "fairway/base/contract.hpp"

namespace fairway {

namespace {

constexpr double kAround = 4.0;      // [m] of open ground around the circle
constexpr double kResolution = 0.1;  // [m]

OccupancyGrid open_ground(double half) {
  const int side = static_cast<int>(std::ceil(2.0 * half / kResolution));
  return OccupancyGrid({.width = side,
                        .height = side,
                        .resolution = kResolution,
                        .origin = {.position = {-half, -half}, .heading = 0.0}});
}

}  // namespace

double swap_radius(int robots) noexcept {
  return std::max(4.0, 1.5 * robots / (2.0 * std::numbers::pi));
}

Scenario swap_scenario(int robots, double radius, const Settings& settings, std::uint64_t seed) {
  FAIRWAY_EXPECTS(robots >= 2 && radius > 0.0);
  constexpr double kMove = 0.05;  // [m]
  constexpr double kTurn = 0.1;   // [rad]
  Scenario scenario;
  scenario.name = "swap of " + std::to_string(robots);
  scenario.map = open_ground(radius + kAround);
  scenario.settings = settings;
  scenario.seed = seed;
  Noise noise(seed);
  const double size = seed == 0 ? 0.0 : 1.0;
  for (int i = 0; i < robots; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / robots;
    const Eigen::Vector2d out = direction(angle);
    const double dx = noise.uniform(-kMove, kMove);
    const double dy = noise.uniform(-kMove, kMove);
    const double turn = noise.uniform(-kTurn, kTurn);
    scenario.robots.push_back({.name = "robot " + std::to_string(i + 1),
                               .start = {.position = radius * out + size * Eigen::Vector2d(dx, dy),
                                         .heading = angle + std::numbers::pi + size * turn},
                               .goal = {.position = -radius * out, .heading = {}}});
  }
  return scenario;
}

}  // namespace fairway
