// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fairway/corridor/corridor.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/io/drawing/canvas.hpp"
#include "fairway/io/drawing/plot_axes.hpp"
#include "fairway/map/occupancy_grid.hpp"
#include "fairway/path/path.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway::io {

/// What is drawn of one robot; empty parts are omitted from the picture and its legend.
struct RobotDrawing {
  std::string name;
  double radius = 0.0;  ///< of its circumscribed disc [m]
  Pose2 start;
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();
  Path path;
  Corridor corridor;
  std::vector<Pose2> track;  ///< driven poses, equally spaced in time
  /// True outline in its frame: polygons; empty for one that is drawn as its disc.
  std::vector<std::vector<Eigen::Vector2d>> outlines{};
};

/// What is drawn of one moving obstacle.
struct BodyDrawing {
  double radius = 0.0;                 ///< [m]
  std::vector<Eigen::Vector2d> track;  ///< its centre, equally spaced in time
};

/// A picture of a world from above, like the paper's Figure 5.
struct WorldDrawing {
  const OccupancyGrid* map = nullptr;  ///< none: open space
  std::vector<RobotDrawing> robots;
  std::vector<BodyDrawing> bodies;
  Zones zones{};
};

/// The part of the world that is shown: all robots' motion, with a margin, within the map.
[[nodiscard]] Box shown_region(const WorldDrawing& world);

/// Where a picture of `region` shows the world, in points.
[[nodiscard]] PlotAxes world_axes(const WorldDrawing& world, const Box& region);

/// The bytes of the picture file. @param region  The part that is shown.
[[nodiscard]] Expected<std::string> draw_world(const WorldDrawing& world,
                                               PictureFormat format,
                                               const Box& region);
[[nodiscard]] Expected<std::string> draw_world(const WorldDrawing& world, PictureFormat format);

}  // namespace fairway::io
