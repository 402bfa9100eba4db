// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fairway/base/error.hpp"
#include "fairway/io/drawing/color.hpp"

namespace fairway::io {

/// The picture file formats, chosen by the file name's suffix.
enum class PictureFormat : std::uint8_t { Svg, Png, Pdf };

/// From `.svg`, `.png` or `.pdf` in either case; any other suffix is an error.
[[nodiscard]] Expected<PictureFormat> picture_format(const std::string& path);

/// An axis-aligned box: on a canvas in points with y downward, in a plot in data units with y
/// upward.
struct Box {
  Eigen::Vector2d min = Eigen::Vector2d::Zero();
  Eigen::Vector2d max = Eigen::Vector2d::Zero();

  [[nodiscard]] Eigen::Vector2d size() const noexcept { return max - min; }
};

/// How a line is drawn.
struct Stroke {
  Color color = palette::kBlack;
  double width = 1.0;          ///< [pt]
  std::vector<double> dash{};  ///< on and off lengths [pt]; empty: solid
};

/// Where the reference point lies in a text, horizontally and vertically. 0 is left or top, 0.5 the
/// middle, 1 right or bottom.
struct TextStyle {
  double size = 8.0;  ///< of the font [pt]
  Color color = palette::kBlack;
  Eigen::Vector2d anchor{0.0, 0.5};
  double angle = 0.0;  ///< clockwise [rad]
  bool bold = false;
};

/// An image of opaque pixels, top row first.
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;  ///< 0xRRGGBB
};

/// A page to draw on, in points (1/72 inch), with the origin at the top left. The same calls give
/// SVG, PNG (at 300 dots per inch) and PDF.
class Canvas {
 public:
  Canvas(PictureFormat format, const Eigen::Vector2d& size);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  [[nodiscard]] const Eigen::Vector2d& size() const noexcept { return size_; }

  void line(std::span<const Eigen::Vector2d> points, const Stroke& stroke);
  void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Stroke& stroke);
  void polygon(std::span<const Eigen::Vector2d> points, const Color& fill, const Stroke* outline);
  void box(const Box& box, const Color& fill, const Stroke* outline);
  void circle(const Eigen::Vector2d& center,
              double radius,
              const Color& fill,
              const Stroke* outline);

  /// Draws two diagonal strokes that extend `arm` from the centre along each axis.
  void cross(const Eigen::Vector2d& center, double arm, const Stroke& stroke);

  void text(const Eigen::Vector2d& at, const std::string& text, const TextStyle& style);
  [[nodiscard]] double text_width(const std::string& text, const TextStyle& style) const;

  /// Draws an image with its top left corner at `corner`; one pixel spans `right` and `down`.
  void image(const Raster& raster,
             const Eigen::Vector2d& corner,
             const Eigen::Vector2d& right,
             const Eigen::Vector2d& down);

  /// Drawing between these two calls is clipped to `box`.
  void begin_clip(const Box& box);
  void end_clip();

  /// The finished file's bytes. Nothing can be drawn afterwards.
  [[nodiscard]] Expected<std::string> finish();

 private:
  struct Cairo;
  void trace(std::span<const Eigen::Vector2d> points);
  void stroke(const Stroke& stroke);
  void fill(const Color& fill, const Stroke* outline);

  Eigen::Vector2d size_;
  PictureFormat format_;
  std::unique_ptr<Cairo> cairo_;
};

}  // namespace fairway::io
