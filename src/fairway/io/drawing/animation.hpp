// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fairway/io/drawing/world_picture.hpp"

namespace fairway::io {

/// Something that moves in an animation.
struct MovingDrawing {
  Color color;
  double radius = 0.0;                                  ///< of its disc, without an outline [m]
  std::vector<std::vector<Eigen::Vector2d>> outline{};  ///< polygons in its own frame [m]
  bool heading = false;                                 ///< whether its front is marked
  std::vector<std::optional<Pose2>> poses;              ///< by frame; none: it is not there
};

/// A run that is played in an endless loop.
struct Animation {
  WorldDrawing world;  ///< stands still
  Box region;          ///< the part of the world that is shown
  std::vector<MovingDrawing> moving;
  double interval = 0.1;  ///< between two frames [s]
  double pace = 1.0;      ///< seconds of the run in a second of the animation
};

/// The animation as an SVG file, which browsers and most viewers of documents play.
/// @pre all parts that move have the same number of poses, at least one.
[[nodiscard]] Expected<std::string> draw_animation(const Animation& animation);

}  // namespace fairway::io
