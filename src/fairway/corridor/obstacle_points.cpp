// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/obstacle_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kRays = 72;

struct Rays {
  Rays() noexcept {
    for (std::size_t i = 0; i < kRays; ++i) {
      const double angle = -std::numbers::pi + (static_cast<double>(i) + 0.5) * 2.0 *
                                                   std::numbers::pi / static_cast<double>(kRays);
      directions[i] = Vector2d(std::cos(angle), std::sin(angle));
    }
  }
  std::array<Vector2d, kRays> directions;
};

}  // namespace

void ObstaclePoints::look_around(const BitGrid& obstacles,
                                 const Vector2d& origin,
                                 double radius,
                                 double reach) noexcept {
  static const Rays rays;
  constexpr double kFirstStep = 1.0;  // [cells]
  constexpr double kStretch = 1.1;    // each sample lies this much further out
  clear();
  const GridFrame& frame = obstacles.frame();
  const Vector2d low = Vector2d::Constant(radius) - origin;
  const Vector2d high = Vector2d(frame.width, frame.height) - Vector2d::Constant(radius) - origin;
  CellIndex last{.x = -1, .y = -1};
  for (const Vector2d& ray : rays.directions) {
    // Where the disc's centre has to turn back before the outside of the map.
    const double end_x = (ray.x() > 0.0 ? high : low).x() / ray.x();
    const double end_y = (ray.y() > 0.0 ? high : low).y() / ray.y();
    const double end = std::min(end_x, end_y);
    const double stop = std::min(end, reach);
    double t = radius + 0.5;
    for (; t < stop; t = std::max(t + kFirstStep, t * kStretch)) {
      const CellIndex cell{.x = static_cast<int>(origin.x() + t * ray.x()),
                           .y = static_cast<int>(origin.y() + t * ray.y())};
      const std::uint64_t word = obstacles.row(cell.y)[static_cast<std::size_t>(cell.x) / 64];
      if ((word >> (static_cast<unsigned>(cell.x) % 64) & 1U) == 0) continue;
      if (cell == last) break;
      last = cell;
      const Vector2d corner = Vector2d(cell.x, cell.y) - origin;
      const Vector2d nearest = corner.cwiseMax((corner + Vector2d::Ones()).cwiseMin(0.0));
      const double distance = nearest.norm();
      if (distance > radius) add(nearest * (1.0 - radius / distance));
      break;
    }
    if (t >= end && end < reach) add(end * ray);
  }
}

void ObstaclePoints::clear() noexcept {
  const auto used = static_cast<std::ptrdiff_t>(4 * steps_);
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  std::fill(ahead_.begin(), ahead_.begin() + used, kNone);
  std::fill(aside_.begin(), aside_.begin() + used, kNone);
  size_ = 0;
  steps_ = 0;
  count_.fill(0);
}

void ObstaclePoints::add(const Vector2d& point) noexcept {
  if (size_ == kCapacity) return;
  const auto x = static_cast<float>(point.x());
  const auto y = static_cast<float>(point.y());
  x_[size_] = x;
  y_[size_++] = y;
  std::size_t q = 3;
  float ahead = -y;
  float aside = x;
  if (x > 0.0F && y >= 0.0F) {
    q = 0;
    ahead = x;
    aside = y;
  } else if (x <= 0.0F && y > 0.0F) {
    q = 1;
    ahead = y;
    aside = -x;
  } else if (x < 0.0F && y <= 0.0F) {
    q = 2;
    ahead = -x;
    aside = -y;
  }
  // Behind those of the same direction; mostly at the end, as rays come in order.
  std::size_t i = count_[q]++;
  for (; i > 0 && aside_[4 * (i - 1) + q] * ahead > aside * ahead_[4 * (i - 1) + q]; --i) {
    ahead_[4 * i + q] = ahead_[4 * (i - 1) + q];
    aside_[4 * i + q] = aside_[4 * (i - 1) + q];
  }
  ahead_[4 * i + q] = ahead;
  aside_[4 * i + q] = aside;
  steps_ = std::max(steps_, count_[q]);
}

}  // namespace fairway
