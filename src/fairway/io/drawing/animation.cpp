// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/animation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "fairway/geometry/angle.hpp"

namespace fairway::io {

namespace {

using Eigen::Vector2d;

constexpr double kRest = 1.0;            // at the end of each loop [s]
constexpr double kSmallestRadius = 2.5;  // [pt]

std::string css(const Color& color) {
  const auto byte = [](double share) { return static_cast<int>(std::lround(255.0 * share)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.red), byte(color.green), byte(color.blue));
}

// Frame by frame, and the last one until the loop has rested.
class Values {
 public:
  explicit Values(std::size_t rest) : rest_(rest) {}

  void add(std::string value) {
    last_ = std::move(value);
    if (!text_.empty()) text_ += ';';
    text_ += last_;
  }
  [[nodiscard]] std::string text() const {
    std::string all = text_;
    for (std::size_t i = 0; i < rest_; ++i)
      all += ';' + last_;
    return all;
  }

 private:
  std::size_t rest_;
  std::string text_;
  std::string last_;
};

std::string shape(const MovingDrawing& moving, double scale) {
  const std::string style = fmt::format(
      "fill='{0}' fill-opacity='.35' stroke='{0}' stroke-width='1.2'", css(moving.color));
  std::string text;
  for (const std::vector<Vector2d>& polygon : moving.outline) {
    text += "<polygon points='";
    for (const Vector2d& corner : polygon)
      text += fmt::format("{:.2f},{:.2f} ", scale * corner.x(), -scale * corner.y());
    text += fmt::format("' {}/>", style);
  }
  const double radius = std::max(kSmallestRadius, scale * moving.radius);
  if (moving.outline.empty()) text += fmt::format("<circle r='{:.2f}' {}/>", radius, style);
  if (moving.heading) {
    text += fmt::format("<line x2='{:.2f}' stroke='{}' stroke-width='1.6'/>", radius,
                        css(moving.color));
  }
  return text;
}

std::string animate(const char* element, const char* more, const Values& values, double seconds) {
  return fmt::format("<{} {} dur='{:.3f}s' repeatCount='indefinite' values='{}'/>\n", element, more,
                     seconds, values.text());
}

std::string body_of(const MovingDrawing& moving,
                    const PlotAxes& axes,
                    std::size_t rest,
                    double seconds) {
  Values places(rest);
  Values turns(rest);
  Values shown(rest);
  Pose2 pose;
  double turned = 0.0;  // without jumps by a whole turn
  bool always = true;
  const auto first = std::find_if(moving.poses.begin(), moving.poses.end(),
                                  [](const auto& at) { return at.has_value(); });
  if (first != moving.poses.end()) pose = **first;
  turned = pose.heading;
  for (const std::optional<Pose2>& next : moving.poses) {
    if (next) {
      turned += wrap_to_pi(next->heading - turned);
      pose = *next;
    }
    always = always && next.has_value();
    const Vector2d at = axes.at(pose.position);
    places.add(fmt::format("{:.1f},{:.1f}", at.x(), at.y()));
    turns.add(fmt::format("{:.0f}", -180.0 / std::numbers::pi * turned));
    shown.add(next ? "1" : "0");
  }
  std::string text = "<g>";
  text +=
      animate("animateTransform", "attributeName='transform' type='translate'", places, seconds);
  if (!always)
    text += animate("animate", "attributeName='opacity' calcMode='discrete'", shown, seconds);
  text += "<g>";
  if (moving.heading || !moving.outline.empty())
    text += animate("animateTransform", "attributeName='transform' type='rotate'", turns, seconds);
  return text + shape(moving, axes.scale()) + "</g></g>\n";
}

// The driven path, which becomes longer.
std::string trail_of(const MovingDrawing& moving,
                     const PlotAxes& axes,
                     std::size_t rest,
                     double seconds) {
  std::string points;
  std::vector<double> lengths;
  std::optional<Vector2d> last;
  double length = 0.0;
  for (const std::optional<Pose2>& next : moving.poses) {
    if (next) {
      const Vector2d at = axes.at(next->position);
      if (last) length += (at - *last).norm();
      if (!last || at != *last) points += fmt::format("{:.1f},{:.1f} ", at.x(), at.y());
      last = at;
    }
    lengths.push_back(length);
  }
  if (!(length > 0.0)) return "";
  Values left(rest);
  for (const double driven : lengths)
    left.add(fmt::format("{:.3f}", 1.0 - driven / length));
  return fmt::format(
             "<polyline points='{}' fill='none' stroke='{}' stroke-width='1.6' pathLength='1' "
             "stroke-dasharray='1'>",
             points, css(moving.color)) +
         animate("animate", "attributeName='stroke-dashoffset'", left, seconds) + "</polyline>\n";
}

}  // namespace

Expected<std::string> draw_animation(const Animation& animation) {
  const Expected<std::string> still =
      draw_world(animation.world, PictureFormat::Svg, animation.region);
  if (!still) return still;
  const std::size_t end = still->rfind("</svg>");
  if (end == std::string::npos || animation.moving.empty()) return still;
  const PlotAxes axes = world_axes(animation.world, animation.region);
  const double frame = animation.interval / animation.pace;  // [s]
  const auto rest = static_cast<std::size_t>(std::ceil(kRest / frame));
  const auto frames = animation.moving.front().poses.size() + rest;
  const double seconds = static_cast<double>(std::max<std::size_t>(frames - 1, 1)) * frame;
  const Box& area = axes.area();
  // An inner picture clips what leaves the region.
  std::string moving = fmt::format(
      "<svg x='{0:.2f}' y='{1:.2f}' width='{2:.2f}' height='{3:.2f}' viewBox='{0:.2f} {1:.2f} "
      "{2:.2f} {3:.2f}'>\n",
      area.min.x(), area.min.y(), area.size().x(), area.size().y());
  for (const MovingDrawing& part : animation.moving) {
    if (part.heading) moving += trail_of(part, axes, rest, seconds);
  }
  for (const MovingDrawing& part : animation.moving)
    moving += body_of(part, axes, rest, seconds);
  if (animation.pace != 1.0) {
    moving += fmt::format(
        "<text x='{:.1f}' y='{:.1f}' text-anchor='end' font-family='sans-serif' font-size='9' "
        "fill='#444'>{:.3g} x real time</text>\n",
        area.max.x() - 5.0, area.max.y() - 6.0, animation.pace);
  }
  std::string bytes = *still;
  return bytes.insert(end, moving + "</svg>\n");
}

}  // namespace fairway::io
