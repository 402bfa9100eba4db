// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/world_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/io/drawing/map_raster.hpp"
#include "fairway/io/drawing/plot_axes.hpp"
#include "fairway/io/drawing/world_legend.hpp"
#include "fairway/io/drawing/zone_shapes.hpp"

namespace fairway::io {

namespace {

using Eigen::Vector2d;

constexpr double kPageWidth = 516.0;   // both columns of a journal [pt]
constexpr double kLeft = 46.0;         // space for numbers and names [pt]
constexpr double kRight = 10.0;        // [pt]
constexpr double kBottom = 34.0;       // [pt]
constexpr double kTop = 6.0;           // [pt]
constexpr double kFlattest = 0.32;     // least height of the plot over its width
constexpr double kTallest = 1.15;      // largest such ratio in a picture of full width
constexpr double kThinnest = 2.5;      // largest such ratio in a narrower picture
constexpr double kSmallestView = 4.0;  // [m]

class Bounds {
 public:
  void add(const Vector2d& p, double room = 0.0) {
    low_ = low_.cwiseMin(p - Vector2d::Constant(room));
    high_ = high_.cwiseMax(p + Vector2d::Constant(room));
  }
  [[nodiscard]] Box box() const {
    if (!(low_.x() <= high_.x())) return {.min = {-1.0, -1.0}, .max = {1.0, 1.0}};
    return {.min = low_, .max = high_};
  }

 private:
  Vector2d low_ = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high_ = -low_;
};

Box map_bounds(const OccupancyGrid& map) {
  const GridFrame& frame = map.frame();
  Bounds bounds;
  for (const int x : {0, frame.width}) {
    for (const int y : {0, frame.height})
      bounds.add(frame.to_world({x, y}));
  }
  return bounds.box();
}

// Widens [low, high] to `length` around its middle, shifted into [least, most] if possible.
void widen(double& low, double& high, double length, double least, double most) {
  if (high - low >= length) return;
  const double middle = 0.5 * (low + high);
  low = middle - 0.5 * length;
  high = middle + 0.5 * length;
  if (most - least <= length) {
    const double shift = 0.5 * (least + most) - middle;
    low += shift;
    high += shift;
  } else if (low < least) {
    high += least - low;
    low = least;
  } else if (high > most) {
    low -= high - most;
    high = most;
  }
}

void draw_corridor(Canvas& canvas,
                   const PlotAxes& axes,
                   const RobotDrawing& robot,
                   const Color& color,
                   double opacity) {
  const Stroke outline{.color = color, .width = 0.9};
  for (const OrientedRectangle& rectangle : robot.corridor.rectangles) {
    canvas.polygon(axes.at(rectangle.corners()), color.faded(opacity), &outline);
  }
}

void draw_seeds(Canvas& canvas,
                const PlotAxes& axes,
                const RobotDrawing& robot,
                const Color& color) {
  const Stroke rim{.color = palette::kWhite, .width = 0.6};
  for (const OrientedRectangle& rectangle : robot.corridor.rectangles) {
    canvas.circle(axes.at(rectangle.seed), 2.4, color, &rim);
  }
}

// Draws the body at about a dozen equally spaced times, so that the spacing shows the speed. At
// standstill the body is drawn once.
void draw_bodies_along(Canvas& canvas,
                       const PlotAxes& axes,
                       std::span<const Vector2d> centers,
                       double radius,
                       const Color& color) {
  const Stroke outline{.color = color.faded(0.55), .width = 0.5};
  const std::size_t every = std::max<std::size_t>(1, centers.size() / 12);
  std::optional<Vector2d> last;
  for (std::size_t i = 0; i < centers.size(); i += every) {
    if (last && (centers[i] - *last).norm() < 0.2 * radius) continue;
    canvas.circle(axes.at(centers[i]), radius * axes.scale(), color.faded(0.10), &outline);
    last = centers[i];
  }
}

// The same with the true outline.
void draw_outlines_along(Canvas& canvas,
                         const PlotAxes& axes,
                         const RobotDrawing& robot,
                         const Color& color) {
  const Stroke stroke{.color = color.faded(0.55), .width = 0.5};
  const std::size_t every = std::max<std::size_t>(1, robot.track.size() / 12);
  std::optional<Vector2d> last;
  for (std::size_t i = 0; i < robot.track.size(); i += every) {
    const Pose2& pose = robot.track[i];
    if (last && (pose.position - *last).norm() < 0.1 * robot.radius) continue;
    for (const std::vector<Vector2d>& outline : robot.outlines) {
      std::vector<Vector2d> corners;
      for (const Vector2d& corner : outline)
        corners.push_back(axes.at(transform(pose, corner)));
      canvas.polygon(corners, color.faded(0.10), &stroke);
    }
    last = pose.position;
  }
}

std::vector<Vector2d> positions(const std::vector<Pose2>& poses) {
  std::vector<Vector2d> result;
  for (const Pose2& pose : poses)
    result.push_back(pose.position);
  return result;
}

void draw_start(Canvas& canvas,
                const PlotAxes& axes,
                const RobotDrawing& robot,
                const Color& color) {
  const Vector2d start = axes.at(robot.start.position);
  const double radius = std::max(3.5, robot.radius * axes.scale());
  const Stroke body{.color = color, .width = 1.2};
  canvas.circle(start, radius, palette::kWhite.faded(0.85), &body);
  const Vector2d ahead(std::cos(robot.start.heading), -std::sin(robot.start.heading));
  canvas.line(start, start + radius * ahead, body);
}

void draw_goal(Canvas& canvas,
               const PlotAxes& axes,
               const RobotDrawing& robot,
               const Color& color) {
  const Vector2d goal = axes.at(robot.goal);
  canvas.cross(goal, 4.0, {.color = palette::kWhite, .width = 3.2});
  canvas.cross(goal, 4.0, {.color = color, .width = 1.6});
}

void draw_robots(Canvas& canvas, const PlotAxes& axes, const WorldDrawing& world) {
  const std::size_t count = world.robots.size();
  for (std::size_t i = 0; i < count; ++i) {
    // Overlapping fills of several corridors would be unreadable.
    draw_corridor(canvas, axes, world.robots[i], colors_of(i, count).corridor,
                  count == 1 ? 0.10 : 0.0);
  }
  for (const BodyDrawing& body : world.bodies) {
    draw_bodies_along(canvas, axes, body.track, body.radius, palette::kPurple);
    canvas.line(axes.at(body.track), {.color = palette::kPurple, .width = 1.2, .dash = {1.5, 1.5}});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const RobotDrawing& robot = world.robots[i];
    const RobotColors colors = colors_of(i, count);
    const std::vector<Vector2d> track = positions(robot.track);
    if (robot.outlines.empty()) {
      draw_bodies_along(canvas, axes, track, robot.radius, colors.track);
    } else {
      draw_outlines_along(canvas, axes, robot, colors.track);
    }
    canvas.line(axes.at(robot.path.waypoints),
                {.color = colors.path, .width = 1.3, .dash = {4.0, 2.5}});
    canvas.line(axes.at(track), {.color = colors.track, .width = 1.8});
    draw_seeds(canvas, axes, robot, colors.seed);
    draw_start(canvas, axes, robot, colors.track);
  }
  // Goals are drawn last because another robot may start there.
  for (std::size_t i = 0; i < count; ++i) {
    draw_goal(canvas, axes, world.robots[i], colors_of(i, count).track);
  }
}

}  // namespace

Box shown_region(const WorldDrawing& world) {
  Bounds bounds;
  for (const RobotDrawing& robot : world.robots) {
    bounds.add(robot.start.position, robot.radius);
    bounds.add(robot.goal, robot.radius);
    for (const Vector2d& p : robot.path.waypoints)
      bounds.add(p, robot.radius);
    for (const Pose2& pose : robot.track)
      bounds.add(pose.position, robot.radius);
    for (const OrientedRectangle& rectangle : robot.corridor.rectangles) {
      for (const Vector2d& corner : rectangle.corners())
        bounds.add(corner);
    }
  }
  Box box = bounds.box();
  // Moving obstacles are shown near the robots only; they must not shrink the view of the robots.
  const Vector2d near = Vector2d::Constant(0.25 * box.size().maxCoeff());
  for (const BodyDrawing& body : world.bodies) {
    for (const Vector2d& p : body.track) {
      const bool close =
          (p - box.min + near).minCoeff() >= 0.0 && (box.max + near - p).minCoeff() >= 0.0;
      if (close) bounds.add(p, body.radius);
    }
  }
  box = bounds.box();
  const double margin = std::max(0.5, 0.04 * box.size().maxCoeff());
  box.min -= Vector2d::Constant(margin);
  box.max += Vector2d::Constant(margin);
  Box limits{.min = Vector2d::Constant(-1e18), .max = Vector2d::Constant(1e18)};
  if (world.map != nullptr) {
    limits = map_bounds(*world.map);
    box.min = box.min.cwiseMax(limits.min);
    box.max = box.max.cwiseMin(limits.max);
  }
  // A narrow map gives a narrow picture without empty margins.
  const double wished = std::max({kSmallestView, box.size().x(), box.size().y() / kTallest});
  const double width = std::min(wished, std::max(limits.size().x(), box.size().y() / kThinnest));
  widen(box.min.x(), box.max.x(), width, limits.min.x(), limits.max.x());
  const double height = std::max({0.5 * kSmallestView, box.size().y(), width * kFlattest});
  widen(box.min.y(), box.max.y(), height, limits.min.y(), limits.max.y());
  return box;
}

PlotAxes world_axes(const WorldDrawing& world, const Box& region) {
  const double ratio = region.size().y() / region.size().x();
  const double plot_width = (kPageWidth - kLeft - kRight) * std::min(1.0, kTallest / ratio);
  const double page_width = kLeft + plot_width + kRight;
  // A temporary canvas measures the legend's text.
  const double legend = legend_height(Canvas(PictureFormat::Svg, {page_width, 100.0}),
                                      world_legend(world, region), plot_width) +
                        4.0;
  const Box area{.min = {kLeft, kTop + legend},
                 .max = {kLeft + plot_width, kTop + legend + plot_width * ratio}};
  return {area, region};
}

Expected<std::string> draw_world(const WorldDrawing& world,
                                 PictureFormat format,
                                 const Box& region) {
  const PlotAxes axes = world_axes(world, region);
  const Box& area = axes.area();
  Canvas canvas(format, {area.max.x() + kRight, area.max.y() + kBottom});
  canvas.begin_clip(area);
  if (world.map != nullptr) {
    canvas.box(area, kUnknownColor, nullptr);  // the area beyond the map is unknown
    draw_map(canvas, axes, *world.map);
  }
  draw_zones(canvas, axes, world.zones);
  draw_robots(canvas, axes, world);
  canvas.end_clip();
  axes.draw(canvas, "x [m]", "y [m]", false);
  draw_legend(canvas, world_legend(world, region), {kLeft, kTop}, area.size().x());
  return canvas.finish();
}

Expected<std::string> draw_world(const WorldDrawing& world, PictureFormat format) {
  return draw_world(world, format, shown_region(world));
}

}  // namespace fairway::io
