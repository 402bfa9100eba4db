// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/opening_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr int kStride = 2;  // [cells] between nodes
constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr double kNarrow = 10.0;  // extra cost of a metre without any clearance
constexpr double kWall = 30.0;    // cost of a step over an occupied cell [m]
constexpr double kTried = 10.0;   // extra cost of a metre near a place that was examined

}  // namespace

// The map as a lattice of every second cell, and both ends.
struct OpeningSearch::Query {
  const PreparedMap& map;
  const TriedOpenings& tried;
  double radius;
  Vector2d goal;
  int width;
  int height;
  int start;
  bool goal_inside;

  [[nodiscard]] CellIndex cell(int node) const noexcept {
    return {.x = node % width * kStride, .y = node / width * kStride};
  }
  [[nodiscard]] Vector2d point(int node) const noexcept {
    return map.obstacles.frame().center(cell(node));
  }
  [[nodiscard]] int nearest(const Vector2d& place) const noexcept {
    const CellIndex at = map.obstacles.frame().cell_at(place);
    return std::clamp((at.y + 1) / kStride, 0, height - 1) * width +
           std::clamp((at.x + 1) / kStride, 0, width - 1);
  }
  // Whether a search may end here: at the goal, or where the window ends.
  [[nodiscard]] bool is_end(int node) const noexcept {
    if (goal_inside) return node == nearest(goal);
    const int x = node % width;
    const int y = node / width;
    return x == 0 || y == 0 || x == width - 1 || y == height - 1;
  }
  // Cost from a node where the search ends to the goal [m].
  [[nodiscard]] float rest(int node) const noexcept {
    return goal_inside ? 0.0F : static_cast<float>((point(node) - goal).norm());
  }
  // Cost per metre at a node.
  [[nodiscard]] double weight(int node) const noexcept {
    const double missing = std::max(0.0, 1.0 - map.distances.at(cell(node)) / radius);
    return 1.0 + kNarrow * missing + (missing > 0.0 && tried.near(point(node)) ? kTried : 0.0);
  }
  // Whether a step leads over an occupied cell; the first cell does not count.
  [[nodiscard]] bool crosses(int from, int dx, int dy) const noexcept {
    const CellIndex at = cell(from);
    const auto blocked = [&](int x, int y) {
      return map.obstacles.blocked({.x = at.x + x, .y = at.y + y});
    };
    if (blocked(dx, dy) || blocked(kStride * dx, kStride * dy)) return true;
    // Between two occupied cells that touch at a corner there is no gap.
    return dx != 0 && dy != 0 &&
           ((blocked(dx, 0) && blocked(0, dy)) ||
            (blocked(kStride * dx, dy) && blocked(dx, kStride * dy)));
  }
};

std::optional<Opening> OpeningSearch::find(const PreparedMap& map,
                                           const Vector2d& position,
                                           const Vector2d& goal,
                                           double radius,
                                           const TriedOpenings& tried) {
  constexpr double kBack = 1.0;  // [m] between the viewpoint and where the path is blocked
  const GridFrame& frame = map.obstacles.frame();
  if (!frame.contains(frame.cell_at(position)) || !(radius > 0.0)) return std::nullopt;
  Query query{.map = map,
              .tried = tried,
              .radius = radius,
              .goal = goal,
              .width = frame.width / kStride,
              .height = frame.height / kStride,
              .start = 0,
              .goal_inside = frame.contains(frame.cell_at(goal))};
  query.start = query.nearest(position);
  const int end = run(query);
  if (end < 0) return std::nullopt;
  std::vector<int> nodes;
  for (int node = end; node >= 0; node = before_[static_cast<std::size_t>(node)])
    nodes.push_back(node);
  std::reverse(nodes.begin(), nodes.end());
  // A robot that is in a narrow place itself can leave it.
  const double enough = std::min(radius, map.distances.at(query.cell(nodes.front())));
  const auto blocked = std::find_if(nodes.begin() + 1, nodes.end(), [&](int node) {
    return map.distances.at(query.cell(node)) < enough;
  });
  if (blocked == nodes.end()) return std::nullopt;
  Opening opening{.viewpoint = position, .blocked_at = query.point(*blocked)};
  for (auto node = blocked; node != nodes.begin();) {
    --node;
    if ((query.point(*node) - opening.blocked_at).norm() < kBack) continue;
    opening.viewpoint = query.point(*node);
    break;
  }
  return opening;
}

// Returns the node where the cheapest path ends; -1 if there is none.
int OpeningSearch::run(const Query& query) {
  const auto count = static_cast<std::size_t>(query.width) * static_cast<std::size_t>(query.height);
  cost_.assign(count, kNever);
  before_.assign(count, -1);
  queue_.clear();
  cost_[static_cast<std::size_t>(query.start)] = 0.0F;
  queue_.emplace_back(0.0F, query.start);
  int best = -1;
  float least = kNever;
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const auto [cost, node] = queue_.back();
    queue_.pop_back();
    if (cost > cost_[static_cast<std::size_t>(node)]) continue;
    if (cost >= least) break;
    if (query.is_end(node) && cost + query.rest(node) < least) {
      least = cost + query.rest(node);
      best = node;
    }
    expand(query, node);
  }
  return best;
}

void OpeningSearch::expand(const Query& query, int node) {
  const double resolution = query.map.obstacles.frame().resolution;
  const int x = node % query.width;
  const int y = node / query.width;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if ((dx == 0 && dy == 0) || x + dx < 0 || x + dx >= query.width || y + dy < 0 ||
          y + dy >= query.height) {
        continue;
      }
      const int next = node + dy * query.width + dx;
      const double length = kStride * resolution * std::hypot(dx, dy);
      const double step = length * query.weight(next) + (query.crosses(node, dx, dy) ? kWall : 0.0);
      const float cost = cost_[static_cast<std::size_t>(node)] + static_cast<float>(step);
      if (cost >= cost_[static_cast<std::size_t>(next)]) continue;
      cost_[static_cast<std::size_t>(next)] = cost;
      before_[static_cast<std::size_t>(next)] = node;
      queue_.emplace_back(cost, next);
      std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
    }
  }
}

}  // namespace fairway
