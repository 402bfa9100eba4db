// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/figures/corridor_figures.hpp"

#include "experiments/paper/figures/panels.hpp"
#include "experiments/paper/tables/text_format.hpp"
#include "fairway/io/drawing/map_raster.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;
using Kind = io::LegendEntry::Kind;

io::Color color_of(CorridorKind kind) {
  switch (kind) {
    case CorridorKind::SrcPublished:
    case CorridorKind::SrcSound:
      return kSrcColor;
    case CorridorKind::FsrcPublished:
    case CorridorKind::FsrcSound:
      return kFsrcColor;
    case CorridorKind::MdsrcPublished:
    case CorridorKind::MdsrcSound:
      return kMdsrcColor;
    case CorridorKind::Fewest:
    case CorridorKind::FewestConfiguration:
      break;
  }
  return kOursColor;
}

const char* short_name(CorridorKind kind) {
  switch (kind) {
    case CorridorKind::SrcPublished:
      return "SRC";
    case CorridorKind::FsrcPublished:
      return "FSRC";
    case CorridorKind::MdsrcPublished:
      return "MDSRC";
    case CorridorKind::SrcSound:
      return "SRC, sound";
    case CorridorKind::FsrcSound:
      return "FSRC, sound";
    case CorridorKind::MdsrcSound:
      return "MDSRC, sound";
    case CorridorKind::Fewest:
    case CorridorKind::FewestConfiguration:
      break;
  }
  return "fewest-rectangle (Fairway)";
}

Panel corridor_panel(const std::shared_ptr<const CorridorComparison>& map,
                     const std::shared_ptr<const OccupancyGrid>& grid,
                     CorridorKind kind) {
  const CorridorOutcome& outcome = map->of(kind);
  return {.title = fmt::format("{}: {} corridors, {} m\u00b2", short_name(kind),
                               outcome.rectangles.size(), fixed(outcome.mean_area, 2)),
          .data = bounds_of(*grid),
          .draw = [map, grid, kind](io::Canvas& canvas, const io::PlotAxes& axes) {
            draw_map_within(canvas, axes, *grid);
            draw_rectangles(canvas, axes, map->of(kind).rectangles, color_of(kind));
            canvas.line(axes.at(map->path.waypoints), kPathStroke);
          }};
}

std::vector<io::LegendEntry> corridor_legend() {
  return {
      {.kind = Kind::Area,
       .text = "corridor",
       .stroke = {.color = io::palette::kBlack, .width = 0.8},
       .fill = io::palette::kBlack.faded(0.08)},
      {.kind = Kind::Dot, .text = "seed", .stroke = {.width = 0.4}, .fill = io::palette::kBlack},
      {.kind = Kind::Line, .text = "path", .stroke = kPathStroke},
      {.kind = Kind::Area, .text = "obstacle", .fill = io::kOccupiedColor}};
}

Figure panels_figure(const std::string& name,
                     const std::string& caption,
                     MapKind kind,
                     const std::shared_ptr<const CorridorComparison>& map,
                     std::vector<CorridorKind> methods) {
  return {.name = name,
          .caption = caption,
          .draw = [kind, map, methods = std::move(methods)](io::PictureFormat format) {
            const auto grid = std::make_shared<const OccupancyGrid>(generate_map(kind, map->seed));
            PanelPicture picture{.columns = 2, .legend = corridor_legend(), .panels = {}};
            for (const CorridorKind method : methods)
              picture.panels.push_back(corridor_panel(map, grid, method));
            return draw_panels(picture, format);
          }};
}

}  // namespace

Figure corridor_figure(const std::string& name,
                       const std::string& caption,
                       MapKind kind,
                       const std::shared_ptr<const CorridorComparison>& map) {
  return panels_figure(name, caption, kind, map,
                       {CorridorKind::SrcPublished, CorridorKind::FsrcPublished,
                        CorridorKind::MdsrcPublished, CorridorKind::Fewest});
}

Figure structured_figure(const std::shared_ptr<const CorridorComparison>& map,
                         const std::string& caption) {
  return panels_figure("case2_axis_aligned", caption, MapKind::Structured, map,
                       {CorridorKind::SrcPublished, CorridorKind::MdsrcPublished,
                        CorridorKind::MdsrcSound, CorridorKind::Fewest});
}

}  // namespace fairway::reproduction
