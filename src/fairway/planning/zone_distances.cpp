// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/zone_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr float kFar = std::numeric_limits<float>::infinity();

// One number per cell of a grid.
class CellValues {
 public:
  CellValues(const GridFrame& frame, float value)
      : frame_(frame),
        values_(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height),
                value) {}

  [[nodiscard]] float& at(int x, int y) noexcept {
    return values_[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) +
                   static_cast<std::size_t>(x)];
  }
  [[nodiscard]] std::vector<float>& all() noexcept { return values_; }

  // Sets the cells whose centres lie in a polygon, row by row.
  void fill(const ZonePolygon& polygon, float value) {
    std::vector<Vector2d> corners;
    for (const Vector2d& corner : polygon.corners())
      corners.push_back(frame_.to_grid(corner));
    double low = frame_.height;
    double high = 0.0;
    for (const Vector2d& corner : corners) {
      low = std::min(low, corner.y());
      high = std::max(high, corner.y());
    }
    const int first = static_cast<int>(std::clamp(low - 1.0, 0.0, frame_.height + 0.0));
    const int last = static_cast<int>(std::clamp(high + 1.0, -1.0, frame_.height - 1.0));
    for (int y = first; y <= last; ++y)
      fill_row(corners, y, value);
  }

  // Takes the distance to a piece of a boundary, plus `more`, where that is less.
  void approach(const Segment& line, double reach, double more) {
    const Segment local{.a = frame_.to_grid(line.a), .b = frame_.to_grid(line.b)};
    const double grown = (reach - more) / frame_.resolution;
    if (!(grown > 0.0)) return;
    Extent extent = extent_of(local);
    const auto cell = [](double v, int size) {
      return static_cast<int>(std::clamp(v, -1.0, static_cast<double>(size)));
    };
    const int left = std::max(0, cell(extent.low.x() - grown, frame_.width));
    const int right = std::min(frame_.width - 1, cell(extent.high.x() + grown, frame_.width));
    const int bottom = std::max(0, cell(extent.low.y() - grown, frame_.height));
    const int top = std::min(frame_.height - 1, cell(extent.high.y() + grown, frame_.height));
    for (int y = bottom; y <= top; ++y) {
      for (int x = left; x <= right; ++x) {
        float& value = at(x, y);
        if (value <= 0.0F) continue;
        const double away = distance(local, Vector2d(x + 0.5, y + 0.5)) * frame_.resolution + more;
        value = std::min(value, static_cast<float>(away));
      }
    }
  }

 private:
  void fill_row(const std::vector<Vector2d>& corners, int y, float value) {
    const double height = y + 0.5;
    crossings_.clear();
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
      const Vector2d& a = corners[i];
      const Vector2d& b = corners[j];
      if ((a.y() > height) == (b.y() > height)) continue;
      crossings_.push_back(a.x() + (b.x() - a.x()) * ((height - a.y()) / (b.y() - a.y())));
    }
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t i = 1; i < crossings_.size(); i += 2) {
      const double from = std::clamp(std::ceil(crossings_[i - 1] - 0.5), 0.0, frame_.width + 0.0);
      const double to = std::clamp(std::ceil(crossings_[i] - 0.5), 0.0, frame_.width + 0.0);
      for (int x = static_cast<int>(from); x < static_cast<int>(to); ++x)
        at(x, y) = value;
    }
  }

  GridFrame frame_;
  std::vector<float> values_;
  std::vector<double> crossings_;
};

}  // namespace

std::vector<ZoneCell> zone_cells(const BitGrid& obstacles) {
  const ZoneMap* zones = obstacles.zones();
  if (zones == nullptr || !zones->forbids()) return {};
  const GridFrame& frame = obstacles.frame();
  const bool contour_only = zones->radius() <= 0.0;
  CellValues least(frame, kFar);
  if (zones->has_strips() && !(contour_only && !zones->strips(ZoneReference::Centre).empty())) {
    CellValues inside(frame, 0.0F);
    for (const ZoneReference kind : {ZoneReference::Contour, ZoneReference::Centre}) {
      const ZoneBoundary& strips = zones->strips(kind);
      if (strips.empty()) continue;
      CellValues own(frame, 0.0F);
      for (const ZonePolygon& polygon : strips.polygons())
        own.fill(polygon, kFar);
      for (const ZoneBoundary::Piece& piece : strips.pieces())
        own.approach(piece.line, zones->reach(), zones->less(kind));
      for (std::size_t i = 0; i < own.all().size(); ++i)
        inside.all()[i] = std::max(inside.all()[i], own.all()[i]);
    }
    least = std::move(inside);
  }
  for (const ZoneReference kind : {ZoneReference::Contour, ZoneReference::Centre}) {
    if (contour_only && kind == ZoneReference::Centre) continue;
    const ZoneBoundary& keep_outs = zones->keep_outs(kind);
    for (const ZonePolygon& polygon : keep_outs.polygons())
      least.fill(polygon, 0.0F);
    for (const ZoneBoundary::Piece& piece : keep_outs.pieces())
      least.approach(piece.line, zones->reach(), zones->less(kind));
  }
  std::vector<ZoneCell> cells;
  for (std::size_t i = 0; i < least.all().size(); ++i) {
    if (least.all()[i] < static_cast<float>(zones->reach()))
      cells.push_back({.index = static_cast<std::uint32_t>(i), .clearance = least.all()[i]});
  }
  return cells;
}

}  // namespace fairway
