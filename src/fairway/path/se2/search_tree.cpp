// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/search_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/body_zones.hpp"

namespace fairway::internal {

SearchTree::SearchTree(const SearchTask& task,
                       const Pose2& root,
                       const Pose2& target,
                       bool backwards,
                       const GoalDistance& remaining)
    : task_(task),
      root_(root),
      target_(target),
      backwards_(backwards),
      remaining_(&remaining) {
  nodes_.push_back({.pose = root, .piece = {}, .key = key_of(root, scale_at(root))});
  table_[nodes_[0].key] = 0;
  queue_.push({.estimate = task_.greediness * estimate(root), .node = 0});
}

bool SearchTree::expand(int count) {
  for (int i = 0; i < count; ++i) {
    if (queue_.empty()) return false;
    // A first path is often not the best of its kind: as long again, and a little.
    constexpr int kALittle = 800;
    if (path_ && expanded_ > 2 * expanded_at_path_ + kALittle) return false;
    const Entry now = queue_.top();
    queue_.pop();
    const Node& node = nodes_[now.node];
    if (table_[node.key] != now.node) continue;  // one of less cost took its cell
    const double left = (now.estimate - node.cost) / task_.greediness;
    if (path_ && node.cost + left >= path_cost_) continue;
    ++expanded_;
    try_to_connect(now.node);
    expand_node(now.node);
  }
  return true;
}

MotionPiece SearchTree::driven(const MotionPiece& piece) const noexcept {
  return backwards_ ? MotionPiece{.twist = -1.0 * piece.twist, .amount = piece.amount} : piece;
}

double SearchTree::step_cost(const Node& from, const MotionPiece& piece) const noexcept {
  const MotionPiece now = driven(piece);
  double cost = task_.cost->of(now);
  if (from.parent == StateTable::kNone) return cost;
  const MotionPiece before = driven(from.piece);
  cost += backwards_ ? task_.cost->between(now, before) : task_.cost->between(before, now);
  return cost;
}

// What zones add to the cost of a piece; infinite for one that they forbid. The piece is given in
// the direction of driving.
double SearchTree::zone_cost(const Pose2& start, const MotionPiece& piece) const noexcept {
  const ZoneMap* const zones = task_.clearance->obstacles().zones();
  if (zones == nullptr || !zones->has_costs()) return 0.0;
  if (goes_against_lane(*zones, start, piece.twist, piece.amount, kPlannedLanes))
    return std::numeric_limits<double>::infinity();
  constexpr double kApart = 0.25;  // [m]
  const double length = piece.amount * std::hypot(piece.twist.linear, piece.twist.lateral);
  const int parts = std::max(1, static_cast<int>(std::ceil(length / kApart)));
  double metres = 0.0;
  Eigen::Vector2d before = start.position;
  for (int i = 1; i <= parts; ++i) {
    const Eigen::Vector2d now = moved(start, piece.twist, i * piece.amount / parts).position;
    metres += zones->cost_along({.a = before, .b = now});
    before = now;
  }
  return metres * task_.cost->per_metre();
}

double SearchTree::estimate(const Pose2& pose) const noexcept {
  const double way = remaining_->at(pose.position) * task_.cost->per_metre();
  const double alone =
      backwards_ ? least_cost(*task_.cost, target_, pose) : least_cost(*task_.cost, pose, target_);
  return std::max(way, alone);
}

int SearchTree::scale_at(const Pose2& pose) const noexcept {
  const double space = task_.clearance->distance_bound(pose) / task_.moves.cell;
  if (space > 8.0) return 4;
  return space > 3.0 ? 2 : 1;
}

std::uint64_t SearchTree::key_of(const Pose2& pose, int scale) const noexcept {
  const double side = task_.moves.cell * scale;
  const Eigen::Vector2d way = pose.position - root_.position;
  const int bins = task_.moves.headings / (scale > 1 ? 2 : 1);
  const double turn = wrap_to_pi(pose.heading - root_.heading) / (2.0 * std::numbers::pi);
  const auto index = [](double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value + 0.5)) +
                                      (1 << 20));
  };
  const auto heading = static_cast<std::uint64_t>(
      (static_cast<int>(std::floor(turn * bins + 0.5)) % bins + bins) % bins);
  return (index(way.x() / side) << 36U) | (index(way.y() / side) << 12U) | (heading << 3U) |
         static_cast<std::uint64_t>(scale);
}

void SearchTree::expand_node(std::uint32_t index) {
  const int scale = scale_at(nodes_[index].pose);
  for (const MotionPiece& move : task_.moves.moves) {
    MotionPiece piece = move;
    piece.amount *= scale;
    const Node from = nodes_[index];
    Node next;
    next.pose = piece.from(from.pose);
    next.pose.heading = wrap_to_pi(next.pose.heading);
    next.cost = from.cost + step_cost(from, piece);
    next.parent = index;
    next.piece = piece;
    if (!std::isfinite(remaining_->at(next.pose.position))) continue;
    next.key = key_of(next.pose, scale_at(next.pose));
    std::uint32_t& place = table_[next.key];
    if (place != StateTable::kNone && nodes_[place].cost <= next.cost) continue;
    next.cost += zone_cost(backwards_ ? next.pose : from.pose, driven(piece));
    if (!std::isfinite(next.cost)) continue;
    if (place != StateTable::kNone && nodes_[place].cost <= next.cost) continue;
    if (!task_.clearance->is_free(from.pose, piece.twist, piece.amount, task_.margin)) continue;
    place = static_cast<std::uint32_t>(nodes_.size());
    queue_.push({.estimate = next.cost + task_.greediness * estimate(next.pose), .node = place});
    nodes_.push_back(next);
  }
}

// The further the target, the more seldom.
void SearchTree::try_to_connect(std::uint32_t index) {
  if (expanded_ < next_try_) return;
  const Node& node = nodes_[index];
  const double left = remaining_->at(node.pose.position);
  constexpr double kPerMetre = 3.0;  // states to expand before the next try
  next_try_ = expanded_ + 1 + static_cast<int>(std::min(100.0, kPerMetre * left));
  if (backwards_) {
    find_connections(*task_.cost, target_, node.pose, connections_);
  } else {
    find_connections(*task_.cost, node.pose, target_, connections_);
  }
  constexpr std::size_t kMostTried = 8;
  const std::size_t count = std::min(kMostTried, connections_.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Connection& connection = connections_[i];
    double cost = node.cost + connection.cost;
    if (node.parent != StateTable::kNone) {
      const MotionPiece piece = driven(node.piece);
      if (!connection.pieces.empty()) {
        cost += backwards_ ? task_.cost->between(connection.pieces.back(), piece)
                           : task_.cost->between(piece, connection.pieces.front());
      }
    }
    if (path_ && cost >= path_cost_) continue;
    Pose2 pose = backwards_ ? target_ : node.pose;
    bool free = true;
    for (const MotionPiece& piece : connection.pieces) {
      cost += zone_cost(pose, piece);
      free = std::isfinite(cost) &&
             task_.clearance->is_free(pose, piece.twist, piece.amount, task_.margin);
      if (!free) break;
      pose = piece.from(pose);
    }
    if (!free || (path_ && cost >= path_cost_)) continue;
    keep_path(index, connection, cost);
    return;
  }
}

void SearchTree::keep_path(std::uint32_t index, const Connection& connection, double cost) {
  std::vector<MotionPiece> pieces;  // from the node to the root
  for (std::uint32_t i = index; nodes_[i].parent != StateTable::kNone; i = nodes_[i].parent)
    pieces.push_back(driven(nodes_[i].piece));
  MotionPath path;
  if (backwards_) {
    path.start = target_;
    path.pieces = connection.pieces;
    path.pieces.insert(path.pieces.end(), pieces.begin(), pieces.end());
  } else {
    path.start = root_;
    path.pieces.assign(pieces.rbegin(), pieces.rend());
    path.pieces.insert(path.pieces.end(), connection.pieces.begin(), connection.pieces.end());
  }
  merge_pieces(path);
  if (!path_) expanded_at_path_ = expanded_;
  path_ = std::move(path);
  path_cost_ = cost;
}

}  // namespace fairway::internal
