// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/obstacle_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kRays = 48;
// Rays are followed from tile to tile of 8 x 8 cells. A band of rows shows at once whether any cell
// of a tile is blocked. A ray therefore detects obstacles up to a tile beside it: those that limit
// every rectangle along it unless it is very narrow.
constexpr int kTile = BitGrid::kBandRows;
// A ray ends at an obstacle closer to it than this [cells], or at the third beside it.
constexpr double kCloseToRay = 2.5;
constexpr int kMostBeside = 3;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

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

struct Sight {
  CellIndex cell;
  // Distance of the cell's centre from the ray, along the shorter axis [cells].
  double beside = 0.0;
};

// One tile, as seen along a ray from `origin`.
class Tile {
 public:
  Tile(const BitGrid& obstacles, int x, int y) noexcept
      : obstacles_(obstacles),
        left_(x & -kTile),
        bottom_(y & -kTile),
        rows_(std::min(kTile, obstacles.frame().height - bottom_)),
        columns_(bits(obstacles.band(y / kTile))) {}

  [[nodiscard]] bool empty() const noexcept { return columns_ == 0; }

  // Returns the first blocked row or column along the ray, and in it the cell nearest to the ray.
  [[nodiscard]] Sight first(const Vector2d& origin, const Vector2d& ray) const noexcept {
    return std::abs(ray.x()) > std::abs(ray.y()) ? first_column(origin, ray)
                                                 : first_row(origin, ray);
  }

 private:
  [[nodiscard]] unsigned bits(std::span<const std::uint64_t> words) const noexcept {
    return static_cast<unsigned>(words[static_cast<std::size_t>(left_) / 64] >> (left_ % 64)) &
           0xffU;
  }

  [[nodiscard]] Sight first_column(const Vector2d& origin, const Vector2d& ray) const noexcept {
    const int column =
        ray.x() > 0.0 ? std::countr_zero(columns_) : static_cast<int>(std::bit_width(columns_)) - 1;
    Sight sight{.cell = {.x = left_ + column, .y = 0}, .beside = 2.0 * kTile};
    const double y = origin.y() + (sight.cell.x + 0.5 - origin.x()) * ray.y() / ray.x() - 0.5;
    for (int row = bottom_; row < bottom_ + rows_; ++row) {
      const double beside = std::abs(row - y);
      const bool blocked = (bits(obstacles_.row(row)) >> column & 1U) != 0;
      if (!blocked || beside >= sight.beside) continue;
      sight.cell.y = row;
      sight.beside = beside;
    }
    return sight;
  }

  [[nodiscard]] Sight first_row(const Vector2d& origin, const Vector2d& ray) const noexcept {
    const int step = ray.y() > 0.0 ? 1 : -1;
    int row = ray.y() > 0.0 ? bottom_ : bottom_ + rows_ - 1;
    while (bits(obstacles_.row(row)) == 0)
      row += step;
    Sight sight{.cell = {.x = 0, .y = row}, .beside = 2.0 * kTile};
    const double x = origin.x() + (row + 0.5 - origin.y()) * ray.x() / ray.y() - 0.5;
    for (unsigned blocked = bits(obstacles_.row(row)); blocked != 0; blocked &= blocked - 1) {
      const int column = left_ + std::countr_zero(blocked);
      const double beside = std::abs(column - x);
      if (beside >= sight.beside) continue;
      sight.cell.x = column;
      sight.beside = beside;
    }
    return sight;
  }

  const BitGrid& obstacles_;
  int left_;
  int bottom_;
  int rows_;
  unsigned columns_;  // bit i is set if column left_ + i is blocked in some row
};

}  // namespace

void ObstaclePoints::look_around(const BitGrid& obstacles,
                                 const Vector2d& origin,
                                 double radius,
                                 double reach,
                                 std::size_t spacing) noexcept {
  static const Rays rays;
  clear();
  const GridFrame& frame = obstacles.frame();
  const Vector2d low = Vector2d::Constant(radius) - origin;
  const Vector2d high = Vector2d(frame.width, frame.height) - Vector2d::Constant(radius) - origin;
  CellIndex last{.x = -1, .y = -1};
  for (std::size_t i = 0; i < kRays; i += spacing) {
    const Vector2d& ray = rays.directions[i];
    // The distance at which the disc would leave the map.
    const double end_x = (ray.x() > 0.0 ? high : low).x() / ray.x();
    const double end_y = (ray.y() > 0.0 ? high : low).y() / ray.y();
    const double end = std::min(end_x, end_y);
    const double stop = std::min(end, reach);
    int left = kMostBeside;
    for (double t = 0.5 * kTile; t < stop && left > 0; t += kTile) {
      const Vector2d at = origin + t * ray;
      const Tile tile(obstacles, static_cast<int>(at.x()), static_cast<int>(at.y()));
      if (tile.empty()) continue;
      const Sight sight = tile.first(origin, ray);
      left = sight.beside <= kCloseToRay ? 0 : left - 1;
      if (sight.cell == last) continue;
      last = sight.cell;
      const Vector2d corner = Vector2d(last.x, last.y) - origin;
      const Vector2d nearest = corner.cwiseMax((corner + Vector2d::Ones()).cwiseMin(0.0));
      const double distance = nearest.norm();
      if (distance > radius) add(nearest * (1.0 - radius / distance));
    }
    if (left > 0 && end < reach) add(end * ray);
  }
}

void ObstaclePoints::clear() noexcept {
  const auto used = static_cast<std::ptrdiff_t>(4 * steps_);
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
  if (size_ % 4 == 0) {
    for (std::size_t k = 1; k < 4; ++k)
      x_[size_ + k] = y_[size_ + k] = kNone;
  }
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
  // Insert behind the points of the same direction; this is mostly the end, as rays come in order.
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
