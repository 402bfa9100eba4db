// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/obstacle_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kRays = 72;

// Increases with the direction of (x, y) from -x counter-clockwise, in [-2, 2); no arctangent.
float direction_key(float x, float y) noexcept {
  const float slope = x / (std::abs(x) + std::abs(y));
  return y < 0.0F ? slope - 1.0F : 1.0F - slope;
}

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
  size_ = 0;
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
  added_ = 0;
}

void ObstaclePoints::add(const Vector2d& point) noexcept {
  if (size_ == kCapacity) return;
  const auto x = static_cast<float>(point.x());
  const auto y = static_cast<float>(point.y());
  const float key = direction_key(x, y);
  added_x_[added_] = x;
  added_y_[added_++] = y;
  // Behind those of the same direction; mostly at the end, as rays come in order.
  std::size_t i = size_;
  if (i > 0 && key_[i - 1] > key) {
    const float* const at = std::upper_bound(key_.data(), key_.data() + size_, key);
    i = static_cast<std::size_t>(at - key_.data());
    const auto make_room = [&](std::array<float, kCapacity>& values) {
      std::copy_backward(values.begin() + static_cast<std::ptrdiff_t>(i),
                         values.begin() + static_cast<std::ptrdiff_t>(size_),
                         values.begin() + static_cast<std::ptrdiff_t>(size_ + 1));
    };
    make_room(x_);
    make_room(y_);
    make_room(key_);
  }
  ++size_;
  x_[i] = x;
  y_[i] = y;
  key_[i] = key;
}

std::size_t ObstaclePoints::first_from(double c, double s) const noexcept {
  const float key = direction_key(static_cast<float>(c), static_cast<float>(s));
  return static_cast<std::size_t>(
      std::lower_bound(key_.begin(), key_.begin() + static_cast<std::ptrdiff_t>(size_), key) -
      key_.begin());
}

}  // namespace fairway
