// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_walls.hpp"

#include <cmath>
#include <sstream>

#include "fairway/simulation/physics/cell_boxes.hpp"

namespace fairway {

using Eigen::Vector2d;

std::string turn_about_vertical(double heading) {
  std::ostringstream text;
  text.precision(17);
  text << std::cos(0.5 * heading) << " 0 0 " << std::sin(0.5 * heading);
  return text.str();
}

void write_walls(std::ostream& xml, const BitGrid& obstacles, std::string_view more) {
  const GridFrame& frame = obstacles.frame();
  for (const CellWindow& box : cover_with_boxes(obstacles)) {
    const Vector2d cells(box.last.x - box.first.x + 1, box.last.y - box.first.y + 1);
    const Vector2d center = frame.to_world(Vector2d(box.first.x, box.first.y) + 0.5 * cells);
    const Vector2d half = 0.5 * frame.resolution * cells;
    xml << "<geom type='box' pos='" << center.x() << ' ' << center.y() << ' ' << 0.5 * kWallHeight
        << "' size='" << half.x() << ' ' << half.y() << ' ' << 0.5 * kWallHeight << "' quat='"
        << turn_about_vertical(frame.origin.heading) << "' contype='2' conaffinity='2'" << more
        << "/>\n";
  }
}

}  // namespace fairway
