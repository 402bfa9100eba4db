// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// Points that a free rectangle around an origin must not contain. The search for a large rectangle
/// starts from this partial knowledge about obstacles.
///
/// Each point lies in the configuration-space obstacle of a blocked cell (the cell grown by a
/// disc). A rectangle that avoids these points may still meet an obstacle, but no free rectangle is
/// larger than the largest one that avoids them. Coordinates are relative to the origin [cells]. If
/// the set is full, further points are ignored.
class ObstaclePoints {
 public:
  static constexpr std::size_t kCapacity = 512;
  ObstaclePoints() noexcept { clear(); }

  void clear() noexcept;

  /// Clears the set, and then collects obstacles along rays from `origin` [grid coordinates].
  ///
  /// A ray detects some obstacles up to a tile of 8 cells beside it. It ends at the first obstacle
  /// close to it. Obstacles between two rays may be missed; the set is a first guess. `radius` is
  /// the radius of the disc and `reach` the length of the rays [cells]. Of the 48 rays only every
  /// `spacing`-th is followed.
  /// @pre no blocked cell is at most `radius` from the origin.
  void look_around(const BitGrid& obstacles,
                   const Eigen::Vector2d& origin,
                   double radius,
                   double reach,
                   std::size_t spacing = 1) noexcept;

  /// Adds a point. @pre it lies in the obstacle of a cell, and is not the origin.
  void add(const Eigen::Vector2d& point) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// Coordinates of all points in the order in which they were added, padded with NaN to a multiple
  /// of four.
  [[nodiscard]] const float* x() const noexcept { return x_.data(); }
  [[nodiscard]] const float* y() const noexcept { return y_.data(); }

  /// The same points by quadrants, counter-clockwise from the upper right one, each sorted by
  /// direction. Entry 4 i + q is the i-th of quadrant q: `ahead` along the axis that the quadrant
  /// begins with, and `aside` along that of the next one. All quadrants have `steps()` entries,
  /// padded with NaN.
  using Steps = std::array<float, 4 * kCapacity>;
  [[nodiscard]] std::size_t steps() const noexcept { return steps_; }
  [[nodiscard]] const float* ahead() const noexcept { return ahead_.data(); }
  [[nodiscard]] const float* aside() const noexcept { return aside_.data(); }

 private:
  std::size_t size_ = 0;
  std::size_t steps_ = kCapacity;
  std::array<std::size_t, 4> count_{};  // points in each quadrant
  static_assert(kCapacity % 4 == 0);
  std::array<float, kCapacity> x_;  // NOLINT(*-member-init): filled as far as it is read
  std::array<float, kCapacity> y_;  // NOLINT(*-member-init)
  Steps ahead_;                     // NOLINT(*-member-init)
  Steps aside_;                     // NOLINT(*-member-init)
};

}  // namespace fairway
