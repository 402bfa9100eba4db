// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/connections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fairway/geometry/angle.hpp"
#include "fairway/path/se2/reeds_shepp.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

void add_turn(std::vector<MotionPiece>& pieces, double angle) {
  if (std::abs(angle) < 1e-12) return;
  pieces.push_back({.twist = {.angular = angle > 0.0 ? 1.0 : -1.0}, .amount = std::abs(angle)});
}

void add(const MotionCost& cost, std::vector<MotionPiece> pieces, std::vector<Connection>& found) {
  const double time = cost.of(pieces);
  if (std::isfinite(time)) found.push_back({.pieces = std::move(pieces), .cost = time});
}

void connect_steered(const MotionCost& cost,
                     const Pose2& from,
                     const Pose2& to,
                     std::vector<Connection>& found) {
  std::vector<ReedsSheppWord> words;
  const double tightest = 1.0 / search_curvature(cost.base());
  for (const double wider : {1.0, 1.5}) {
    const double radius = wider * tightest;
    reeds_shepp_words(from, to, radius, words);
    for (const ReedsSheppWord& word : words) {
      std::vector<MotionPiece> pieces;
      for (std::size_t i = 0; i < static_cast<std::size_t>(word.count); ++i) {
        const double sign = word.lengths[i] < 0.0 ? -1.0 : 1.0;
        const double amount = radius * std::abs(word.lengths[i]);
        if (amount < 1e-9) continue;
        pieces.push_back({.twist = {.linear = sign, .angular = sign * word.turns[i] / radius},
                          .amount = amount});
      }
      add(cost, std::move(pieces), found);
    }
  }
}

void connect_unicycle(const MotionCost& cost,
                      const Pose2& from,
                      const Pose2& to,
                      std::vector<Connection>& found) {
  const Vector2d way = to.position - from.position;
  const double distance = way.norm();
  if (distance < 1e-9) {
    std::vector<MotionPiece> pieces;
    add_turn(pieces, shortest_turn(from.heading, to.heading));
    add(cost, std::move(pieces), found);
    return;
  }
  for (const double sign : {1.0, -1.0}) {
    const double heading = std::atan2(sign * way.y(), sign * way.x());
    std::vector<MotionPiece> pieces;
    add_turn(pieces, shortest_turn(from.heading, heading));
    pieces.push_back({.twist = {.linear = sign}, .amount = distance});
    add_turn(pieces, shortest_turn(heading, to.heading));
    add(cost, std::move(pieces), found);
  }
}

// A piece of the constant twist that takes one second, per metre, or per radian without travel.
MotionPiece piece_of(const PlanarTwist& twist) noexcept {
  const double pace = std::hypot(twist.linear, twist.lateral);
  const double amount = pace > 1e-9 ? pace : std::abs(twist.angular);
  if (amount < 1e-12) return {};
  return {.twist = (1.0 / amount) * twist, .amount = amount};
}

void connect_omni(const MotionCost& cost,
                  const Pose2& from,
                  const Pose2& to,
                  std::vector<Connection>& found) {
  add(cost, {piece_of(twist_between(from, to))}, found);
  const double turn = shortest_turn(from.heading, to.heading);
  if (std::abs(turn) < 1e-9) return;
  for (const bool turn_first : {false, true}) {
    Pose2 pose = from;
    if (turn_first) pose.heading = to.heading;
    const Vector2d way = inverse_transform(pose, to.position);
    std::vector<MotionPiece> pieces;
    if (turn_first) add_turn(pieces, turn);
    if (way.norm() > 1e-9) pieces.push_back(piece_of({.linear = way.x(), .lateral = way.y()}));
    if (!turn_first) add_turn(pieces, turn);
    add(cost, std::move(pieces), found);
  }
}

}  // namespace

double search_curvature(const BaseModel& base) noexcept { return 0.97 * greatest_curvature(base); }

void find_connections(const MotionCost& cost,
                      const Pose2& from,
                      const Pose2& to,
                      std::vector<Connection>& found) {
  found.clear();
  switch (cost.base().kind) {
    case BaseKind::Car:
    case BaseKind::Tricycle:
      connect_steered(cost, from, to, found);
      break;
    case BaseKind::Unicycle:
      connect_unicycle(cost, from, to, found);
      break;
    case BaseKind::Omni:
      connect_omni(cost, from, to, found);
      break;
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Connection& a, const Connection& b) { return a.cost < b.cost; });
}

double least_cost(const MotionCost& cost, const Pose2& from, const Pose2& to) noexcept {
  const double distance = (to.position - from.position).norm();
  const double turn = std::abs(shortest_turn(from.heading, to.heading));
  const double apart = std::max(cost.per_metre() * distance, cost.per_radian() * turn);
  if (!is_steered(cost.base())) return apart;
  const double radius = 1.0 / greatest_curvature(cost.base());
  // Far away the words differ little from the straight line, and are not worth their time.
  constexpr double kFar = 20.0;
  if (distance > kFar * radius) return apart;
  return std::max(apart, cost.per_metre() * reeds_shepp_length(from, to, radius));
}

}  // namespace fairway
