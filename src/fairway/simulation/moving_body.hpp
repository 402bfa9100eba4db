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

  /// Where it is and how it moves at `time` [s], straight between key frames. Before the first
  /// frame it stands at it. @pre there is a key frame.
  [[nodiscard]] MovingObstacle at(double time) const;
};

}  // namespace fairway
