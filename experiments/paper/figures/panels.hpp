// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/io/drawing/plot_axes.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::reproduction {

/// One plot of a picture.
struct Panel {
  std::string title;  ///< above it
  io::Box data;       ///< what it shows
  std::string x_name = "x [m]";
  std::string y_name = "y [m]";
  bool grid = false;  ///< faint lines at the ticks
  /// Draws the contents; clipped to the plot.
  std::function<void(io::Canvas&, const io::PlotAxes&)> draw;
};

/// Panels of equal size in rows, with a legend above them.
struct PanelPicture {
  int columns = 2;
  double ratio = 1.0;  ///< height of a plot over its width
  std::vector<io::LegendEntry> legend;
  std::vector<Panel> panels;
};

/// The picture file's bytes; the picture is as wide as both columns of a journal.
[[nodiscard]] Expected<std::string> draw_panels(const PanelPicture& picture,
                                                io::PictureFormat format);

/// A map, grey beyond its borders.
void draw_map_within(io::Canvas& canvas, const io::PlotAxes& axes, const OccupancyGrid& map);

/// Rectangles with their seeds, in one colour.
void draw_rectangles(io::Canvas& canvas,
                     const io::PlotAxes& axes,
                     const std::vector<OrientedRectangle>& rectangles,
                     const io::Color& color);

/// The positions of poses, for a line.
[[nodiscard]] std::vector<Eigen::Vector2d> positions(const std::vector<Pose2>& poses);

/// Draws a bar from `low` to `high` at `x` with end marks, and a dot at `middle`. [data units]
struct ErrorBar {
  double x = 0.0;
  double low = 0.0;
  double middle = 0.0;
  double high = 0.0;
};
void draw_error_bar(io::Canvas& canvas,
                    const io::PlotAxes& axes,
                    const ErrorBar& bar,
                    const io::Color& color);

/// The area of a whole map [m].
[[nodiscard]] io::Box bounds_of(const OccupancyGrid& map);

/// Colours of the paper's methods and ours in every figure.
inline constexpr io::Color kSrcColor = io::palette::kVermilion;
inline constexpr io::Color kFsrcColor = io::palette::kOrange;
inline constexpr io::Color kMdsrcColor = io::palette::kBlue;
inline constexpr io::Color kOursColor = io::palette::kGreen;

/// Planned paths in every figure.
inline const io::Stroke kPathStroke{.color = io::palette::kBlack, .width = 0.9, .dash = {3.0, 2.0}};

}  // namespace fairway::reproduction
