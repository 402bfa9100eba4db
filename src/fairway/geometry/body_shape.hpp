// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/geometry/footprint.hpp"

namespace fairway {

/// One convex part of a body: a convex polygon, all of whose points are grown by `radius`. One
/// vertex with a radius is a disc, two are a capsule. Closed; in the frame of the body [m].
struct ConvexPart {
  static constexpr int kMaxVertices = 16;

  ConvexPart() noexcept { vertices.fill(Eigen::Vector2d::Zero()); }

  int count = 0;
  std::array<Eigen::Vector2d, kMaxVertices> vertices;  ///< counter-clockwise; the first `count`
  double radius = 0.0;                                 ///< [m]

  [[nodiscard]] const Eigen::Vector2d& vertex(int i) const noexcept {
    return vertices[static_cast<std::size_t>(i)];
  }
};

/// The outline of a robot as a union of a few convex parts, in the robot's frame.
///
/// The origin is the reference point, to which poses and twists refer. For a wheeled base that
/// cannot move sideways this is the middle of the fixed axle. It may lie anywhere, also outside the
/// body.
class BodyShape {
 public:
  static constexpr int kMaxParts = 8;
  static constexpr double kMostSize = 50.0;  ///< of every coordinate and radius [m]

  /// A point at the reference.
  BodyShape() { measure(); }

  /// Expects 1 to kMaxParts parts, none of which is a single point. Each part has 1 to kMaxVertices
  /// finite vertices that form a convex polygon in either orientation, and a radius of at least 0.
  [[nodiscard]] static Expected<BodyShape> make(std::span<const ConvexPart> parts);

  /// A convex polygon, in either orientation.
  [[nodiscard]] static Expected<BodyShape> polygon(std::span<const Eigen::Vector2d> vertices);

  /// A rectangle along the heading, which reaches from `reference_to_front` - `length` to
  /// `reference_to_front` and `width` across. @pre length and width are positive.
  [[nodiscard]] static BodyShape rectangle(double length, double width, double reference_to_front);

  /// Makes the shape of a footprint: discs or a rectangle.
  [[nodiscard]] static BodyShape of(const Footprint& footprint);

  [[nodiscard]] std::span<const ConvexPart> parts() const noexcept { return parts_; }

  /// Returns whether the body is a single rectangle along the axes, without rounding.
  [[nodiscard]] bool is_rectangle() const noexcept { return rectangle_; }

  /// Corners of its bounding box along the axes [m].
  [[nodiscard]] const Eigen::Vector2d& low() const noexcept { return low_; }
  [[nodiscard]] const Eigen::Vector2d& high() const noexcept { return high_; }

  /// Radius of the smallest disc about the reference that covers it [m].
  [[nodiscard]] double circumscribed_radius() const noexcept { return circumscribed_; }

  /// Radius of the largest disc about `center` inside one of its parts; 0 when there is none [m].
  [[nodiscard]] double inscribed_radius(const Eigen::Vector2d& center) const noexcept;

  /// Distance from `point`, in the body's frame, to the body [m]; 0 inside.
  [[nodiscard]] double distance(const Eigen::Vector2d& point) const noexcept;

  /// Discs whose union covers the body: when all of them are free, so is the body.
  [[nodiscard]] std::span<const Footprint::Disc> cover() const noexcept { return cover_; }

  /// Discs inside the body: when one of them is blocked, so is the body.
  [[nodiscard]] std::span<const Footprint::Disc> core() const noexcept { return core_; }

  /// Greatest speed of any of its points in its own frame under a twist: |v + angular x q|.
  [[nodiscard]] double greatest_speed(double linear, double lateral, double angular) const noexcept;

 private:
  void measure();

  std::vector<ConvexPart> parts_;
  bool rectangle_ = false;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_ = Eigen::Vector2d::Zero();
  double circumscribed_ = 0.0;
  std::vector<Footprint::Disc> cover_;
  std::vector<Footprint::Disc> core_;
};

}  // namespace fairway
