// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/figures/field_figures.hpp"

#include <algorithm>

#include "experiments/paper/figures/panels.hpp"
#include "experiments/paper/tables/text_format.hpp"
#include "fairway/io/drawing/map_raster.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;
using Kind = io::LegendEntry::Kind;

io::Color color_of(RectangleKind kind) {
  switch (kind) {
    case RectangleKind::Src:
      return kSrcColor;
    case RectangleKind::Mdsrc:
      return kMdsrcColor;
    case RectangleKind::Largest:
      break;
  }
  return kOursColor;
}

// The bars are side by side so that they do not cover each other.
double offset_of(RectangleKind kind) { return 0.6 * (static_cast<double>(kind) - 1.0); }

std::vector<io::LegendEntry> method_legend() {
  std::vector<io::LegendEntry> entries;
  for (const RectangleKind kind : kComparedRectangles)
    entries.push_back({.kind = Kind::Line,
                       .text = to_text(kind),
                       .stroke = {.color = color_of(kind), .width = 1.6}});
  return entries;
}

template <typename Sample>
void draw_curves(io::Canvas& canvas, const io::PlotAxes& axes, const Sample& values) {
  for (const RectangleKind kind : kComparedRectangles) {
    std::vector<Vector2d> curve;
    for (std::size_t i = 0; i < kFieldObstacles.size(); ++i) {
      const Estimate e = estimate(values(i, kind));
      const double x = kFieldObstacles.at(i) + offset_of(kind);
      draw_error_bar(
          canvas, axes,
          {.x = x, .low = e.mean - e.deviation, .middle = e.mean, .high = e.mean + e.deviation},
          color_of(kind));
      // Draws the mean's interval as a thick bar within the thin one.
      canvas.line(axes.at(Vector2d(x, e.low)), axes.at(Vector2d(x, e.high)),
                  {.color = color_of(kind), .width = 3.2});
      curve.emplace_back(x, e.mean);
    }
    canvas.line(axes.at(curve), {.color = color_of(kind).faded(0.6), .width = 0.9});
  }
}

// The paper's marks for SRC against MDSRC, above their bars.
template <typename Sample>
void draw_marks(io::Canvas& canvas, const io::PlotAxes& axes, const Sample& values) {
  for (std::size_t i = 0; i < kFieldObstacles.size(); ++i) {
    const std::vector<double> src = values(i, RectangleKind::Src);
    const std::vector<double> mdsrc = values(i, RectangleKind::Mdsrc);
    const TestResult test = welch_test(mdsrc, src);
    const double y = axes.data().max.y() - 0.035 * axes.data().size().y();
    const double left = kFieldObstacles.at(i) + offset_of(RectangleKind::Src);
    const double right = kFieldObstacles.at(i) + offset_of(RectangleKind::Mdsrc);
    const Vector2d a = axes.at(Vector2d(left, y)) + Vector2d(0.0, 10.0);
    const Vector2d b = axes.at(Vector2d(right, y)) + Vector2d(0.0, 10.0);
    canvas.line(a, b, {.width = 0.7});
    canvas.text(0.5 * (a + b) - Vector2d(0.0, 6.0), significance_mark(test.p),
                {.size = 9.0, .anchor = {0.5, 0.5}});
  }
}

template <typename Sample>
Panel value_panel(const char* title, const char* y_name, double top, const Sample& values) {
  return {.title = title,
          .data = {.min = {2.5, 0.0}, .max = {22.5, top}},
          .x_name = "number of obstacles",
          .y_name = y_name,
          .grid = true,
          .draw = [values](io::Canvas& canvas, const io::PlotAxes& axes) {
            draw_curves(canvas, axes, values);
            draw_marks(canvas, axes, values);
          }};
}

// Space above the highest bar for the marks.
template <typename Sample>
double top_of(const Sample& values) {
  double top = 0.0;
  for (std::size_t i = 0; i < kFieldObstacles.size(); ++i) {
    for (const RectangleKind kind : kComparedRectangles) {
      const Estimate e = estimate(values(i, kind));
      top = std::max(top, e.mean + e.deviation);
    }
  }
  return 1.16 * top;
}

template <typename Sample>
Panel gain_panel(const char* title, const char* y_name, const io::Box& data, const Sample& gain) {
  return {.title = title,
          .data = data,
          .x_name = "number of obstacles",
          .y_name = y_name,
          .grid = true,
          .draw = [gain](io::Canvas& canvas, const io::PlotAxes& axes) {
            canvas.line(axes.at(Vector2d(axes.data().min.x(), 0.0)),
                        axes.at(Vector2d(axes.data().max.x(), 0.0)), {.width = 0.8});
            std::vector<Vector2d> curve;
            for (std::size_t i = 0; i < kFieldObstacles.size(); ++i) {
              const Estimate e = estimate(gain(i));
              const double x = kFieldObstacles.at(i);
              draw_error_bar(canvas, axes, {.x = x, .low = e.low, .middle = e.mean, .high = e.high},
                             kMdsrcColor);
              curve.emplace_back(x, e.mean);
            }
            canvas.line(axes.at(curve), {.color = kMdsrcColor.faded(0.6), .width = 0.9});
          }};
}

}  // namespace

Figure field_map_figure(const std::shared_ptr<const FieldSample>& sample) {
  return {
      .name = "case2_figure9_fields",
      .caption = fmt::format(
          "Figure 9: fields of 20 m \u00d7 20 m with 5, 10, 15 and 20 obstacles and 24 random "
          "points (map seed {}), with the rectangles of MDSRC. A point inside an earlier rectangle "
          "gets none of its own.",
          sample->first_seed),
      .draw = [sample](io::PictureFormat format) {
        PanelPicture picture{
            .columns = 2,
            .legend =
                {{.kind = Kind::Area,
                  .text = "MDSRC",
                  .stroke = {.color = kMdsrcColor, .width = 0.8},
                  .fill = kMdsrcColor.faded(0.08)},
                 {.kind = Kind::Dot, .text = "seed", .stroke = {.width = 0.4}, .fill = kMdsrcColor},
                 {.kind = Kind::Ring, .text = "random point"},
                 {.kind = Kind::Area, .text = "obstacle", .fill = io::kOccupiedColor}},
            .panels = {}};
        for (std::size_t i = 0; i < kFieldObstacles.size(); ++i) {
          const auto grid = std::make_shared<const OccupancyGrid>(
              generate_map(MapKind::Field, sample->first_seed, kFieldObstacles.at(i)));
          const Field& field = sample->series.front().at(i);
          picture.panels.push_back(
              {.title = fmt::format("{} obstacles: {} corridors", kFieldObstacles.at(i),
                                    fixed(field.count(RectangleKind::Mdsrc), 0)),
               .data = bounds_of(*grid),
               .draw = [sample, grid, i](io::Canvas& canvas, const io::PlotAxes& axes) {
                 const Field& shown = sample->series.front().at(i);
                 draw_map_within(canvas, axes, *grid);
                 const auto mdsrc = static_cast<std::size_t>(RectangleKind::Mdsrc);
                 draw_rectangles(canvas, axes, shown.rectangles.at(mdsrc), kMdsrcColor);
                 const io::Stroke ring{.width = 0.8};
                 for (const Vector2d& point : shown.points)
                   canvas.circle(axes.at(point), 3.2, io::palette::kWhite.faded(0.0), &ring);
               }});
        }
        return draw_panels(picture, format);
      }};
}

Figure field_chart_figure(const std::shared_ptr<const FieldSample>& sample) {
  return {
      .name = "case2_figure10_area_and_number",
      .caption = fmt::format(
          "Figure 10: mean area and number of corridors over the number of obstacles, {} fields "
          "each. Dot: mean; thick bar: its 95 % confidence interval; thin bar: \u00b1 one "
          "standard deviation of the fields. Stars: SRC against MDSRC, Welch's two-sample t-test "
          "(Boost.Math), as in the paper: * p > 0.05 (not significant), ** p \u2264 0.05, *** p "
          "\u2264 0.01, **** p \u2264 0.001.",
          sample->series.size()),
      .draw = [sample](io::PictureFormat format) {
        const auto areas = [sample](std::size_t i, RectangleKind k) { return sample->areas(i, k); };
        const auto counts = [sample](std::size_t i, RectangleKind k) {
          return sample->counts(i, k);
        };
        const PanelPicture picture{
            .columns = 2,
            .ratio = 0.9,
            .legend = method_legend(),
            .panels = {value_panel("area", "mean area [m\u00b2]", top_of(areas), areas),
                       value_panel("number", "corridors per field", top_of(counts), counts)}};
        return draw_panels(picture, format);
      }};
}

Figure field_gain_figure(const std::shared_ptr<const FieldSample>& sample) {
  return {
      .name = "case2_gain_by_obstacles",
      .caption = fmt::format(
          "The gain of MDSRC over SRC, field by field ({} fields each): mean and 95 % confidence "
          "interval of the change relative to SRC. Below the line at 0, on the right: fewer "
          "corridors.",
          sample->series.size()),
      .draw = [sample](io::PictureFormat format) {
        const auto areas = [sample](std::size_t i) { return area_gain(*sample, i); };
        const auto counts = [sample](std::size_t i) { return count_gain(*sample, i); };
        double most = 0.0;
        double least = 0.0;
        for (std::size_t i = 0; i < kFieldObstacles.size(); ++i) {
          most = std::max(most, estimate(areas(i)).high);
          least = std::min(least, estimate(counts(i)).low);
        }
        const io::Box area_box{.min = {2.5, -0.15 * most}, .max = {22.5, 1.15 * most}};
        const io::Box count_box{.min = {2.5, 1.15 * least}, .max = {22.5, -0.15 * least}};
        const PanelPicture picture{
            .columns = 2,
            .ratio = 0.75,
            .panels = {
                gain_panel("area of MDSRC", "change [%]", area_box, areas),
                gain_panel("number of corridors of MDSRC", "change [%]", count_box, counts)}};
        return draw_panels(picture, format);
      }};
}

}  // namespace fairway::reproduction
