// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/zone_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fairway::io {

namespace {

struct ZoneStyle {
  const char* text;
  Color color;
  double opacity;  // of the area
  bool dashed = false;
};

constexpr std::array<ZoneStyle, kZoneKinds> kZoneStyles{
    {{.text = "keep-out zone", .color = palette::kVermilion, .opacity = 0.25},
     {.text = "speed zone", .color = palette::kOrange, .opacity = 0.15},
     {.text = "penalised zone", .color = palette::kPurple, .opacity = 0.15},
     {.text = "preferred zone", .color = palette::kGreen, .opacity = 0.12},
     {.text = "strip", .color = palette::kBlue, .opacity = 0.06, .dashed = true},
     {.text = "one-way zone", .color = palette::kSkyBlue, .opacity = 0.15}}};

Stroke outline_of(const ZoneStyle& style) {
  Stroke stroke{.color = style.color, .width = 0.8};
  if (style.dashed) stroke.dash = {3.0, 2.0};
  return stroke;
}

}  // namespace

void draw_zones(Canvas& canvas, const PlotAxes& axes, const Zones& zones) {
  for (const Zone& zone : zones) {
    const ZoneStyle& style = kZoneStyles.at(static_cast<std::size_t>(zone.kind));
    const Stroke outline = outline_of(style);
    canvas.polygon(axes.at(zone.polygon), style.color.faded(style.opacity), &outline);
    if (zone.kind != ZoneKind::OneWay) continue;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& corner : zone.polygon)
      middle += corner / static_cast<double>(zone.polygon.size());
    // An arrow along the direction of travel.
    constexpr double kLength = 9.0;  // [pt]
    const Eigen::Vector2d along(std::cos(zone.direction), -std::sin(zone.direction));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d tip = axes.at(middle) + kLength * along;
    const Stroke arrow{.color = palette::kBlue, .width = 1.2};
    canvas.line(axes.at(middle) - kLength * along, tip, arrow);
    canvas.line(tip, tip - 4.0 * along + 3.0 * across, arrow);
    canvas.line(tip, tip - 4.0 * along - 3.0 * across, arrow);
  }
}

void add_zone_entries(std::vector<LegendEntry>& entries, const Zones& zones) {
  for (std::size_t kind = 0; kind < kZoneKinds; ++kind) {
    const bool shown = std::any_of(zones.begin(), zones.end(), [&](const Zone& zone) {
      return static_cast<std::size_t>(zone.kind) == kind;
    });
    if (!shown) continue;
    entries.push_back({.kind = LegendEntry::Kind::Area,
                       .text = kZoneStyles.at(kind).text,
                       .stroke = outline_of(kZoneStyles.at(kind)),
                       .fill = kZoneStyles.at(kind).color.faded(kZoneStyles.at(kind).opacity)});
  }
}

}  // namespace fairway::io
