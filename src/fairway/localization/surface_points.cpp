// SPDX-License-Identifier: Apache-2.0
#include "fairway/localization/surface_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kFurthestPoint = 1e8;  // [m]; further points are ignored

std::int32_t cell_of(double coordinate) noexcept {
  return static_cast<std::int32_t>(std::floor(coordinate / SurfacePoints::kCell));
}

// First and second moments of points, relative to one of them.
struct Moments {
  double count = 0.0;
  Vector2d sum = Vector2d::Zero();
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  void add(const Vector2d& p) noexcept {
    count += 1.0;
    sum += p;
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    yy += p.y() * p.y();
  }

  // Returns the direction across the line through the points; none if they form no line.
  [[nodiscard]] std::optional<Vector2d> across() const noexcept {
    constexpr double kFlat = 0.35;  // greatest ratio of the deviations across and along the line
    const double sxx = xx - sum.x() * sum.x() / count;
    const double sxy = xy - sum.x() * sum.y() / count;
    const double syy = yy - sum.y() * sum.y() / count;
    const double mean = 0.5 * (sxx + syy);
    const double apart = 0.5 * (sxx - syy);
    const double half = std::sqrt(apart * apart + sxy * sxy);
    if (!(half > 0.0) || mean - half > kFlat * kFlat * (mean + half)) return std::nullopt;
    // The eigenvector of the smaller eigenvalue, by the larger of two equivalent forms.
    const double least = mean - half;
    const Vector2d one(sxy, least - sxx);
    const Vector2d other(least - syy, sxy);
    return (sxx > syy ? one : other).normalized();
  }
};

}  // namespace

SurfacePoints::SurfacePoints(double window)
    : mask_(std::bit_ceil(static_cast<std::size_t>(std::ceil(window / kCell)) + 1) - 1),
      cells_((mask_ + 1) * (mask_ + 1)) {}

void SurfacePoints::add(const SurfacePoint& point) noexcept {
  if (!(point.position.cwiseAbs().maxCoeff() < kFurthestPoint)) return;
  const std::int32_t x = cell_of(point.position.x());
  const std::int32_t y = cell_of(point.position.y());
  Cell& cell = cells_[index(x, y)];
  if (cell.x != x || cell.y != y) {
    cell.x = x;
    cell.y = y;
    cell.count = 0;
  }
  if (cell.count >= kPerCell) return;
  for (std::size_t i = 0; i < cell.count; ++i) {
    const SurfacePoint& other = cell.points[i];
    if ((other.position - point.position).squaredNorm() < kSpacing * kSpacing &&
        other.normal.dot(point.normal) > 0.0) {
      return;
    }
  }
  cell.points[cell.count++] = point;
  ++added_;
}

const SurfacePoint* SurfacePoints::nearest(const SurfacePoint& to, double reach) const noexcept {
  constexpr double kSameSide = 0.5;  // cosine of the angle between the normals
  if (!(to.position.cwiseAbs().maxCoeff() < kFurthestPoint)) return nullptr;
  const SurfacePoint* best = nullptr;
  double least = reach * reach;
  const auto look_into = [&](std::int32_t x, std::int32_t y) {
    const Cell& cell = cells_[index(x, y)];
    if (cell.x != x || cell.y != y) return;
    for (std::size_t i = 0; i < cell.count; ++i) {
      const double away = (cell.points[i].position - to.position).squaredNorm();
      if (away >= least || cell.points[i].normal.dot(to.normal) < kSameSide) continue;
      least = away;
      best = &cell.points[i];
    }
  };
  // The cell of the point nearly always has a point so near that no other cell has a nearer one.
  const std::int32_t x = cell_of(to.position.x());
  const std::int32_t y = cell_of(to.position.y());
  look_into(x, y);
  // Distances to the sides of the cell. As reach <= kCell, only the next cells can be in reach.
  const double low_x = to.position.x() - kCell * x;
  const double low_y = to.position.y() - kCell * y;
  const auto gap = [](double low, std::int32_t step) {
    return step == 0 ? 0.0 : step < 0 ? low : kCell - low;
  };
  constexpr double kRounding = 1e-6;  // [m]; of far coordinates
  for (const std::int32_t dy : {0, -1, 1}) {
    const double gap_y = std::max(0.0, gap(low_y, dy) - kRounding);
    if (gap_y * gap_y >= least) continue;
    for (const std::int32_t dx : {0, -1, 1}) {
      const double gap_x = std::max(0.0, gap(low_x, dx) - kRounding);
      if ((dx == 0 && dy == 0) || gap_x * gap_x + gap_y * gap_y >= least) continue;
      look_into(x + dx, y + dy);
    }
  }
  return best;
}

void surface_of_scan(std::span<const Vector2d> ends,
                     const Vector2d& sensor,
                     std::vector<SurfacePoint>& points,
                     std::vector<std::size_t>& beams) {
  constexpr double kNear = 0.12;     // [m]; neighbours of a point
  constexpr std::size_t kMost = 12;  // neighbours on each side
  constexpr double kFewest = 4.0;    // points that make a line
  points.clear();
  beams.clear();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Vector2d& point = ends[i];
    if (!point.allFinite()) continue;
    Moments moments;
    moments.add(Vector2d::Zero());
    const auto add_side = [&](auto&& neighbour) {
      for (std::size_t n = 1; n <= kMost; ++n) {
        const Vector2d* const other = neighbour(n);
        if (other == nullptr) return;
        if (!other->allFinite()) continue;
        const Vector2d away = *other - point;
        if (away.squaredNorm() > kNear * kNear) return;
        moments.add(away);
      }
    };
    add_side([&](std::size_t n) { return n <= i ? &ends[i - n] : nullptr; });
    add_side([&](std::size_t n) { return i + n < ends.size() ? &ends[i + n] : nullptr; });
    if (moments.count < kFewest) continue;
    std::optional<Vector2d> normal = moments.across();
    if (!normal) continue;
    if (normal->dot(sensor - point) < 0.0) *normal = -*normal;
    points.push_back({.position = point, .normal = *normal});
    beams.push_back(i);
  }
}

void add_surface_of_map(const BitGrid& map, SurfacePoints& points) {
  constexpr int kAround = 3;  // [cells]; the sides within it give the normal
  const GridFrame& frame = map.frame();
  points.set_exact_normals(true);
  // Mean direction to the free cells around a side: a straight staircase then has one normal.
  const auto normal_at = [&](const Vector2d& middle) {
    Vector2d sum = Vector2d::Zero();
    const int x0 = static_cast<int>(std::floor(middle.x()));
    const int y0 = static_cast<int>(std::floor(middle.y()));
    for (int y = y0 - kAround; y <= y0 + kAround; ++y) {
      for (int x = x0 - kAround; x <= x0 + kAround; ++x) {
        const Vector2d away = Vector2d(x + 0.5, y + 0.5) - middle;
        if (away.squaredNorm() > kAround * kAround) continue;
        sum += map.blocked({.x = x, .y = y}) ? Vector2d(-away) : away;
      }
    }
    return sum;
  };
  constexpr std::array<int, 4> kDx{1, -1, 0, 0};
  constexpr std::array<int, 4> kDy{0, 0, 1, -1};
  for (int y = 0; y < frame.height; ++y) {
    for (int x = map.first_blocked(y, 0, frame.width - 1); x >= 0;
         x = map.first_blocked(y, x + 1, frame.width - 1)) {
      for (std::size_t side = 0; side < kDx.size(); ++side) {
        const CellIndex beyond{.x = x + kDx[side], .y = y + kDy[side]};
        if (!frame.contains(beyond) || map.blocked(beyond)) continue;
        const Vector2d middle(x + 0.5 + 0.5 * kDx[side], y + 0.5 + 0.5 * kDy[side]);
        Vector2d normal = normal_at(middle);
        if (normal.dot(Vector2d(kDx[side], kDy[side])) <= 0.0)
          normal = Vector2d(kDx[side], kDy[side]);
        points.add({.position = frame.to_world(middle),
                    .normal = rotated(normal.normalized(), frame.origin.heading)});
      }
    }
  }
}

}  // namespace fairway
