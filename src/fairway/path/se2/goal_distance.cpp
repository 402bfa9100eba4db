// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/goal_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace fairway {

namespace {

constexpr float kNotReached = std::numeric_limits<float>::infinity();
constexpr int kMostCells = 16000;

// Whether the reference may be anywhere in a large cell.
bool may_fit(const DistanceField& distances, CellIndex large, int factor, double radius) noexcept {
  const GridFrame& frame = distances.frame();
  const double half_diagonal = 0.71 * frame.resolution;
  for (int y = large.y * factor; y < std::min(frame.height, (large.y + 1) * factor); ++y) {
    for (int x = large.x * factor; x < std::min(frame.width, (large.x + 1) * factor); ++x) {
      if (distances.at({.x = x, .y = y}) + half_diagonal >= radius) return true;
    }
  }
  return false;
}

}  // namespace

GoalDistance::GoalDistance(const BodyClearance& clearance, const Eigen::Vector2d& target) {
  const DistanceField& distances = clearance.distances();
  const GridFrame& fine = distances.frame();
  int factor = 1;
  const auto large_side = [&](int side) { return (side + factor - 1) / factor; };
  while (static_cast<std::int64_t>(large_side(fine.width)) * large_side(fine.height) > kMostCells)
    ++factor;
  frame_ = {.width = large_side(fine.width),
            .height = large_side(fine.height),
            .resolution = fine.resolution * factor,
            .origin = fine.origin};
  const auto count =
      static_cast<std::size_t>(frame_.width) * static_cast<std::size_t>(frame_.height);
  lengths_.assign(count, kNotReached);
  const double radius = clearance.body().inscribed_radius(Eigen::Vector2d::Zero());
  std::vector<std::uint8_t> open(count, 0);
  const auto index = [&](CellIndex cell) {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(frame_.width) +
           static_cast<std::size_t>(cell.x);
  };
  for (int y = 0; y < frame_.height; ++y) {
    for (int x = 0; x < frame_.width; ++x)
      open[index({.x = x, .y = y})] = may_fit(distances, {.x = x, .y = y}, factor, radius) ? 1 : 0;
  }
  struct Entry {
    float length;
    CellIndex cell;
    bool operator<(const Entry& other) const noexcept { return length > other.length; }
  };
  std::priority_queue<Entry> queue;
  const CellIndex first = frame_.cell_at(target);
  if (!frame_.contains(first)) return;
  lengths_[index(first)] = 0.0F;
  queue.push({.length = 0.0F, .cell = first});
  const auto straight = static_cast<float>(frame_.resolution);
  const float slanted = straight * std::sqrt(2.0F);
  while (!queue.empty()) {
    const Entry now = queue.top();
    queue.pop();
    if (now.length > lengths_[index(now.cell)]) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const CellIndex next{.x = now.cell.x + dx, .y = now.cell.y + dy};
        if (!frame_.contains(next) || open[index(next)] == 0) continue;
        const float length = now.length + (dx != 0 && dy != 0 ? slanted : straight);
        if (length >= lengths_[index(next)]) continue;
        lengths_[index(next)] = length;
        queue.push({.length = length, .cell = next});
      }
    }
  }
}

double GoalDistance::at(const Eigen::Vector2d& point) const noexcept {
  const CellIndex cell = frame_.cell_at(point);
  if (!frame_.contains(cell)) return std::numeric_limits<double>::infinity();
  const auto length = static_cast<double>(
      lengths_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(frame_.width) +
               static_cast<std::size_t>(cell.x)]);
  // Eight neighbours overestimate a straight line by up to 8.24 %, and both ends lie anywhere in
  // their cells.
  constexpr double kOctagon = 1.0824;
  constexpr double kDiagonal = 1.4143;
  return std::max(0.0, (length - 2.0 * kDiagonal * frame_.resolution) / kOctagon);
}

}  // namespace fairway
