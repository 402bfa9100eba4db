// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fairway/corridor/corridor.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/io/drawing/canvas.hpp"
#include "fairway/map/occupancy_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway::io {

/// What is drawn of one robot; empty parts are left out, of the picture and of its legend.
struct RobotDrawing {
  std::string name;
  double radius = 0.0;  ///< of the disc that covers it [m]
  Pose2 start;
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();
  Path path;
  Corridor corridor;
  std::vector<Pose2> track;  ///< where it drove, at equal times
};

/// What is drawn of something that moves on its own.
struct BodyDrawing {
  double radius = 0.0;                 ///< [m]
  std::vector<Eigen::Vector2d> track;  ///< its centre, at equal times
};

/// A picture of a world from above, like the paper's Figure 5.
struct WorldDrawing {
  const OccupancyGrid* map = nullptr;  ///< none: open space
  std::vector<RobotDrawing> robots;
  std::vector<BodyDrawing> bodies;
};

/// The part of the world that is shown: whatever the robots do, with a margin, within the map.
[[nodiscard]] Box shown_region(const WorldDrawing& world);

/// The bytes of the picture file.
[[nodiscard]] Expected<std::string> draw_world(const WorldDrawing& world, PictureFormat format);

}  // namespace fairway::io
