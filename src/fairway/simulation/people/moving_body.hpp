// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/simulation/people/walk_plan.hpp"

namespace fairway {

/// A disc that moves along key frames: a person, a cart. It reacts to others only with a plan.
struct MovingBody {
  struct KeyFrame {
    double time = 0.0;  ///< [s]
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
  };

  std::string name;
  double radius = 0.3;               ///< [m]
  std::vector<KeyFrame> key_frames;  ///< with increasing times; one frame: the body does not move
  bool loop = false;                 ///< start again after the last frame; otherwise stop there
  bool passing = false;  ///< present only from the first key frame to the last; without `loop`
  /// A person who reacts to robots: the world adds a key frame for each step; without `loop`.
  std::optional<WalkPlan> walk{};

  /// Whether it is present at `time` [s]. @pre there is a key frame.
  [[nodiscard]] bool is_there(double time) const;

  /// Its position and velocity at `time` [s], linear between key frames. Before the first frame it
  /// is at that frame. While it is absent its radius is 0. @pre there is a key frame.
  [[nodiscard]] MovingObstacle at(double time) const;
};

/// The recorded bodies from `begin` on for `duration` [s], with times relative to `begin`. Bodies
/// that are absent during that time are left out.
[[nodiscard]] std::vector<MovingBody> replayed(const std::vector<MovingBody>& recorded,
                                               double begin,
                                               double duration);

}  // namespace fairway
