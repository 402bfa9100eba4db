// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/geometry/pose2.hpp"
#include "fairway/io/drawing/canvas.hpp"

namespace fairway::io {

/// One robot's speeds over time.
struct SpeedSeries {
  std::string name;
  std::vector<double> time;      ///< [s], increasing
  std::vector<Twist2> commands;  ///< as sent, one per time
  std::vector<Twist2> executed;  ///< as measured, one per time; may be empty
};

/// A picture of speeds over time with their limits, like the paper's Figure 6: linear speed above,
/// angular speed below.
struct SpeedDrawing {
  std::vector<SpeedSeries> robots;
  Twist2 min;  ///< lower speed limits
  Twist2 max;  ///< upper speed limits
};

/// The bytes of the picture file.
[[nodiscard]] Expected<std::string> draw_speeds(const SpeedDrawing& drawing, PictureFormat format);

}  // namespace fairway::io
