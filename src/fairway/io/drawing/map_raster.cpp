// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/map_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fairway::io {

namespace {

using Eigen::Vector2d;

constexpr int kMostPixels = 3000;  // per side; more than a printed column can show

struct CellBox {
  CellIndex first;
  CellIndex last;
};

// The cells of the grid that a box of the world may touch.
CellBox cells_in(const Box& box, const GridFrame& frame) {
  Vector2d low = Vector2d::Constant(1e18);
  Vector2d high = -low;
  for (const double x : {box.min.x(), box.max.x()}) {
    for (const double y : {box.min.y(), box.max.y()}) {
      const Vector2d g = frame.to_grid({x, y});
      low = low.cwiseMin(g);
      high = high.cwiseMax(g);
    }
  }
  const auto cell = [](double v, int count) {
    return static_cast<int>(std::clamp(std::floor(v), 0.0, static_cast<double>(count - 1)));
  };
  return {.first = {cell(low.x(), frame.width), cell(low.y(), frame.height)},
          .last = {cell(high.x(), frame.width), cell(high.y(), frame.height)}};
}

std::uint32_t packed(const Color& color) {
  const auto byte = [](double share) {
    return static_cast<std::uint32_t>(std::lround(255.0 * share));
  };
  return byte(color.red) << 16U | byte(color.green) << 8U | byte(color.blue);
}

// In the order of CellState; darker cells take precedence.
const std::array<std::uint32_t, 3> kColors = {packed(kFreeColor), packed(kOccupiedColor),
                                              packed(kUnknownColor)};

}  // namespace

bool shows(const OccupancyGrid& map, const Box& region, CellState state) {
  const CellBox cells = cells_in(region, map.frame());
  for (int y = cells.first.y; y <= cells.last.y; ++y) {
    for (int x = cells.first.x; x <= cells.last.x; ++x) {
      if (map.at({x, y}) == state) return true;
    }
  }
  return false;
}

void draw_map(Canvas& canvas, const PlotAxes& axes, const OccupancyGrid& map) {
  const CellBox cells = cells_in(axes.data(), map.frame());
  const int columns = cells.last.x - cells.first.x + 1;
  const int rows = cells.last.y - cells.first.y + 1;
  const int block = (std::max(columns, rows) + kMostPixels - 1) / kMostPixels;
  Raster raster{
      .width = (columns + block - 1) / block, .height = (rows + block - 1) / block, .pixels = {}};
  raster.pixels.assign(
      static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height),
      packed(kFreeColor));
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const CellState state = map.at({cells.first.x + x, cells.last.y - y});
      std::uint32_t& pixel =
          raster
              .pixels[static_cast<std::size_t>(y / block) * static_cast<std::size_t>(raster.width) +
                      static_cast<std::size_t>(x / block)];
      pixel = std::min(pixel, kColors.at(static_cast<std::size_t>(state)));
    }
  }
  const auto at = [&](double x, double y) { return axes.at(map.frame().to_world({x, y})); };
  const double left = cells.first.x;
  const double top = cells.last.y + 1.0;
  const Vector2d corner = at(left, top);
  canvas.image(raster, corner, at(left + block, top) - corner, at(left, top - block) - corner);
}

}  // namespace fairway::io
