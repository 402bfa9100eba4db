// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/body_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "fairway/base/contract.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

const Vector2d& next_vertex(const ConvexPart& part, int i) noexcept {
  return part.vertex((i + 1) % part.count);
}

double signed_area(const ConvexPart& part) noexcept {
  double twice = 0.0;
  for (int i = 0; i < part.count; ++i)
    twice += cross(part.vertex(i), next_vertex(part, i));
  return 0.5 * twice;
}

// Convex and counter-clockwise: every vertex lies to the left of every edge, or on it.
bool is_convex(const ConvexPart& part) noexcept {
  constexpr double kSkin = 1e-9;  // [m^2]
  for (int i = 0; i < part.count; ++i) {
    const Vector2d edge = next_vertex(part, i) - part.vertex(i);
    for (int j = 0; j < part.count; ++j) {
      if (cross(edge, part.vertex(j) - part.vertex(i)) < -kSkin) return false;
    }
  }
  return true;
}

Expected<ConvexPart> checked(ConvexPart part, std::size_t index) {
  const std::string name = "part " + std::to_string(index + 1) + ": ";
  if (part.count < 1 || part.count > ConvexPart::kMaxVertices)
    return fail(name + "expected 1 to 16 vertices, found " + std::to_string(part.count));
  const auto in_range = [](double v) { return std::abs(v) <= BodyShape::kMostSize; };
  for (int i = 0; i < part.count; ++i) {
    if (!in_range(part.vertex(i).x()) || !in_range(part.vertex(i).y()))
      return fail(name + "expected coordinates from -50 to 50, found another");
  }
  if (!(part.radius >= 0.0 && in_range(part.radius)))
    return fail(name + "expected a radius from 0 to 50, found another");
  if (part.count > 2) {
    if (signed_area(part) < 0.0)
      std::reverse(part.vertices.begin(), part.vertices.begin() + part.count);
    if (!is_convex(part)) return fail(name + "expected a convex polygon, found one that is not");
  }
  if (part.radius <= 0.0 && (part.count < 3 || signed_area(part) < 1e-6))
    return fail(name + "expected an area, found none");
  return part;
}

// Depth of a point inside a part; negative outside (then not its distance).
double depth(const ConvexPart& part, const Vector2d& point) noexcept {
  if (part.count == 1) return part.radius - (point - part.vertex(0)).norm();
  if (part.count == 2) {
    const Vector2d edge = part.vertex(1) - part.vertex(0);
    const double share =
        std::clamp((point - part.vertex(0)).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    return part.radius - (point - part.vertex(0) - share * edge).norm();
  }
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < part.count; ++i) {
    const Vector2d edge = next_vertex(part, i) - part.vertex(i);
    least = std::min(least, cross(edge, point - part.vertex(i)) / edge.norm());
  }
  return least + part.radius;
}

// The bounding box of a part along its longest edge, cut into nearly square pieces, a disc each.
void add_discs(const ConvexPart& part,
               std::vector<Footprint::Disc>& cover,
               std::vector<Footprint::Disc>& core) {
  Vector2d along = Vector2d::UnitX();
  double longest = 0.0;
  for (int i = 0; i < part.count; ++i) {
    const Vector2d edge = next_vertex(part, i) - part.vertex(i);
    if (edge.norm() > longest) {
      longest = edge.norm();
      along = edge / longest;
    }
  }
  const Vector2d across(-along.y(), along.x());
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = -low;
  for (int i = 0; i < part.count; ++i) {
    const Vector2d local(part.vertex(i).dot(along), part.vertex(i).dot(across));
    low = low.cwiseMin(local);
    high = high.cwiseMax(local);
  }
  const Vector2d size = high - low;
  constexpr int kMostDiscs = 12;
  const double piece = std::max(0.45 * size.y(), 1e-3);
  const int count = std::clamp(static_cast<int>(std::ceil(size.x() / piece)), 1, kMostDiscs);
  const double step = size.x() / count;
  for (int i = 0; i < count; ++i) {
    const double x = low.x() + (i + 0.5) * step;
    const Vector2d center = x * along + 0.5 * (low.y() + high.y()) * across;
    cover.push_back({.center = center, .radius = 0.5 * std::hypot(step, size.y()) + part.radius});
    const double inside = depth(part, center);
    if (inside > 0.0) core.push_back({.center = center, .radius = inside});
  }
}

}  // namespace

Expected<BodyShape> BodyShape::make(std::span<const ConvexPart> parts) {
  if (parts.empty() || parts.size() > kMaxParts)
    return fail("expected 1 to 8 parts of the body, found " + std::to_string(parts.size()));
  BodyShape shape;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Expected<ConvexPart> part = checked(parts[i], i);
    if (!part) return tl::unexpected(part.error());
    shape.parts_.push_back(*part);
  }
  shape.measure();
  return shape;
}

Expected<BodyShape> BodyShape::polygon(std::span<const Vector2d> vertices) {
  ConvexPart part;
  if (vertices.size() > ConvexPart::kMaxVertices)
    return fail("expected at most 16 vertices, found " + std::to_string(vertices.size()));
  part.count = static_cast<int>(vertices.size());
  std::copy(vertices.begin(), vertices.end(), part.vertices.begin());
  return make(std::span<const ConvexPart>(&part, 1));
}

BodyShape BodyShape::rectangle(double length, double width, double reference_to_front) {
  FAIRWAY_EXPECTS(length > 0.0 && width > 0.0);
  const double back = reference_to_front - length;
  const double side = 0.5 * width;
  ConvexPart part;
  part.count = 4;
  part.vertices[0] = {back, -side};
  part.vertices[1] = {reference_to_front, -side};
  part.vertices[2] = {reference_to_front, side};
  part.vertices[3] = {back, side};
  BodyShape shape;
  shape.parts_.push_back(part);
  shape.measure();
  return shape;
}

BodyShape BodyShape::of(const Footprint& footprint) {
  if (footprint.is_rectangle()) {
    const OrientedRectangle box = footprint.rectangle_at({});
    ConvexPart part;
    part.count = 4;
    const auto corners = box.corners();
    std::copy(corners.begin(), corners.end(), part.vertices.begin());
    BodyShape shape;
    shape.parts_.push_back(part);
    shape.measure();
    return shape;
  }
  BodyShape shape;
  for (int i = 0; i < footprint.num_discs(); ++i) {
    ConvexPart part;
    part.count = 1;
    part.vertices[0] = footprint.disc_at(i).center;
    part.radius = footprint.disc_at(i).radius;
    shape.parts_.push_back(part);
  }
  shape.measure();
  return shape;
}

void BodyShape::measure() {
  cover_.clear();
  core_.clear();
  circumscribed_ = 0.0;
  if (parts_.empty()) {
    cover_.push_back({});
    return;
  }
  low_ = Vector2d::Constant(std::numeric_limits<double>::infinity());
  high_ = -low_;
  for (const ConvexPart& part : parts_) {
    add_discs(part, cover_, core_);
    for (int i = 0; i < part.count; ++i) {
      low_ = low_.cwiseMin((part.vertex(i).array() - part.radius).matrix());
      high_ = high_.cwiseMax((part.vertex(i).array() + part.radius).matrix());
      circumscribed_ = std::max(circumscribed_, part.vertex(i).norm() + part.radius);
    }
  }
  rectangle_ = parts_.size() == 1 && parts_[0].count == 4 && parts_[0].radius <= 0.0;
  for (int i = 0; rectangle_ && i < 4; ++i) {
    const Vector2d edge = next_vertex(parts_[0], i) - parts_[0].vertex(i);
    rectangle_ = std::min(std::abs(edge.x()), std::abs(edge.y())) <= 0.0;
  }
}

double BodyShape::inscribed_radius(const Vector2d& center) const noexcept {
  double most = 0.0;
  for (const ConvexPart& part : parts_)
    most = std::max(most, depth(part, center));
  return most;
}

double BodyShape::distance(const Vector2d& point) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const ConvexPart& part : parts_) {
    if (part.count > 2 && depth(part, point) >= part.radius) return 0.0;
    // Outside of the polygon, its sides decide; a point has one of no length.
    for (int i = 0; i < part.count; ++i) {
      const Vector2d edge = next_vertex(part, i) - part.vertex(i);
      const Vector2d way = point - part.vertex(i);
      const double share =
          std::clamp(way.dot(edge) / std::max(edge.squaredNorm(), 1e-18), 0.0, 1.0);
      least = std::min(least, (way - share * edge).norm() - part.radius);
    }
  }
  return std::max(0.0, least);
}

double BodyShape::greatest_speed(double linear, double lateral, double angular) const noexcept {
  double most = std::sqrt(linear * linear + lateral * lateral);
  for (const ConvexPart& part : parts_) {
    double square = 0.0;
    for (int i = 0; i < part.count; ++i) {
      const Vector2d& q = part.vertex(i);
      const double x = linear - angular * q.y();
      const double y = lateral + angular * q.x();
      square = std::max(square, x * x + y * y);
    }
    most = std::max(most, std::sqrt(square) + std::abs(angular) * part.radius);
  }
  return most;
}

}  // namespace fairway
