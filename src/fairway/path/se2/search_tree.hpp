// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <queue>
#include <vector>

#include "fairway/map/body_clearance.hpp"
#include "fairway/path/se2/connections.hpp"
#include "fairway/path/se2/goal_distance.hpp"
#include "fairway/path/se2/move_set.hpp"
#include "fairway/path/se2/state_table.hpp"

namespace fairway::internal {

/// What both trees of a search share.
struct SearchTask {
  const BodyClearance* clearance = nullptr;
  const MotionCost* cost = nullptr;
  MoveSet moves;
  double margin = 0.02;     ///< clearance that the whole path keeps [m]
  double greediness = 1.5;  ///< weight of the estimate of what is left; 1: the cheapest path
};

/// A hybrid A* search from one end of a path towards the other. It works in steps, so that two
/// searches can take turns. States are poses; of those that share a cell the one of least cost is
/// kept. At intervals the analytic connections to the other end are tried. Deterministic.
class SearchTree {
 public:
  /// @param backwards  The tree grows from the goal to the start, against the direction of driving.
  /// @param remaining  Lower bounds of the distance to `target`.
  SearchTree(const SearchTask& task,
             const Pose2& root,
             const Pose2& target,
             bool backwards,
             const GoalDistance& remaining);

  /// Expands up to `count` states. @return whether it goes on: false when done or exhausted.
  bool expand(int count);

  [[nodiscard]] int expanded() const noexcept { return expanded_; }

  /// Returns the best path so far, in the direction of driving.
  [[nodiscard]] const std::optional<MotionPath>& path() const noexcept { return path_; }
  [[nodiscard]] double path_cost() const noexcept { return path_cost_; }

 private:
  struct Node {
    Pose2 pose;
    double cost = 0.0;
    std::uint32_t parent = StateTable::kNone;
    MotionPiece piece;  // from the parent, in the direction of the tree
    std::uint64_t key = 0;
  };
  struct Entry {
    double estimate;
    std::uint32_t node;
    bool operator<(const Entry& other) const noexcept {
      return estimate != other.estimate ? estimate > other.estimate : node < other.node;
    }
  };

  [[nodiscard]] MotionPiece driven(const MotionPiece& piece) const noexcept;
  [[nodiscard]] double step_cost(const Node& from, const MotionPiece& piece) const noexcept;
  [[nodiscard]] double zone_cost(const Pose2& start, const MotionPiece& piece) const noexcept;
  [[nodiscard]] double estimate(const Pose2& pose) const noexcept;
  [[nodiscard]] int scale_at(const Pose2& pose) const noexcept;
  [[nodiscard]] std::uint64_t key_of(const Pose2& pose, int scale) const noexcept;
  void expand_node(std::uint32_t index);
  void try_to_connect(std::uint32_t index);
  void keep_path(std::uint32_t index, const Connection& connection, double cost);

  SearchTask task_;
  Pose2 root_;
  Pose2 target_;
  bool backwards_;
  const GoalDistance* remaining_;
  std::vector<Node> nodes_;
  StateTable table_;
  std::priority_queue<Entry> queue_;
  std::vector<Connection> connections_;
  std::optional<MotionPath> path_;
  double path_cost_ = 0.0;
  int expanded_ = 0;
  int expanded_at_path_ = 0;
  int next_try_ = 0;
};

}  // namespace fairway::internal
