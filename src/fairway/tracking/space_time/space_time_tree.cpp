// SPDX-License-Identifier: Apache-2.0
// How the tree of motions grows, stage by stage.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/geometry/angle.hpp"
#include "fairway/tracking/space_time/space_time_planner.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kTableSize = SpaceTimeWorkspace::kTable;
constexpr double kCell = 0.25;                  // [m]
constexpr std::size_t kWithoutSlightTurns = 8;  // stage
constexpr double kAtGoal = 0.15;                // [m]
constexpr double kReverse = 0.4;                // of driving backwards [s/s]
constexpr double kTurnEffort = 0.03;            // [s per rad^2/s^2, and second]
constexpr double kHopeless = 3.0;      // cost beyond the best at which a motion is dropped [s]
constexpr double kSpeedChange = 0.05;  // of a change of speed [s per m/s]

}  // namespace

SpaceTimePlanner::Node SpaceTimePlanner::start_node() const noexcept {
  const Pose2& pose = input_->pose;
  return {.x = pose.position.x(),
          .y = pose.position.y(),
          .cosine = std::cos(pose.heading),
          .sine = std::sin(pose.heading),
          .heading = pose.heading,
          .speed = input_->speed};
}

bool SpaceTimePlanner::is_goal(const Node& node) const noexcept {
  const ReferencePath& path = input_->path;
  const Vector2d& end = path.points[static_cast<std::size_t>(path.count - 1)];
  return path.ends_at_goal && (end - Vector2d(node.x, node.y)).squaredNorm() < kAtGoal * kAtGoal;
}

// Changes of speed and turning cost more than their time, so that motions are smooth.
double SpaceTimePlanner::effort(const SpaceTimePlan::State& from,
                                const SpaceTimePlan::State& to,
                                double time) noexcept {
  const double rate = (to.pose.heading - from.pose.heading) / time;
  return time * kTurnEffort * rate * rate + kSpeedChange * std::abs(to.speed - from.speed) +
         (to.speed + from.speed < 0.0 ? kReverse * time : 0.0);
}

// Where a motion of one stage ends, and what it costs without encounters.
bool SpaceTimePlanner::move(
    const Node& from, std::size_t stage, double speed, const Turn& turn, Node& to) const noexcept {
  const double whole = driven_in(kStage, from.speed, speed, acceleration_);
  const double end_cosine = from.cosine * turn.half_cosine - from.sine * turn.half_sine;
  const double end_sine = from.sine * turn.half_cosine + from.cosine * turn.half_sine;
  to = from;
  to.x = from.x + whole * end_cosine;
  to.y = from.y + whole * end_sine;
  if (!locate(to.x, to.y, to.rectangle)) return false;
  to.cosine = from.cosine * turn.cosine - from.sine * turn.sine;
  to.sine = from.sine * turn.cosine + from.cosine * turn.sine;
  to.heading = from.heading + turn.angle;
  to.speed = speed;
  to.time = from.time + kStage;
  const double rate = turn.angle / kStage;
  to.risk += kStage * kTurnEffort * rate * rate + kSpeedChange * std::abs(speed - from.speed) +
             (speed + from.speed < 0.0 ? kReverse * kStage : 0.0);
  to.arrived = is_goal(to);
  const double left = to.arrived ? 0.0 : time_left(to, to_go_.at(to.x, to.y, stage + 1));
  to.total = to.time + left + to.risk;
  return true;
}

// Adds what the encounters in a stage cost, in its middle and at its end.
void SpaceTimePlanner::add_encounters(const NearObstacles& near,
                                      const Node& from,
                                      std::size_t stage,
                                      const Turn& turn,
                                      Node& to) const noexcept {
  if (near.count == 0 && input_->entrances == nullptr) return;
  const double half = driven_in(0.5 * kStage, from.speed, to.speed, acceleration_);
  const double mid_cosine = from.cosine * turn.quarter_cosine - from.sine * turn.quarter_sine;
  const double mid_sine = from.sine * turn.quarter_cosine + from.cosine * turn.quarter_sine;
  const double cost = 0.5 * kStage *
                      (cost_at(near, from.x + half * mid_cosine, from.y + half * mid_sine, to.speed,
                               2 * stage + 1) +
                       cost_at(near, to.x, to.y, to.speed, 2 * stage + 2));
  to.risk += cost;
  to.total += cost;
}

// Finds the entry of the table for the cell in which a motion ends; 0 in it: there is no motion.
std::uint32_t& SpaceTimePlanner::find(const Node& node, std::uint64_t& key) noexcept {
  const auto cell = [](double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value + 32768.0)) & 0xffffU;
  };
  constexpr double kPerTurn = 8.0 / std::numbers::pi;
  key = cell((node.x - input_->pose.position.x()) * (1.0 / kCell)) |
        cell((node.y - input_->pose.position.y()) * (1.0 / kCell)) << 16U |
        cell(node.heading * kPerTurn) << 32U | cell(node.speed * 4.0 * per_top_) << 48U;
  std::uint64_t hash = key * 0x9e3779b97f4a7c15ULL;
  hash >>= 52U;  // 12 bits: the size of the table
  for (;; hash = (hash + 1) % kTableSize) {
    std::uint32_t& entry = table_[hash];
    if (entry == 0 || keys_[entry - 1] == key) return entry;
  }
}

// Adds a child, or replaces the one in the same cell that costs more.
void SpaceTimePlanner::keep(std::uint32_t& entry, std::uint64_t key, const Node& node) noexcept {
  if (entry == 0) {
    entry = static_cast<std::uint32_t>(child_count_ + 1);
    keys_[child_count_] = key;
    children_[child_count_++] = node;
  } else if (node.total < children_[entry - 1].total) {
    children_[entry - 1] = node;
  }
}

void SpaceTimePlanner::grow(std::size_t stage) noexcept {
  std::fill(table_.begin(), table_.end(), 0U);
  child_count_ = 0;
  bound_ = 1e9;
  const double change = acceleration_ * kStage;
  const double top = robot_.linear_max;
  const std::vector<Node>& layer = layers_[stage];
  std::uint64_t key = 0;
  for (std::size_t n = 0; n < layer.size(); ++n) {
    const Node& from = layer[n];
    if (from.arrived) {
      Node same = from;
      same.parent = static_cast<std::uint32_t>(n);
      keep(find(same, key), key, same);
      continue;
    }
    const NearObstacles near = near_stage(from, stage);
    const double wanted = shortest_turn(from.heading, bearing_of_path(from));
    const Turn towards = turn_by(std::clamp(wanted, -turn_max_ * kStage, turn_max_ * kStage));
    double before = 1e9;
    for (const double share : {1.0, 0.66, 0.33, 0.0, -1.0}) {
      const double aim = share < 0.0 ? robot_.linear_min : share * top;
      if (share < 0.0 && (stage > 2 || robot_.linear_min >= 0.0)) break;
      const double speed = std::clamp(aim, from.speed - change, from.speed + change);
      if (std::abs(speed - before) < 1e-9) continue;
      before = speed;
      for (std::size_t t = 0; t <= turns_.size(); ++t) {
        if (stage >= kWithoutSlightTurns && (t == 2 || t == 3)) continue;
        const Turn& turn = t == 0 ? towards : turns_[t - 1];
        Node to;
        // Encounters only add to the cost: what costs too much without them is left out.
        if (!move(from, stage, speed, turn, to) || to.total > bound_) continue;
        std::uint32_t& entry = find(to, key);
        if (entry != 0 && to.total >= children_[entry - 1].total) continue;
        add_encounters(near, from, stage, turn, to);
        if (to.total > bound_) continue;
        to.parent = static_cast<std::uint32_t>(n);
        bound_ = std::min(bound_, to.total + kHopeless);
        keep(entry, key, to);
      }
    }
  }
}

void SpaceTimePlanner::select(std::size_t stage) noexcept {
  order_.clear();
  for (std::size_t i = 0; i < child_count_; ++i)
    order_.push_back(static_cast<std::uint32_t>(i));
  const auto cheaper = [this](std::uint32_t a, std::uint32_t b) {
    return children_[a].total < children_[b].total ||
           (children_[a].total == children_[b].total && a < b);
  };
  const std::size_t kept = std::min(stage < kLate ? kWidth : kLateWidth, order_.size());
  std::partial_sort(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(kept),
                    order_.end(), cheaper);
  std::vector<Node>& layer = layers_[stage + 1];
  layer.clear();
  for (std::size_t i = 0; i < kept; ++i)
    layer.push_back(children_[order_[i]]);
}

void SpaceTimePlanner::store(std::size_t leaf, SpaceTimePlan& plan) const noexcept {
  plan.start = input_->time;
  plan.stage = kStage;
  plan.stages = stages_;
  plan.acceleration = acceleration_;
  plan.cost = layers_[stages_][leaf].total;
  std::size_t at = leaf;
  for (std::size_t k = stages_ + 1; k-- > 0;) {
    const Node& node = layers_[k][at];
    plan.states[k] = {.pose = {.position = {node.x, node.y}, .heading = node.heading},
                      .speed = node.arrived ? 0.0 : node.speed};
    at = node.parent;
  }
}

}  // namespace fairway
