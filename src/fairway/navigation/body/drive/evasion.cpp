// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/drive/evasion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "fairway/path/se2/motion_path.hpp"
#include "fairway/trajectory/drive_planner.hpp"
#include "fairway/trajectory/stopping_trajectory.hpp"

namespace fairway {

namespace {

constexpr double kEvasionHorizon = 11.0;  // [s]
constexpr double kEvasionMargin = 0.03;   // kept from static obstacles [m]
constexpr std::array<double, 8> kLengths{0.3, 0.6, 1.0, 1.5, 2.1, 2.8, 3.6, 4.5};  // [m]

// The least separation along a drive at its own pace, and at its end until the horizon.
double outlook(const BodyShape& body,
               const std::vector<TrajectoryRow>& rows,
               double period,
               const EvasionTask& task,
               double enough) {
  constexpr double kStep = 0.06;  // [s]
  double least = std::numeric_limits<double>::infinity();
  const auto last = rows.size() - 1;
  for (double time = 0.0; time <= kEvasionHorizon && least >= enough; time += kStep) {
    const double driven = std::max(0.0, time - task.delay) / period;
    const auto k = std::min(last, static_cast<std::size_t>(driven));
    least = std::min(least, body_separation(body, rows[k].pose, task.moving, time));
  }
  return least;
}

bool is_free(const BodyClearance& clearance, const MotionPath& path) {
  Pose2 pose = path.start;
  for (const MotionPiece& piece : path.pieces) {
    if (!clearance.is_free(pose, piece.twist, piece.amount, kEvasionMargin)) return false;
    pose = piece.from(pose);
  }
  return true;
}

// Beginnings of drives: a piece that may come first, and the direction in which the robot goes on.
struct Beginning {
  std::optional<MotionPiece> first;
  PlanarTwist twist;  // per metre
  bool s_curve = false;
};

std::vector<Beginning> beginnings(const BaseModel& base, const BodyShape& body) {
  std::vector<Beginning> all;
  if (base.kind == BaseKind::Omni) {
    constexpr int kDirections = 16;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      all.push_back(
          {.first = {}, .twist = {.linear = std::cos(angle), .lateral = std::sin(angle)}});
    }
    return all;
  }
  const bool steered = is_steered(base);
  const double most = steered ? 0.98 * greatest_curvature(base) : 1.0 / body.circumscribed_radius();
  for (const double gear : {1.0, -1.0}) {
    if (gear < 0.0 && base.linear_min >= 0.0) continue;
    for (const double share : {0.0, 0.5, -0.5, 1.0, -1.0}) {
      const PlanarTwist arc{.linear = gear, .angular = gear * share * most};
      all.push_back({.first = {}, .twist = arc});
      if (share != 0.0) all.push_back({.first = {}, .twist = arc, .s_curve = true});
    }
    if (steered) continue;
    constexpr double kTurn = std::numbers::pi / 8.0;
    for (int i = 1; i <= 4; ++i) {
      for (const double side : {1.0, -1.0}) {
        all.push_back({.first = MotionPiece{.twist = {.angular = side}, .amount = i * kTurn},
                       .twist = {.linear = gear}});
      }
    }
  }
  return all;
}

MotionPath path_of(const Pose2& start, const Beginning& begin, double length) {
  MotionPath path{.start = start, .pieces = {}};
  if (begin.first) path.pieces.push_back(*begin.first);
  if (!begin.s_curve) {
    path.pieces.push_back({.twist = begin.twist, .amount = length});
    return path;
  }
  PlanarTwist back = begin.twist;
  back.angular = -back.angular;
  path.pieces.push_back({.twist = begin.twist, .amount = 0.5 * length});
  path.pieces.push_back({.twist = back, .amount = 0.5 * length});
  return path;
}

}  // namespace

bool is_run_into(const BodyShape& body,
                 const Pose2& pose,
                 const MovingSurroundings& surroundings,
                 double horizon) noexcept {
  MovingSurroundings near = surroundings;
  near.prediction = near_prediction(near.prediction);
  if (is_apart(body, pose, near, 0.0, horizon)) return false;
  if (is_on_plan_of_fleet(body, pose, near)) return true;
  near.fleet = {};               // other robots stop
  constexpr double kStep = 0.1;  // [s]
  for (double time = 0.0; time <= horizon; time += kStep) {
    if (body_separation(body, pose, near, time) < 0.0) return true;
  }
  return false;
}

std::optional<std::vector<TrajectoryRow>> plan_evasion(const BodyClearance& clearance,
                                                       const BaseModel& base,
                                                       const EvasionTask& task,
                                                       double period) {
  constexpr double kShare = 0.9;  // of the limits; the rest is for control
  constexpr double kKnotStep = 0.25;
  constexpr double kPerMetre = 0.3;          // a long detour costs besides its time [s]
  constexpr double kSpace = 0.5;             // around the place [m]
  constexpr double kPerMetreOfSpace = 10.0;  // of it that is missing [s/m]
  const BaseModel planned = with_reserve(base, kShare, kShare);
  const BodyShape& body = clearance.body();
  EvasionTask near = task;
  near.moving.prediction = near_prediction(near.moving.prediction);
  near.moving.commits = true;
  std::optional<std::vector<TrajectoryRow>> best;
  double least = std::numeric_limits<double>::infinity();
  bool best_is_wide = false;
  for (const Beginning& begin : beginnings(planned, body)) {
    for (const double length : kLengths) {
      const MotionPath path = path_of(task.start, begin, length);
      if (!is_free(clearance, path)) break;
      std::vector<TrajectoryRow> rows =
          sampled(base, stopping_trajectory(planned, path, kKnotStep), period);
      // A robot also has to leave the place again.
      const double space = clearance.distance_bound(rows.back().pose);
      const double cost = period * static_cast<double>(rows.size()) + kPerMetre * length +
                          kPerMetreOfSpace * std::max(0.0, kSpace - space);
      if (best_is_wide && cost >= least) break;
      if (!(outlook(body, rows, period, near, 0.0) >= 0.0)) continue;
      if (is_on_plan_of_fleet(body, rows.back().pose, near.moving)) continue;
      const bool wide = outlook(body, rows, period, task, 0.0) >= 0.0;
      if (best && (best_is_wide ? !wide || cost >= least : !wide && cost >= least)) continue;
      if (!fairway::is_free(clearance, rows, period, 0.5 * kEvasionMargin)) continue;
      least = cost;
      best_is_wide = wide;
      best = std::move(rows);
    }
  }
  return best;
}

}  // namespace fairway
