// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// Some points that a free rectangle around an origin must not hold: the partial knowledge that the
/// search for a large rectangle starts from and adds to.
///
/// Each point lies in the configuration-space obstacle of a blocked cell, the cell grown by a disc.
/// A rectangle that avoids these points may still hit an obstacle; but none that is free can be
/// larger than the largest that avoids them. Coordinates are relative to the origin [cells]; the
/// points are kept in order of their direction, seen from the origin. When full, further points are
/// ignored.
class ObstaclePoints {
 public:
  static constexpr std::size_t kCapacity = 256;

  /// Forgets everything; then looks for obstacles along rays from `origin` [grid coordinates].
  ///
  /// The rays are sampled ever more coarsely, so thin obstacles may be missed: this is a first
  /// guess. `radius` is that of the disc, `reach` the length of the rays [cells].
  /// @pre no blocked cell is at most `radius` from the origin.
  void look_around(const BitGrid& obstacles,
                   const Eigen::Vector2d& origin,
                   double radius,
                   double reach) noexcept;

  /// Adds a point. @pre it lies in the obstacle of some cell, and is not the origin.
  void add(const Eigen::Vector2d& point) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// How many points were added one by one since look_around, and those points.
  [[nodiscard]] std::size_t added() const noexcept { return added_; }
  [[nodiscard]] std::pair<float, float> in_order_added(std::size_t i) const noexcept {
    return {added_x_[i], added_y_[i]};
  }

  /// Coordinates of all points, in order of direction from -x through -y, +x, +y.
  [[nodiscard]] const float* x() const noexcept { return x_.data(); }
  [[nodiscard]] const float* y() const noexcept { return y_.data(); }

  /// Index of the first point whose direction is at or after (c, s); size() when there is none.
  [[nodiscard]] std::size_t first_from(double c, double s) const noexcept;

 private:
  std::size_t size_ = 0;
  std::size_t added_ = 0;
  std::array<float, kCapacity> x_{};
  std::array<float, kCapacity> y_{};
  std::array<float, kCapacity> key_{};
  std::array<float, kCapacity> added_x_{};
  std::array<float, kCapacity> added_y_{};
};

}  // namespace fairway
