// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <Eigen/Core>

namespace fairway {

/// An axis-parallel box in a turned frame, as a closed set.
struct Box {
  Eigen::Vector2d min = Eigen::Vector2d::Zero();
  Eigen::Vector2d max = Eigen::Vector2d::Zero();

  [[nodiscard]] double area() const noexcept { return (max.x() - min.x()) * (max.y() - min.y()); }

  [[nodiscard]] bool contains(const Eigen::Vector2d& p) const noexcept {
    return p.x() >= min.x() && p.x() <= max.x() && p.y() >= min.y() && p.y() <= max.y();
  }

  [[nodiscard]] Eigen::Vector2d nearest(const Eigen::Vector2d& p) const noexcept {
    return p.cwiseMax(min).cwiseMin(max);
  }

  [[nodiscard]] Eigen::Vector2d center() const noexcept { return 0.5 * (min + max); }
};

}  // namespace fairway
