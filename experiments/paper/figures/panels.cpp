// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/figures/panels.hpp"

#include <algorithm>

#include "fairway/io/drawing/map_raster.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;

constexpr double kPageWidth = 516.0;  // [pt]
constexpr double kMargin = 6.0;       // around the picture [pt]
constexpr double kLeft = 42.0;        // beside a plot: numbers and a name [pt]
constexpr double kRight = 6.0;
constexpr double kTitle = 15.0;   // above a plot
constexpr double kBottom = 34.0;  // below a plot: numbers and a name

}  // namespace

Expected<std::string> draw_panels(const PanelPicture& picture, io::PictureFormat format) {
  const double cell = (kPageWidth - 2.0 * kMargin) / picture.columns;
  const double width = cell - kLeft - kRight;
  const double height = width * picture.ratio;
  const auto rows = (picture.panels.size() + static_cast<std::size_t>(picture.columns) - 1) /
                    static_cast<std::size_t>(picture.columns);
  const double legend_width = kPageWidth - 2.0 * kMargin - kLeft;
  // A temporary canvas measures the legend's text.
  const double legend =
      picture.legend.empty()
          ? 0.0
          : io::legend_height(io::Canvas(io::PictureFormat::Svg, {kPageWidth, 100.0}),
                              picture.legend, legend_width) +
                4.0;
  const double row = kTitle + height + kBottom;
  io::Canvas canvas(format, {kPageWidth, 2.0 * kMargin + legend + static_cast<double>(rows) * row});
  io::draw_legend(canvas, picture.legend, {kMargin + kLeft, kMargin}, legend_width);
  for (std::size_t i = 0; i < picture.panels.size(); ++i) {
    const Panel& panel = picture.panels[i];
    const auto columns = static_cast<std::size_t>(picture.columns);
    const Vector2d corner(kMargin + static_cast<double>(i % columns) * cell + kLeft,
                          kMargin + legend + static_cast<double>(i / columns) * row + kTitle);
    const io::PlotAxes axes({.min = corner, .max = corner + Vector2d(width, height)}, panel.data);
    canvas.text(corner + Vector2d(0.5 * width, -5.0), panel.title,
                {.size = 8.5, .anchor = {0.5, 1.0}, .bold = true});
    // Grid lines are drawn below the data, the frame above it.
    if (panel.grid) axes.draw(canvas, panel.x_name, panel.y_name, true);
    canvas.begin_clip(axes.area());
    panel.draw(canvas, axes);
    canvas.end_clip();
    if (!panel.grid) axes.draw(canvas, panel.x_name, panel.y_name, false);
  }
  return canvas.finish();
}

void draw_map_within(io::Canvas& canvas, const io::PlotAxes& axes, const OccupancyGrid& map) {
  canvas.box(axes.area(), io::kUnknownColor, nullptr);
  io::draw_map(canvas, axes, map);
}

void draw_rectangles(io::Canvas& canvas,
                     const io::PlotAxes& axes,
                     const std::vector<OrientedRectangle>& rectangles,
                     const io::Color& color) {
  const io::Stroke outline{.color = color, .width = 0.8};
  for (const OrientedRectangle& rectangle : rectangles)
    canvas.polygon(axes.at(rectangle.corners()), color.faded(0.08), &outline);
  const io::Stroke rim{.color = io::palette::kWhite, .width = 0.4};
  for (const OrientedRectangle& rectangle : rectangles)
    canvas.circle(axes.at(rectangle.seed), 1.9, color, &rim);
}

std::vector<Vector2d> positions(const std::vector<Pose2>& poses) {
  std::vector<Vector2d> result;
  result.reserve(poses.size());
  for (const Pose2& pose : poses)
    result.push_back(pose.position);
  return result;
}

void draw_error_bar(io::Canvas& canvas,
                    const io::PlotAxes& axes,
                    const ErrorBar& bar,
                    const io::Color& color) {
  constexpr double kEnd = 3.0;  // half width of an end [pt]
  const io::Stroke stroke{.color = color, .width = 1.0};
  const Vector2d low = axes.at(Vector2d(bar.x, bar.low));
  const Vector2d high = axes.at(Vector2d(bar.x, bar.high));
  canvas.line(low, high, stroke);
  for (const Vector2d& end : {low, high})
    canvas.line(end - Vector2d(kEnd, 0.0), end + Vector2d(kEnd, 0.0), stroke);
  canvas.circle(axes.at(Vector2d(bar.x, bar.middle)), 2.6, color, nullptr);
}

io::Box bounds_of(const OccupancyGrid& map) {
  const GridFrame& frame = map.frame();
  const Vector2d a = frame.to_world({0.0, 0.0});
  const Vector2d b =
      frame.to_world({static_cast<double>(frame.width), static_cast<double>(frame.height)});
  return {.min = a.cwiseMin(b), .max = a.cwiseMax(b)};
}

}  // namespace fairway::reproduction
