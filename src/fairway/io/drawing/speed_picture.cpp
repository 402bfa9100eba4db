// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/speed_picture.hpp"

#include <algorithm>

#include "fairway/io/drawing/plot_axes.hpp"

namespace fairway::io {

namespace {

using Eigen::Vector2d;
using Kind = LegendEntry::Kind;

constexpr double kSpeedsWidth = 516.0;  // both columns of a journal [pt]
constexpr double kSpeedsLeft = 52.0;    // [pt]
constexpr double kSpeedsRight = 10.0;   // [pt]
constexpr double kSpeedsTop = 6.0;      // [pt]
constexpr double kPanelHeight = 130.0;
constexpr double kPanelGap = 14.0;
constexpr double kSpeedsBottom = 34.0;

const Stroke kLimitStroke{.color = palette::kBlack, .width = 1.2, .dash = {6.0, 3.0}};

Stroke command_stroke(std::size_t robot, std::size_t count) {
  return {.color = count == 1 ? palette::kSkyBlue : palette::of_robot(robot), .width = 2.2};
}

Stroke executed_stroke(std::size_t robot, std::size_t count) {
  return {.color = count == 1 ? palette::kBlue : palette::of_robot(robot), .width = 1.1};
}

// A command is constant during its cycle, so its line is a staircase.
std::vector<Vector2d> staircase(const SpeedSeries& series, double Twist2::*speed) {
  std::vector<Vector2d> points;
  for (std::size_t i = 0; i < series.commands.size(); ++i) {
    if (i > 0) points.emplace_back(series.time[i], series.commands[i - 1].*speed);
    points.emplace_back(series.time[i], series.commands[i].*speed);
  }
  return points;
}

std::vector<Vector2d> curve(const SpeedSeries& series, double Twist2::*speed) {
  std::vector<Vector2d> points;
  for (std::size_t i = 0; i < series.executed.size(); ++i)
    points.emplace_back(series.time[i], series.executed[i].*speed);
  return points;
}

double end_of(const SpeedDrawing& drawing) {
  double end = 0.0;
  for (const SpeedSeries& series : drawing.robots) {
    if (!series.time.empty()) end = std::max(end, series.time.back());
  }
  return end > 0.0 ? end : 1.0;
}

void draw_panel(Canvas& canvas,
                const SpeedDrawing& drawing,
                double Twist2::*speed,
                double top,
                const std::string& x_name,
                const std::string& y_name) {
  const double low = std::min(0.0, drawing.min.*speed);
  const double high = drawing.max.*speed;
  const double room = 0.12 * (high - low);
  const PlotAxes axes(
      {.min = {kSpeedsLeft, top}, .max = {kSpeedsWidth - kSpeedsRight, top + kPanelHeight}},
      {.min = {0.0, low - room}, .max = {end_of(drawing), high + room}});
  axes.draw(canvas, x_name, y_name, true);
  canvas.begin_clip(axes.area());
  const std::size_t count = drawing.robots.size();
  for (std::size_t i = 0; i < count; ++i) {
    const SpeedSeries& series = drawing.robots[i];
    if (count == 1 || series.executed.empty()) {
      canvas.line(axes.at(staircase(series, speed)), command_stroke(i, count));
    }
    canvas.line(axes.at(curve(series, speed)), executed_stroke(i, count));
  }
  for (const double limit : {drawing.min.*speed, drawing.max.*speed}) {
    canvas.line(axes.at(Vector2d(0.0, limit)), axes.at(Vector2d(axes.data().max.x(), limit)),
                kLimitStroke);
  }
  canvas.end_clip();
}

std::vector<LegendEntry> legend(const SpeedDrawing& drawing) {
  std::vector<LegendEntry> entries;
  const std::size_t count = drawing.robots.size();
  if (count == 1) {
    entries.push_back({.kind = Kind::Line, .text = "command", .stroke = command_stroke(0, 1)});
    if (!drawing.robots.front().executed.empty()) {
      entries.push_back({.kind = Kind::Line, .text = "executed", .stroke = executed_stroke(0, 1)});
    }
  } else if (count <= 7) {
    for (std::size_t i = 0; i < count; ++i) {
      entries.push_back({.kind = Kind::Line,
                         .text = drawing.robots[i].name,
                         .stroke = executed_stroke(i, count)});
    }
  }
  entries.push_back({.kind = Kind::Line, .text = "limits", .stroke = kLimitStroke});
  return entries;
}

}  // namespace

Expected<std::string> draw_speeds(const SpeedDrawing& drawing, PictureFormat format) {
  const std::vector<LegendEntry> entries = legend(drawing);
  const double width = kSpeedsWidth - kSpeedsLeft - kSpeedsRight;
  const double legend_room =
      legend_height(Canvas(PictureFormat::Svg, {kSpeedsWidth, 100.0}), entries, width) + 4.0;
  const double first = kSpeedsTop + legend_room;
  const double second = first + kPanelHeight + kPanelGap;
  Canvas canvas(format, {kSpeedsWidth, second + kPanelHeight + kSpeedsBottom});
  draw_panel(canvas, drawing, &Twist2::linear, first, "", "linear speed [m/s]");
  draw_panel(canvas, drawing, &Twist2::angular, second, "time [s]", "angular speed [rad/s]");
  draw_legend(canvas, entries, {kSpeedsLeft, kSpeedsTop}, width);
  return canvas.finish();
}

}  // namespace fairway::io
