// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/scenarios/generated_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kCell = 0.05;         // [m]
constexpr double kClearCorner = 1.5;   // start and goal lie this far inside the corners [m]
constexpr double kCornerRadius = 1.0;  // kept free around them [m]

// SplitMix64 is small and gives the same numbers everywhere, unlike the standard distributions.
class Draw {
 public:
  // The state advances by a constant. Seeds that differ by a multiple of it would give shifted
  // copies of one stream. So the seed is mixed first.
  explicit Draw(std::uint64_t seed) noexcept : state_(mixed(seed)) {}

  double uniform(double low, double high) noexcept {
    return low + (high - low) * (static_cast<double>(next() >> 11U) * 0x1.0p-53);
  }

  int integer(int low, int high) noexcept {
    return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  static constexpr std::uint64_t mixed(std::uint64_t z) noexcept {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }
  std::uint64_t next() noexcept { return mixed(state_ += 0x9e3779b97f4a7c15ULL); }

  std::uint64_t state_;
};

class Canvas {
 public:
  explicit Canvas(double side)
      : side_(side),
        grid_(GridFrame{.width = static_cast<int>(std::lround(side / kCell)),
                        .height = static_cast<int>(std::lround(side / kCell)),
                        .resolution = kCell,
                        .origin = {}}) {}

  [[nodiscard]] double side() const noexcept { return side_; }
  [[nodiscard]] const OccupancyGrid& grid() const noexcept { return grid_; }

  // Fills the cells from column x0, row y0 to x1, y1, inclusive.
  void block(int x0, int y0, int x1, int y1) {
    for (int y = std::max(y0, 0); y <= std::min(y1, grid_.frame().height - 1); ++y) {
      for (int x = std::max(x0, 0); x <= std::min(x1, grid_.frame().width - 1); ++x)
        put({.x = x, .y = y});
    }
  }

  // Fills every cell whose centre lies in the convex polygon given by points around `center`.
  template <std::size_t N>
  void polygon(const std::array<Vector2d, N>& corners, std::size_t count) {
    Vector2d low = corners[0];
    Vector2d high = corners[0];
    for (std::size_t i = 1; i < count; ++i) {
      low = low.cwiseMin(corners[i]);
      high = high.cwiseMax(corners[i]);
    }
    const CellIndex first = grid_.frame().cell_at(low);
    const CellIndex last = grid_.frame().cell_at(high);
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        const Vector2d p = grid_.frame().center({.x = x, .y = y});
        bool inside = true;
        for (std::size_t i = 0; i < count && inside; ++i) {
          const Vector2d a = corners[i];
          const Vector2d edge = corners[(i + 1) % count] - a;
          inside = edge.x() * (p.y() - a.y()) - edge.y() * (p.x() - a.x()) >= 0.0;
        }
        if (inside) put({.x = x, .y = y});
      }
    }
  }

  // Draws a line that is one cell wide.
  void line(const Vector2d& from, const Vector2d& to) {
    const double length = (to - from).norm();
    const int steps = 1 + static_cast<int>(length / (0.5 * kCell));
    for (int i = 0; i <= steps; ++i)
      put(grid_.frame().cell_at(from + (to - from) * (static_cast<double>(i) / steps)));
  }

 private:
  void put(CellIndex cell) {
    if (!grid_.frame().contains(cell)) return;
    const Vector2d p = grid_.frame().center(cell);
    const Vector2d low = Vector2d::Constant(kClearCorner);
    const Vector2d high = Vector2d::Constant(side_ - kClearCorner);
    const bool wall = cell.x == 0 || cell.y == 0 || cell.x == grid_.frame().width - 1 ||
                      cell.y == grid_.frame().height - 1;
    if (!wall && ((p - low).norm() < kCornerRadius || (p - high).norm() < kCornerRadius)) return;
    grid_.set(cell, CellState::Occupied);
  }

  double side_;
  OccupancyGrid grid_;
};

// Draws a convex polygon: corners at increasing angles on a randomly turned ellipse.
void draw_polygon(Canvas& canvas, Draw& draw, double least, double most) {
  std::array<Vector2d, 8> corners;
  const auto count = static_cast<std::size_t>(draw.integer(3, 8));
  const Vector2d center(draw.uniform(0, canvas.side()), draw.uniform(0, canvas.side()));
  const double a = draw.uniform(least, most);
  const double b = a * draw.uniform(0.3, 1.0);
  const double turn = draw.uniform(0, std::numbers::pi);
  const double sector = 2.0 * std::numbers::pi / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = sector * (static_cast<double>(i) + draw.uniform(0.0, 0.8));
    corners[i] = center + rotated({a * std::cos(t), b * std::sin(t)}, turn);
  }
  canvas.polygon(corners, count);
}

void draw_unstructured(Canvas& canvas, Draw& draw) {
  const double area = canvas.side() * canvas.side();
  for (int i = static_cast<int>(0.33 * area); i > 0; --i)
    draw_polygon(canvas, draw, 0.2, 0.7);
  for (int i = static_cast<int>(0.03 * area); i > 0; --i) {  // posts of one cell
    const int n = canvas.grid().frame().width - 1;
    const int x = draw.integer(0, n);
    const int y = draw.integer(0, n);
    canvas.block(x, y, x, y);
  }
  for (int i = static_cast<int>(0.015 * area); i > 0; --i) {
    const Vector2d from(draw.uniform(0, canvas.side()), draw.uniform(0, canvas.side()));
    const double length = draw.uniform(0.5, 2.5);
    canvas.line(from, from + length * direction(draw.uniform(0, 2.0 * std::numbers::pi)));
  }
}

void draw_structured(Canvas& canvas, Draw& draw) {
  // Draws walls every 5 to 7 m in both directions, with a door between any two crossings.
  const int n = canvas.grid().frame().width;
  constexpr int kRoom = 120;  // [cells]
  constexpr int kDoor = 28;   // 1.4 m
  constexpr int kWall = 3;
  for (int wall = kRoom; wall < n - kRoom / 2; wall += kRoom) {
    const int at = wall + draw.integer(-15, 15);
    for (int from = 0; from < n; from += kRoom) {
      const int door = from + draw.integer(20, kRoom - kDoor - 20);
      const int to = std::min(n, from + kRoom) - 1;
      const int other_door = from + draw.integer(20, kRoom - kDoor - 20);
      canvas.block(at, from, at + kWall, door);
      canvas.block(at, door + kDoor, at + kWall, to);
      canvas.block(from, at, other_door, at + kWall);
      canvas.block(other_door + kDoor, at, to, at + kWall);
    }
  }
  for (int i = static_cast<int>(0.03 * canvas.side() * canvas.side()); i > 0; --i) {
    const int x = draw.integer(0, n - 1);
    const int y = draw.integer(0, n - 1);
    canvas.block(x, y, x + draw.integer(4, 24), y + draw.integer(4, 24));
  }
}

}  // namespace

double side_length(MapKind kind) noexcept {
  switch (kind) {
    case MapKind::UnstructuredLarge:
      return 50.0;
    case MapKind::UnstructuredSmall:
      return 25.0;
    case MapKind::Structured:
      return 30.0;
    case MapKind::Field:
      return 20.0;
  }
  return 20.0;
}

OccupancyGrid generate_map(MapKind kind, std::uint64_t seed, int num_obstacles) {
  Draw draw(seed * 4 + static_cast<std::uint64_t>(kind));
  Canvas canvas(side_length(kind));
  const int last = canvas.grid().frame().width - 1;
  canvas.block(0, 0, last, 0);
  canvas.block(0, last, last, last);
  canvas.block(0, 0, 0, last);
  canvas.block(last, 0, last, last);
  switch (kind) {
    case MapKind::UnstructuredLarge:
    case MapKind::UnstructuredSmall:
      draw_unstructured(canvas, draw);
      break;
    case MapKind::Structured:
      draw_structured(canvas, draw);
      break;
    case MapKind::Field:
      for (int i = 0; i < num_obstacles; ++i)
        draw_polygon(canvas, draw, 0.6, 2.0);
      break;
  }
  return canvas.grid();
}

}  // namespace fairway
