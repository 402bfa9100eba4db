// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <Eigen/Core>

namespace fairway {

/// How people avoid each other.
enum class WalkingModel : std::uint8_t {
  Orca,         ///< optimal reciprocal collision avoidance, as in the public benchmarks
  SocialForce,  ///< accelerations that repel people from each other (Helbing and Molnar 1995)
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(WalkingModel /*type*/) noexcept {
  return {"orca", "social_force"};
}

/// Where a person walks who reacts to others.
struct WalkPlan {
  WalkingModel model = WalkingModel::Orca;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d to = Eigen::Vector2d::Zero();    ///< [m]
  double speed = 1.2;                              ///< without other people [m/s]
  bool returns = false;                            ///< walks back after arrival, and so on
  std::string group{};  ///< people with the same text stay together; empty: walks alone
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< now [m/s]
};

}  // namespace fairway
