// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fairway/simulation/people/moving_body.hpp"
#include "fairway/simulation/people/orca.hpp"

namespace fairway {

/// A person who walks from start to goal among other people.
struct Walker {
  std::string name;
  Eigen::Vector2d start = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();   ///< [m]
  double speed = 1.2;                               ///< without other people [m/s]
  double radius = 0.3;                              ///< [m]
  bool returns = false;                             ///< walks back after arrival, and so on
  /// People with the same text walk at the speed of their slowest and stay together. Empty: alone.
  std::string group{};
};

/// Returns the people at their starts, with the plans by which `walk_on` moves them.
[[nodiscard]] std::vector<MovingBody> walking_bodies(std::span<const Walker> people,
                                                     WalkingModel model);

/// Adds a key frame, 0.1 s later, to each body with a plan whose last one is before `time` [s].
///
/// These people avoid each other, bodies without a plan, and the discs of `robots` as they avoid
/// people. They do not see the map.
void walk_on(std::vector<MovingBody>& bodies, std::span<const OrcaNeighbour> robots, double time);

/// Lets people walk for `duration` seconds and returns their tracks, with a key frame every 0.1 s.
///
/// They avoid each other. They see neither robots nor the map.
[[nodiscard]] std::vector<MovingBody> walk(std::span<const Walker> people,
                                           WalkingModel model,
                                           double duration);

}  // namespace fairway
