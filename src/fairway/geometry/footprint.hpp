// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// The outline of a robot in its own frame, as a closed set: up to kMaxDiscs discs, or one
/// rectangle.
class Footprint {
 public:
  static constexpr int kMaxDiscs = 8;

  struct Disc {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< in the robot's frame [m]
    double radius = 0.0;                               ///< [m]
  };

  /// Makes a disc about the robot's centre; `radius` in [m].
  [[nodiscard]] static Footprint disc(double radius) noexcept;

  /// Makes a union of discs. @pre 1 <= count <= kMaxDiscs.
  [[nodiscard]] static Footprint discs(const Disc* discs, int count) noexcept;

  /// Makes a rectangle along the robot's axes: `length` along its heading, `width` across [m].
  /// @param offset  Centre of the rectangle in the robot's frame [m].
  [[nodiscard]] static Footprint rectangle(
      double length,
      double width,
      const Eigen::Vector2d& offset = Eigen::Vector2d::Zero()) noexcept;

  /// Returns whether the footprint is a rectangle, and not a union of discs.
  [[nodiscard]] bool is_rectangle() const noexcept { return count_ == 0; }
  [[nodiscard]] int num_discs() const noexcept { return count_; }  ///< 0 for a rectangle

  /// Returns disc `i` in the robot's frame. @pre i < num_discs().
  [[nodiscard]] const Disc& disc_at(int i) const noexcept {
    return discs_[static_cast<std::size_t>(i)];
  }

  /// Returns the rectangle in the world, for a robot at `pose`. @pre is_rectangle().
  [[nodiscard]] OrientedRectangle rectangle_at(const Pose2& pose) const noexcept {
    return {.seed = pose.position, .orientation = pose.heading, .min = low_, .max = high_};
  }

  /// Radius of the smallest disc about the robot's centre that covers the footprint [m].
  [[nodiscard]] double circumscribed_radius() const noexcept { return circumscribed_; }

  /// Radius of the largest disc about the robot's centre that lies inside the footprint [m]. It is
  /// 0 if the centre lies outside. For a union of discs, only the best single disc is considered.
  [[nodiscard]] double inscribed_radius() const noexcept;

  /// Returns the footprint with every side and radius reduced by `amount` [m], at most down to a
  /// point.
  [[nodiscard]] Footprint shrunk(double amount) const noexcept;

  /// Distance from `local`, a point in the robot's frame, to the footprint [m]; 0 inside.
  [[nodiscard]] double distance(const Eigen::Vector2d& local) const noexcept;

 private:
  void measure() noexcept;

  int count_ = 0;
  std::array<Disc, kMaxDiscs> discs_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_ = Eigen::Vector2d::Zero();
  double circumscribed_ = 0.0;
};

/// The discs that make up a body, as a setting: none, or up to Footprint::kMaxDiscs.
///
/// The text form is a list of [x, y, radius] in the robot's frame [m], and "[]" for no disc; for
/// example "[[0.2, 0, 0.25], [-0.2, 0, 0.25]]".
struct BodyDiscs {
  static constexpr double kMostOffset = 20.0;  ///< of a centre from the origin, along each axis [m]
  static constexpr double kLeastRadius = 0.01;  ///< [m]
  static constexpr double kMostRadius = 10.0;   ///< [m]

  int count = 0;
  std::array<Footprint::Disc, Footprint::kMaxDiscs> discs{};

  /// Adds a disc. Returns false, and adds nothing, if there are too many discs or this one is out
  /// of range.
  [[nodiscard]] bool add(const Eigen::Vector2d& center, double radius) noexcept;
};

/// Returns whether the number of discs is allowed and each disc is in range.
[[nodiscard]] bool is_valid(const BodyDiscs& discs) noexcept;

/// Returns whether two bodies have the same discs in the same order.
[[nodiscard]] bool operator==(const BodyDiscs& a, const BodyDiscs& b) noexcept;

/// Returns the text form, with the shortest numbers that `parse_body_discs` reads back exactly.
[[nodiscard]] std::string to_text(const BodyDiscs& discs);

/// Parses the text form. Returns none if the text has another form or a number is out of range.
[[nodiscard]] std::optional<BodyDiscs> parse_body_discs(std::string_view text) noexcept;

/// Describes the text form in messages and documentation.
inline constexpr const char* kBodyDiscsExpected =
    "up to 8 of [x, y, radius], radius from 0.01 to 10, x and y from -20 to 20";

}  // namespace fairway
