// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// A disc that moves along key frames, whatever happens around it: a person, a cart.
struct MovingBody {
  struct KeyFrame {
    double time = 0.0;  ///< [s]
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
  };

  std::string name;
  double radius = 0.3;               ///< [m]
  std::vector<KeyFrame> key_frames;  ///< times increasing; one frame stands still
  bool loop = false;                 ///< start again after the last frame; else stand there
  bool passing = false;  ///< there only from the first key frame to the last, without `loop`

  /// Whether it is in the world at `time` [s]. @pre there is a key frame.
  [[nodiscard]] bool is_there(double time) const;

  /// Where it is and how it moves at `time` [s], straight between key frames. Before the first
  /// frame it stands at it. Where it is not there its radius is 0. @pre there is a key frame.
  [[nodiscard]] MovingObstacle at(double time) const;
};

/// What was recorded, from `begin` on for `duration` [s], as a run that starts at 0 sees it. Bodies
/// that are not there in that time are left out.
[[nodiscard]] std::vector<MovingBody> replayed(const std::vector<MovingBody>& recorded,
                                               double begin,
                                               double duration);

}  // namespace fairway
