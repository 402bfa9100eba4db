// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/io/drawing/plot_axes.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::io {

/// Colours of cells in pictures.
inline constexpr Color kFreeColor = rgb(255, 255, 255);
inline constexpr Color kOccupiedColor = rgb(60, 60, 60);
inline constexpr Color kUnknownColor = rgb(217, 217, 217);

/// Whether `region` of the world may contain a cell of the given state.
[[nodiscard]] bool shows(const OccupancyGrid& map, const Box& region, CellState state);

/// Draws the cells that the axes show. Where cells are smaller than a visible dot, several become
/// one pixel in the colour of the darkest, so that thin walls stay visible.
void draw_map(Canvas& canvas, const PlotAxes& axes, const OccupancyGrid& map);

}  // namespace fairway::io
