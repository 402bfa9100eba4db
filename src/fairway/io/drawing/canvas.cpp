// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/canvas.hpp"

#include <cairo.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/core.h>

namespace fairway::io {

namespace {

constexpr double kPngScale = 300.0 / 72.0;  // [pixels/pt]

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  // An exception must not pass through C code.
  try {
    static_cast<std::string*>(bytes)->append(data, data + length);
    return CAIRO_STATUS_SUCCESS;
  } catch (...) {
    return CAIRO_STATUS_WRITE_ERROR;
  }
}

cairo_surface_t* make_surface(PictureFormat format,
                              const Eigen::Vector2d& size,
                              std::string* bytes) {
  switch (format) {
    case PictureFormat::Svg:
      return cairo_svg_surface_create_for_stream(append, bytes, size.x(), size.y());
    case PictureFormat::Pdf: {
      cairo_surface_t* pdf = cairo_pdf_surface_create_for_stream(append, bytes, size.x(), size.y());
      // Otherwise the file would contain its creation time: the same picture, other bytes.
      cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
      return pdf;
    }
    case PictureFormat::Png:
      break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                    static_cast<int>(std::ceil(size.x() * kPngScale)),
                                    static_cast<int>(std::ceil(size.y() * kPngScale)));
}

}  // namespace

struct Canvas::Cairo {
  std::unique_ptr<std::string> bytes = std::make_unique<std::string>();
  cairo_surface_t* surface = nullptr;
  cairo_t* context = nullptr;

  Cairo() = default;
  Cairo(const Cairo&) = delete;
  Cairo& operator=(const Cairo&) = delete;
  ~Cairo() {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }
};

Expected<PictureFormat> picture_format(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".svg") return PictureFormat::Svg;
  if (ending == ".png") return PictureFormat::Png;
  if (ending == ".pdf") return PictureFormat::Pdf;
  return fail(fmt::format("{}: expected a name that ends in .svg, .png or .pdf", path));
}

Canvas::Canvas(PictureFormat format, const Eigen::Vector2d& size)
    : size_(size),
      format_(format),
      cairo_(std::make_unique<Cairo>()) {
  cairo_->surface = make_surface(format, size, cairo_->bytes.get());
  cairo_->context = cairo_create(cairo_->surface);
  if (format == PictureFormat::Png) cairo_scale(cairo_->context, kPngScale, kPngScale);
  // Rounds up: the last row of dots may extend beyond the page by part of a dot.
  cairo_set_source_rgb(cairo_->context, 1.0, 1.0, 1.0);
  cairo_paint(cairo_->context);
  cairo_set_line_join(cairo_->context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo_->context, CAIRO_LINE_CAP_BUTT);
}

Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

void Canvas::trace(std::span<const Eigen::Vector2d> points) {
  cairo_new_path(cairo_->context);
  for (const Eigen::Vector2d& p : points)
    cairo_line_to(cairo_->context, p.x(), p.y());
}

void Canvas::stroke(const Stroke& stroke) {
  cairo_t* c = cairo_->context;
  cairo_set_source_rgba(c, stroke.color.red, stroke.color.green, stroke.color.blue,
                        stroke.color.alpha);
  cairo_set_line_width(c, stroke.width);
  cairo_set_dash(c, stroke.dash.data(), static_cast<int>(stroke.dash.size()), 0.0);
  cairo_stroke(c);
}

void Canvas::fill(const Color& fill, const Stroke* outline) {
  cairo_t* c = cairo_->context;
  cairo_set_source_rgba(c, fill.red, fill.green, fill.blue, fill.alpha);
  if (outline == nullptr) {
    cairo_fill(c);
    return;
  }
  cairo_fill_preserve(c);
  stroke(*outline);
}

void Canvas::line(std::span<const Eigen::Vector2d> points, const Stroke& style) {
  trace(points);
  stroke(style);
}

void Canvas::line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Stroke& style) {
  const std::array<Eigen::Vector2d, 2> points{a, b};
  line(points, style);
}

void Canvas::polygon(std::span<const Eigen::Vector2d> points,
                     const Color& color,
                     const Stroke* outline) {
  trace(points);
  cairo_close_path(cairo_->context);
  fill(color, outline);
}

void Canvas::box(const Box& box, const Color& color, const Stroke* outline) {
  cairo_new_path(cairo_->context);
  cairo_rectangle(cairo_->context, box.min.x(), box.min.y(), box.size().x(), box.size().y());
  fill(color, outline);
}

void Canvas::circle(const Eigen::Vector2d& center,
                    double radius,
                    const Color& color,
                    const Stroke* outline) {
  cairo_new_path(cairo_->context);
  cairo_arc(cairo_->context, center.x(), center.y(), radius, 0.0, 2.0 * std::numbers::pi);
  fill(color, outline);
}

void Canvas::cross(const Eigen::Vector2d& center, double arm, const Stroke& style) {
  line(center - Eigen::Vector2d(arm, arm), center + Eigen::Vector2d(arm, arm), style);
  line(center - Eigen::Vector2d(arm, -arm), center + Eigen::Vector2d(arm, -arm), style);
}

namespace {

void set_font(cairo_t* c, const TextStyle& style) {
  cairo_select_font_face(c, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(c, style.size);
}

}  // namespace

void Canvas::text(const Eigen::Vector2d& at, const std::string& text, const TextStyle& style) {
  cairo_t* c = cairo_->context;
  cairo_save(c);
  set_font(c, style);
  cairo_font_extents_t font;
  cairo_font_extents(c, &font);
  cairo_translate(c, at.x(), at.y());
  cairo_rotate(c, style.angle);
  // Digits and capitals extend about 0.73 of the font size above the baseline. Labels centred on
  // that height, not on the ascent, are level with their ticks.
  const double height = 0.73 * style.size;
  cairo_move_to(c, -style.anchor.x() * text_width(text, style), height - style.anchor.y() * height);
  cairo_set_source_rgba(c, style.color.red, style.color.green, style.color.blue, style.color.alpha);
  cairo_show_text(c, text.c_str());
  cairo_restore(c);
}

double Canvas::text_width(const std::string& text, const TextStyle& style) const {
  cairo_t* c = cairo_->context;
  cairo_save(c);
  set_font(c, style);
  cairo_text_extents_t extents;
  cairo_text_extents(c, text.c_str(), &extents);
  cairo_restore(c);
  return extents.x_advance;
}

void Canvas::image(const Raster& raster,
                   const Eigen::Vector2d& corner,
                   const Eigen::Vector2d& right,
                   const Eigen::Vector2d& down) {
  cairo_surface_t* pixels =
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, raster.width, raster.height);
  if (cairo_surface_status(pixels) == CAIRO_STATUS_SUCCESS) {
    cairo_surface_flush(pixels);
    unsigned char* data = cairo_image_surface_get_data(pixels);
    const int stride = cairo_image_surface_get_stride(pixels);
    const std::size_t bytes = static_cast<std::size_t>(raster.width) * sizeof(std::uint32_t);
    for (int y = 0; y < raster.height; ++y) {
      std::memcpy(data + static_cast<std::ptrdiff_t>(y) * stride,
                  raster.pixels.data() + static_cast<std::ptrdiff_t>(y) * raster.width, bytes);
    }
    cairo_surface_mark_dirty(pixels);
  }
  cairo_t* c = cairo_->context;
  cairo_save(c);
  cairo_matrix_t matrix;
  cairo_matrix_init(&matrix, right.x(), right.y(), down.x(), down.y(), corner.x(), corner.y());
  cairo_transform(c, &matrix);
  cairo_set_source_surface(c, pixels, 0.0, 0.0);
  // Cells stay sharp squares unless several share a dot; then the dot averages them.
  const bool sharp = right.norm() * kPngScale >= 1.0;
  cairo_pattern_set_filter(cairo_get_source(c), sharp ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
  cairo_paint(c);
  cairo_restore(c);
  cairo_surface_destroy(pixels);
}

void Canvas::begin_clip(const Box& box) {
  cairo_save(cairo_->context);
  cairo_new_path(cairo_->context);
  cairo_rectangle(cairo_->context, box.min.x(), box.min.y(), box.size().x(), box.size().y());
  cairo_clip(cairo_->context);
}

void Canvas::end_clip() { cairo_restore(cairo_->context); }

Expected<std::string> Canvas::finish() {
  cairo_status_t status = cairo_status(cairo_->context);
  if (format_ == PictureFormat::Png && status == CAIRO_STATUS_SUCCESS) {
    status = cairo_surface_write_to_png_stream(cairo_->surface, append, cairo_->bytes.get());
  }
  cairo_surface_finish(cairo_->surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(cairo_->surface);
  if (status != CAIRO_STATUS_SUCCESS) {
    return fail(fmt::format("the picture cannot be drawn: {}", cairo_status_to_string(status)));
  }
  return std::move(*cairo_->bytes);
}

}  // namespace fairway::io
