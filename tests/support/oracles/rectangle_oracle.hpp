// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "fairway/map/bit_grid.hpp"

namespace fairway::test {

/// Returns the area [m^2] of the largest rectangle around `seed`, over `num_angles` orientations.
/// No corner of a blocked cell is in its interior, and no side is longer than `longest_side` [m].
/// Where a side could be longer, only that length counts.
///
/// Slow and simple. At each orientation all corners within reach are sorted by height, and every
/// height above is paired with every height below. Every rectangle that is free in the workspace
/// avoids the corners too, so none of these orientations has a larger one. A rectangle here may
/// contain a part of a cell between two of its corners, at most half a cell deep.
inline double largest_area_oracle(const BitGrid& obstacles,
                                  const Eigen::Vector2d& seed,
                                  double longest_side,
                                  int num_angles) {
  struct Level {
    double height;
    double left;
    double right;
  };
  const GridFrame& frame = obstacles.frame();
  const Eigen::Vector2d origin = frame.to_grid(seed);
  const double limit = longest_side / frame.resolution;
  std::vector<Eigen::Vector2d> corners;
  // The outside of the map is blocked; a ring of one cell around the map represents it.
  const int radius = static_cast<int>(std::ceil(limit * std::numbers::sqrt2)) + 1;
  const CellIndex center = frame.cell_at(seed);
  for (int y = std::max(-1, center.y - radius); y <= std::min(frame.height, center.y + radius);
       ++y) {
    for (int x = std::max(-1, center.x - radius); x <= std::min(frame.width, center.x + radius);
         ++x) {
      const bool buried = obstacles.blocked({x - 1, y}) && obstacles.blocked({x + 1, y}) &&
                          obstacles.blocked({x, y - 1}) && obstacles.blocked({x, y + 1});
      if (!obstacles.blocked({x, y}) || (buried && frame.contains({x, y}))) continue;
      for (int corner = 0; corner < 4; ++corner)
        corners.push_back(Eigen::Vector2d(x + corner % 2, y + corner / 2) - origin);
    }
  }
  double best = 0.0;
  std::vector<Eigen::Vector2d> turned;
  const auto levels = [&](double sign) {
    std::vector<Level> result;
    double left = -limit;
    double right = limit;
    for (const Eigen::Vector2d& p : turned) {
      const double height = sign * p.y();
      if (height <= 0.0 || height >= limit || p.x() <= left || p.x() >= right) continue;
      result.push_back({height, left, right});
      (p.x() > 0.0 ? right : left) = p.x();
    }
    result.push_back({limit, left, right});
    return result;
  };
  for (int k = 0; k < num_angles; ++k) {
    const Eigen::Vector2d u = direction(std::numbers::pi / 2.0 * k / num_angles);
    turned.clear();
    for (const Eigen::Vector2d& p : corners) {
      const Eigen::Vector2d t(u.x() * p.x() + u.y() * p.y(), u.x() * p.y() - u.y() * p.x());
      if (t.cwiseAbs().maxCoeff() < limit) turned.push_back(t);
    }
    std::sort(turned.begin(), turned.end(),
              [](const auto& a, const auto& b) { return std::abs(a.y()) < std::abs(b.y()); });
    const std::vector<Level> tops = levels(1.0);
    const std::vector<Level> bottoms = levels(-1.0);
    for (const Level& top : tops) {
      for (const Level& bottom : bottoms) {
        const double width = std::min(top.right, bottom.right) - std::max(top.left, bottom.left);
        const double height = top.height + bottom.height;
        best = std::max(best, std::min(limit, width) * std::min(limit, height));
      }
    }
  }
  return best * frame.resolution * frame.resolution;
}

}  // namespace fairway::test
