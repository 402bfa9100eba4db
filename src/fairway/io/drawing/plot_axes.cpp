// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/plot_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

namespace fairway::io {

namespace {

using Eigen::Vector2d;

constexpr double kTickLength = 3.0;      // [pt]
constexpr double kPointsPerTick = 45.0;  // desired distance between ticks [pt]
constexpr double kRowHeight = 13.0;      // of a legend [pt]
constexpr double kSampleWidth = 20.0;    // of a legend's line or box [pt]
constexpr double kEntryGap = 14.0;       // between a legend's entries [pt]

// Formats numbers at ticks `step` apart, with the decimals that the step needs and a true minus
// sign.
std::string number(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  return value < -0.5 * step ? "\u2212" + digits : digits;
}

double entry_width(const Canvas& canvas, const LegendEntry& entry) {
  return kSampleWidth + 5.0 + canvas.text_width(entry.text, TextStyle{});
}

// Calls `place(entry, corner)` for each entry and returns the number of rows.
template <typename Place>
int lay_out(const Canvas& canvas,
            std::span<const LegendEntry> entries,
            double width,
            const Place& place) {
  double x = 0.0;
  int row = 0;
  for (const LegendEntry& entry : entries) {
    const double own = entry_width(canvas, entry);
    if (x > 0.0 && x + own > width) {
      x = 0.0;
      ++row;
    }
    place(entry, Vector2d(x, row * kRowHeight));
    x += own + kEntryGap;
  }
  return entries.empty() ? 0 : row + 1;
}

}  // namespace

double tick_step(double low, double high, double about) {
  const double wished = (high - low) / std::max(1.0, about);
  const double power = std::pow(10.0, std::floor(std::log10(wished)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= wished * 0.999) step = factor * power;
  }
  return step;
}

std::vector<double> ticks(double low, double high, double step) {
  std::vector<double> result;
  constexpr double kSlack = 1e-9;  // accepts a limit that is a tick except for rounding
  const double first = std::ceil(low / step - kSlack);
  for (double i = first; i * step <= high + kSlack * step && result.size() < 1000; ++i)
    result.push_back(i * step);
  return result;
}

Vector2d PlotAxes::at(const Vector2d& point) const noexcept {
  const Vector2d share = (point - data_.min).cwiseQuotient(data_.size());
  return {area_.min.x() + share.x() * area_.size().x(),
          area_.max.y() - share.y() * area_.size().y()};
}

std::vector<Vector2d> PlotAxes::at(std::span<const Vector2d> points) const {
  std::vector<Vector2d> result;
  result.reserve(points.size());
  for (const Vector2d& p : points)
    result.push_back(at(p));
  return result;
}

void PlotAxes::draw(Canvas& canvas,
                    const std::string& x_name,
                    const std::string& y_name,
                    bool grid) const {
  const Stroke frame{.color = palette::kBlack, .width = 0.8};
  const Stroke faint{.color = palette::kLightGrey, .width = 0.5};
  double widest = 0.0;
  const double x_step = tick_step(data_.min.x(), data_.max.x(), area_.size().x() / kPointsPerTick);
  for (const double x : ticks(data_.min.x(), data_.max.x(), x_step)) {
    const double cx = at(Vector2d(x, data_.min.y())).x();
    if (grid) canvas.line({cx, area_.min.y()}, {cx, area_.max.y()}, faint);
    canvas.line({cx, area_.max.y()}, {cx, area_.max.y() + kTickLength}, frame);
    if (!x_name.empty()) {
      canvas.text({cx, area_.max.y() + kTickLength + 3.0}, number(x, x_step),
                  {.anchor = {0.5, 0.0}});
    }
  }
  const double y_about = std::max(4.0, area_.size().y() / kPointsPerTick);
  const double y_step = tick_step(data_.min.y(), data_.max.y(), y_about);
  for (const double y : ticks(data_.min.y(), data_.max.y(), y_step)) {
    const double cy = at(Vector2d(data_.min.x(), y)).y();
    if (grid) canvas.line({area_.min.x(), cy}, {area_.max.x(), cy}, faint);
    canvas.line({area_.min.x() - kTickLength, cy}, {area_.min.x(), cy}, frame);
    const TextStyle style{.anchor = {1.0, 0.5}};
    widest = std::max(widest, canvas.text_width(number(y, y_step), style));
    canvas.text({area_.min.x() - kTickLength - 3.0, cy}, number(y, y_step), style);
  }
  const Vector2d center = 0.5 * (area_.min + area_.max);
  if (!x_name.empty()) {
    canvas.text({center.x(), area_.max.y() + kTickLength + 16.0}, x_name,
                {.size = 9.0, .anchor = {0.5, 0.0}});
  }
  canvas.text({area_.min.x() - kTickLength - widest - 12.0, center.y()}, y_name,
              {.size = 9.0, .anchor = {0.5, 0.5}, .angle = -0.5 * std::numbers::pi});
  canvas.box(area_, palette::kWhite.faded(0.0), &frame);
}

double legend_height(const Canvas& canvas, std::span<const LegendEntry> entries, double width) {
  return kRowHeight * lay_out(canvas, entries, width,
                              [](const LegendEntry& /*entry*/, const Vector2d& /*at*/) {});
}

void draw_legend(Canvas& canvas,
                 std::span<const LegendEntry> entries,
                 const Vector2d& corner,
                 double width) {
  lay_out(canvas, entries, width, [&](const LegendEntry& entry, const Vector2d& offset) {
    const Vector2d at = corner + offset + Vector2d(0.0, 0.5 * kRowHeight);
    const Vector2d end = at + Vector2d(kSampleWidth, 0.0);
    switch (entry.kind) {
      case LegendEntry::Kind::Line:
        canvas.line(at, end, entry.stroke);
        break;
      case LegendEntry::Kind::Area:
        canvas.box({.min = at - Vector2d(0.0, 4.0), .max = end + Vector2d(0.0, 4.0)}, entry.fill,
                   &entry.stroke);
        break;
      case LegendEntry::Kind::Dot:
        canvas.circle(0.5 * (at + end), 2.6, entry.fill, &entry.stroke);
        break;
      case LegendEntry::Kind::Ring:
        canvas.circle(0.5 * (at + end), 4.0, entry.fill, &entry.stroke);
        break;
      case LegendEntry::Kind::Cross:
        canvas.cross(0.5 * (at + end), 3.5, entry.stroke);
        break;
    }
    canvas.text(end + Vector2d(5.0, 0.0), entry.text, {});
  });
}

}  // namespace fairway::io
