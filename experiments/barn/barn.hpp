// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway {

/// One world of the BARN dataset (static obstacles) or of DynaBARN (moving discs).
struct BarnWorld {
  int number = 0;
  OccupancyGrid map{GridFrame{.width = 1, .height = 1, .resolution = 1.0, .origin = {}}};
  std::vector<MovingBody> bodies;
  Pose2 start;
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();
  double goal_radius = 1.0;   ///< largest distance of the centre from the goal on arrival [m]
  double timeout = 100.0;     ///< [s]
  double optimal_time = 0.0;  ///< OT: length of the reference path at 2 m/s [s]
};

/// Sets the robot of the challenge, a Clearpath Jackal, and its limits in `settings`. It measures
/// 0.458 x 0.416 m and drives up to 2 m/s forward, 0.5 m/s backward and 4 rad/s; we assume
/// accelerations of 2 m/s^2 and 4 rad/s^2.
void use_jackal(Settings& settings);

/// What all runs of BARN share.
struct BarnOptions {
  Settings settings;     ///< of the navigator; `use_jackal` is applied by the caller
  SensingModel sensing;  ///< what the robot knows
  std::uint64_t seed = 1;
  std::optional<RobotModel> model{};  ///< outline and base; none: those of the settings
};

/// The scenario of one trial. Trials of a world differ only in their seed.
[[nodiscard]] Scenario barn_scenario(const BarnWorld& world, const BarnOptions& options, int trial);

/// The score of one trial by the rule of the 2024+ challenge.
struct BarnScore {
  int world = 0;
  int trial = 0;
  bool success = false;   ///< the centre came within goal_radius in time and without contact
  bool collided = false;  ///< touched an obstacle before that
  double time = 0.0;      ///< AT: from the first 0.1 m of motion to the arrival or the end [s]
  double score = 0.0;     ///< success * OT / clip(AT, 2 OT, 8 OT), at most 0.5
};

[[nodiscard]] BarnScore barn_score(const BarnWorld& world, int trial, const EpisodeResult& result);

/// The note to print with every score: without Gazebo, the robot, clock and contact are easier.
inline constexpr const char* kBarnNote =
    "proxy scores: not from Gazebo and not comparable with official BARN results; a simpler robot, "
    "clock and contact make them easier";

}  // namespace fairway
