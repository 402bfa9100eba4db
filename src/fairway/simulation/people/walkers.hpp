// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fairway/simulation/moving_body.hpp"

namespace fairway {

/// How people avoid each other.
enum class WalkingModel : std::uint8_t {
  Orca,         ///< optimal reciprocal collision avoidance, as in the public benchmarks
  SocialForce,  ///< accelerations that repel people from each other (Helbing and Molnar 1995)
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(WalkingModel /*type*/) noexcept {
  return {"orca", "social_force"};
}

/// A person who walks from start to goal among other people.
struct Walker {
  std::string name;
  Eigen::Vector2d start = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();   ///< [m]
  double speed = 1.2;                               ///< without other people [m/s]
  double radius = 0.3;                              ///< [m]
  bool returns = false;                             ///< walks back after arrival, and so on
};

/// Lets people walk for `duration` seconds and returns their tracks, with a key frame every 0.1 s.
///
/// They avoid each other. They see neither robots nor the map.
[[nodiscard]] std::vector<MovingBody> walk(std::span<const Walker> people,
                                           WalkingModel model,
                                           double duration);

}  // namespace fairway
