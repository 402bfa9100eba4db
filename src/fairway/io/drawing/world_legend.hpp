// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/io/drawing/plot_axes.hpp"
#include "fairway/io/drawing/world_picture.hpp"

namespace fairway::io {

/// How moving obstacles are drawn.
inline const Stroke kBodyStroke{.color = palette::kPurple, .width = 1.0};

/// The colours of one robot's parts; with several robots each robot has one colour.
struct RobotColors {
  Color corridor = palette::kGreen;
  Color path = palette::kOrange;
  Color seed = palette::kVermilion;
  Color track = palette::kBlue;
};

[[nodiscard]] RobotColors colors_of(std::size_t robot, std::size_t count);

/// Lists an entry for everything that a picture of `region` shows.
[[nodiscard]] std::vector<LegendEntry> world_legend(const WorldDrawing& world, const Box& region);

}  // namespace fairway::io
