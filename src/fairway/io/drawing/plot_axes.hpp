// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/io/drawing/canvas.hpp"

namespace fairway::io {

/// A rectangle of a canvas that shows a rectangle of data, with ticks and labels around it.
class PlotAxes {
 public:
  /// Maps `data` to `area` on the canvas; both are not empty.
  PlotAxes(const Box& area, const Box& data) : area_(area), data_(data) {}

  [[nodiscard]] const Box& area() const noexcept { return area_; }
  [[nodiscard]] const Box& data() const noexcept { return data_; }

  /// Data -> canvas.
  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& point) const noexcept;
  [[nodiscard]] std::vector<Eigen::Vector2d> at(std::span<const Eigen::Vector2d> points) const;

  /// Points per unit of x.
  [[nodiscard]] double scale() const noexcept { return area_.size().x() / data_.size().x(); }

  /// Draws the frame, the ticks with numbers, and the names of both axes. An empty name also omits
  /// the axis's numbers. With `grid` faint lines cross the plot at the ticks.
  void draw(Canvas& canvas, const std::string& x_name, const std::string& y_name, bool grid) const;

 private:
  Box area_;
  Box data_;
};

/// The smallest round step (1, 2 or 5 times a power of ten) that gives at most `about` ticks.
/// @pre low < high.
[[nodiscard]] double tick_step(double low, double high, double about);

/// The multiples of `step` from `low` to `high`.
[[nodiscard]] std::vector<double> ticks(double low, double high, double step);

/// One entry of a legend.
struct LegendEntry {
  enum class Kind : std::uint8_t { Line, Area, Dot, Ring, Cross };
  Kind kind = Kind::Line;
  std::string text;
  Stroke stroke{};
  Color fill = palette::kWhite;
};

/// Height of a legend that is `width` wide [pt].
[[nodiscard]] double legend_height(const Canvas& canvas,
                                   std::span<const LegendEntry> entries,
                                   double width);

/// Draws entries from left to right in as many rows as needed, starting at `corner` (top left).
void draw_legend(Canvas& canvas,
                 std::span<const LegendEntry> entries,
                 const Eigen::Vector2d& corner,
                 double width);

}  // namespace fairway::io
