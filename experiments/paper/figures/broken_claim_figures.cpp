// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/figures/broken_claim_figures.hpp"

#include "experiments/paper/figures/panels.hpp"
#include "experiments/paper/tables/text_format.hpp"
#include "fairway/io/drawing/map_raster.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;
using Kind = io::LegendEntry::Kind;

// A square around a rectangle's corners.
io::Box square_around(const std::vector<OrientedRectangle>& rectangles, double room) {
  Vector2d low = rectangles.front().corners()[0];
  Vector2d high = low;
  for (const OrientedRectangle& rectangle : rectangles) {
    for (const Vector2d& corner : rectangle.corners()) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  const Vector2d half = Vector2d::Constant(0.5 * (high - low).maxCoeff() + room);
  return {.min = 0.5 * (low + high) - half, .max = 0.5 * (low + high) + half};
}

using Cells = std::vector<OrientedRectangle>;

// The occupied cells that overlap the rectangle.
Cells cells_inside(const OccupancyGrid& grid, const OrientedRectangle& rectangle) {
  constexpr double kLeastPart = 1e-5;  // [m^2]; a cell has 2.5e-3
  const GridFrame& frame = grid.frame();
  const double half = 0.5 * frame.resolution;
  const double reach = (rectangle.max - rectangle.min).norm();
  Cells cells;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (grid.at({x, y}) != CellState::Occupied) continue;
      const Vector2d center = frame.center({.x = x, .y = y});
      if ((center - rectangle.center()).norm() > reach) continue;
      const OrientedRectangle cell{
          .seed = center, .min = Vector2d::Constant(-half), .max = Vector2d::Constant(half)};
      if (overlap(cell, rectangle).area() > kLeastPart) cells.push_back(cell);
    }
  }
  return cells;
}

void draw_outline(io::Canvas& canvas,
                  const io::PlotAxes& axes,
                  const OrientedRectangle& rectangle,
                  const io::Stroke& stroke) {
  canvas.polygon(axes.at(rectangle.corners()), stroke.color.faded(0.07), &stroke);
}

// The published rectangle with the most occupied cells inside.
struct Hopped {
  std::uint64_t seed = 0;
  OrientedRectangle rectangle;
  Cells cells;
};

std::optional<Hopped> worst_hop(MapKind kind, const std::vector<CorridorComparison>& maps) {
  std::optional<Hopped> worst;
  for (const CorridorComparison& map : maps) {
    const OccupancyGrid grid = generate_map(kind, map.seed);
    const BitGrid obstacles(grid);
    for (const OrientedRectangle& rectangle : map.of(CorridorKind::MdsrcPublished).rectangles) {
      if (is_free(obstacles, rectangle, 0.0)) continue;
      Cells cells = cells_inside(grid, rectangle);
      if (!cells.empty() && (!worst || cells.size() > worst->cells.size())) {
        worst = Hopped{.seed = map.seed, .rectangle = rectangle, .cells = std::move(cells)};
      }
    }
  }
  return worst;
}

struct Broken {
  std::shared_ptr<const CorridorComparison> map;
  std::size_t first = 0;  // of the two neighbours
};

std::optional<Broken> first_break(const std::vector<CorridorComparison>& maps) {
  for (const CorridorComparison& map : maps) {
    const auto& chain = map.of(CorridorKind::MdsrcPublished).rectangles;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const OrientedRectangle a = chain[i - 1].shrunk(kContraction);
      const OrientedRectangle b = chain[i].shrunk(kContraction);
      // Two neighbours that each fit the robot, without a passage between them.
      if (a.is_empty() || b.is_empty() || overlap(a, b).count > 0) continue;
      return Broken{.map = std::make_shared<CorridorComparison>(map), .first = i - 1};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Figure> hopping_figure(MapKind kind, const std::vector<CorridorComparison>& maps) {
  const std::optional<Hopped> found = worst_hop(kind, maps);
  if (!found) return std::nullopt;
  return Figure{
      .name = "case2_sampled_edges_hop",
      .caption = fmt::format(
          "Where the claim of a free corridor fails: a rectangle that Algorithm 1 grows when, as "
          "in Eq. (7), only the new edge is sampled. A step of 0.1 m hops over walls and posts "
          "that are one cell of 0.05 m thick. Marked: the {} occupied cells inside the "
          "\u201cfree\u201d rectangle. It is the worst of {} maps (kind {}, seed {}).",
          found->cells.size(), maps.size(), to_text(kind), found->seed),
      .draw = [kind, found](io::PictureFormat format) {
        const auto grid = std::make_shared<const OccupancyGrid>(generate_map(kind, found->seed));
        const io::Stroke side{.color = kMdsrcColor, .width = 1.4};
        const io::Stroke rim{.color = io::palette::kVermilion, .width = 0.6};
        PanelPicture picture{
            .columns = 2,
            .legend = {{.kind = Kind::Area,
                        .text = "MDSRC, as published",
                        .stroke = side,
                        .fill = kMdsrcColor.faded(0.07)},
                       {.kind = Kind::Area,
                        .text = "occupied cell inside",
                        .stroke = rim,
                        .fill = rim.color},
                       {.kind = Kind::Area, .text = "obstacle", .fill = io::kOccupiedColor},
                       {.kind = Kind::Dot,
                        .text = "seed",
                        .stroke = {.width = 0.4},
                        .fill = kMdsrcColor}},
            .panels = {}};
        const auto draw = [grid, found, side, rim](io::Canvas& canvas, const io::PlotAxes& axes) {
          draw_map_within(canvas, axes, *grid);
          for (const OrientedRectangle& cell : found->cells)
            canvas.polygon(axes.at(cell.corners()), rim.color, &rim);
          draw_outline(canvas, axes, found->rectangle, side);
          canvas.circle(axes.at(found->rectangle.seed), 2.6, kMdsrcColor, nullptr);
        };
        picture.panels = {
            {.title = "the rectangle",
             .data = square_around({found->rectangle}, 0.5),
             .draw = draw},
            {.title = "close up", .data = square_around(found->cells, 0.3), .draw = draw}};
        return draw_panels(picture, format);
      }};
}

std::optional<Figure> break_figure(MapKind kind, const std::vector<CorridorComparison>& maps) {
  const std::optional<Broken> found = first_break(maps);
  if (!found) return std::nullopt;
  return Figure{
      .name = "case2_chain_breaks",
      .caption =
          "Where the claim of a connected corridor fails: Algorithm 2 tests whether a path point "
          "is in the last rectangle, but Eq. (10) then contracts every rectangle by \u0394s = "
          "0.3 m. Left: two neighbours of the published chain overlap, but once contracted they "
          "do not: the robot's centre cannot pass from one to the other. Right: ours, whose "
          "contracted neighbours overlap by construction (map " +
          std::string(to_text(kind)) + ", seed " + std::to_string(found->map->seed) +
          ", the first one found).",
      .draw = [kind, found](io::PictureFormat format) {
        const auto grid =
            std::make_shared<const OccupancyGrid>(generate_map(kind, found->map->seed));
        const auto& chain = found->map->of(CorridorKind::MdsrcPublished).rectangles;
        const std::vector<OrientedRectangle> pair(
            chain.begin() + static_cast<std::ptrdiff_t>(found->first),
            chain.begin() + static_cast<std::ptrdiff_t>(found->first) + 2);
        const io::Box region = square_around(pair, 0.6);
        const auto& joined = found->map->of(CorridorKind::Fewest).rectangles;
        const io::Stroke side{.color = io::palette::kGrey, .width = 0.8, .dash = {4.0, 2.0}};
        const auto panel = [&](const char* title, const std::vector<OrientedRectangle>& shown) {
          return Panel{.title = title,
                       .data = region,
                       .draw = [grid, shown, side, map = found->map](io::Canvas& canvas,
                                                                     const io::PlotAxes& axes) {
                         draw_map_within(canvas, axes, *grid);
                         for (std::size_t i = 0; i < shown.size(); ++i) {
                           const io::Color color = i % 2 == 0 ? kMdsrcColor : kFsrcColor;
                           draw_outline(canvas, axes, shown[i], side);
                           const OrientedRectangle inner = shown[i].shrunk(kContraction);
                           const io::Stroke edge{.color = color, .width = 1.6};
                           canvas.polygon(axes.at(inner.corners()), color.faded(0.25), &edge);
                         }
                         canvas.line(axes.at(map->path.waypoints), kPathStroke);
                       }};
        };
        const PanelPicture picture{
            .columns = 2,
            .legend = {{.kind = Kind::Area,
                        .text = "corridor",
                        .stroke = side,
                        .fill = io::palette::kWhite},
                       {.kind = Kind::Area,
                        .text = "contracted by \u0394s (alternating colours)",
                        .stroke = {.color = kMdsrcColor, .width = 1.6},
                        .fill = kMdsrcColor.faded(0.25)},
                       {.kind = Kind::Line, .text = "path", .stroke = kPathStroke},
                       {.kind = Kind::Area, .text = "obstacle", .fill = io::kOccupiedColor}},
            .panels = {panel("MDSRC, as published", pair),
                       panel("fewest-rectangle (Fairway)", joined)}};
        return draw_panels(picture, format);
      }};
}

}  // namespace fairway::reproduction
