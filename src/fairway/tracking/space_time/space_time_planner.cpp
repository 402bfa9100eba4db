// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/space_time_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kMostSpeeds = 5;
constexpr std::size_t kMostTurns = 6;
constexpr double kTurnTime = 0.4;     // of turning back to the path [s]
constexpr double kNegligible = 0.02;  // cost of encounters on the reference path [s]
constexpr double kSlack = 0.02;       // beyond a rectangle [m]

}  // namespace

SpaceTimePlanner::Turn SpaceTimePlanner::turn_by(double angle) noexcept {
  return {.angle = angle,
          .cosine = std::cos(angle),
          .sine = std::sin(angle),
          .quarter_cosine = std::cos(0.25 * angle),
          .quarter_sine = std::sin(0.25 * angle),
          .half_cosine = std::cos(0.5 * angle),
          .half_sine = std::sin(0.5 * angle)};
}

SpaceTimePlanner::SpaceTimePlanner(const RobotSettings& robot,
                                   const PredictionSettings& prediction,
                                   double horizon)
    : robot_(robot),
      stages_(std::min(SpaceTimePlan::kMaxStages, static_cast<std::size_t>(horizon / kStage))),
      acceleration_(change_max(linear_actuation(robot))),
      turn_max_(std::min(robot.angular_max, 2.0)),
      prediction_(prediction),
      cost_{.radius = robot.radius,
            .margin = prediction.obstacle_margin,
            .comfort = prediction.comfort_distance,
            .headway = prediction.time_headway,
            .braking = change_max(linear_actuation(robot)),
            .speed_max = robot.linear_max} {
  for (const double share : {0.0, 0.35, -0.35, 1.0, -1.0})
    turns_.push_back(turn_by(share * turn_max_ * kStage));
  const std::size_t most = kWidth * kMostSpeeds * kMostTurns;
  layers_.resize(stages_ + 1);
  for (std::vector<Node>& layer : layers_)
    layer.reserve(kWidth);
  children_.resize(most);
  order_.reserve(most);
  table_.resize(kTable);
  keys_.resize(most);
}

void SpaceTimePlanner::prepare(const SpaceTimeInput& input) noexcept {
  input_ = &input;
  predict(input.obstacles, input.age, input.pose.position, prediction_, 0.5 * kStage,
          2 * stages_ + 1, forecast_);
  cost_.prepare(forecast_);
  rectangle_count_ = 0;
  for (std::size_t i = input.corridor.current();
       i < input.corridor.size() && rectangle_count_ < kRectangles; ++i) {
    const OrientedRectangle& given = input.corridor.admissible(i);
    rectangles_[rectangle_count_++] = {.cosine = std::cos(given.orientation),
                                       .sine = std::sin(given.orientation),
                                       .seed = given.seed,
                                       .min = given.min,
                                       .max = given.max};
  }
}

// Of encounters with people who are there, and with those who may appear.
double SpaceTimePlanner::cost_at(double x,
                                 double y,
                                 double speed,
                                 std::size_t sample) const noexcept {
  // A goal at an entrance must be entered.
  constexpr double kNearGoal = 3.0;     // [m]
  constexpr double kAppearance = 60.0;  // per expected appearance [s]
  constexpr double kMost = 3.0;         // [s/s]
  const double known = cost_.at(forecast_, x, y, speed, sample);
  if (input_->entrances == nullptr) return known;
  const ReferencePath& path = input_->path;
  const Vector2d end = path.points[static_cast<std::size_t>(path.count - 1)];
  const double away = path.ends_at_goal ? (end - Vector2d(x, y)).norm() / kNearGoal : 1.0;
  return known +
         std::min(kMost, kAppearance * input_->entrances->rate(x, y)) * std::min(1.0, away * away);
}

bool SpaceTimePlanner::locate(double x, double y, std::uint8_t& rectangle) const noexcept {
  const std::size_t last = std::min<std::size_t>(rectangle_count_, rectangle + 3U);
  for (std::size_t i = last; i-- > (rectangle > 0 ? rectangle - 1U : 0U);) {
    const Rectangle& r = rectangles_[i];
    const double dx = x - r.seed.x();
    const double dy = y - r.seed.y();
    const double u = r.cosine * dx + r.sine * dy;
    const double v = r.cosine * dy - r.sine * dx;
    if (u >= r.min.x() - kSlack && u <= r.max.x() + kSlack && v >= r.min.y() - kSlack &&
        v <= r.max.y() + kSlack) {
      rectangle = static_cast<std::uint8_t>(i);
      return true;
    }
  }
  return false;
}

namespace {

// The piece of the path that is nearest to a place.
std::size_t nearest_piece(const ReferencePath& path, const Vector2d& place) noexcept {
  std::size_t best = 1;
  double least = 1e18;
  for (std::size_t i = 1; i < static_cast<std::size_t>(path.count); ++i) {
    const Vector2d along = path.points[i] - path.points[i - 1];
    const double squared = along.squaredNorm();
    const double share =
        squared > 0.0 ? std::clamp((place - path.points[i - 1]).dot(along) / squared, 0.0, 1.0)
                      : 1.0;
    const double distance = (path.points[i - 1] + share * along - place).squaredNorm();
    if (distance <= least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

}  // namespace

double SpaceTimePlanner::bearing_of_path(const Node& node) const noexcept {
  const ReferencePath& path = input_->path;
  const Vector2d place(node.x, node.y);
  const Vector2d to = path.points[path.count > 2 ? nearest_piece(path, place) : 1] - place;
  return to.squaredNorm() > 1e-6 ? std::atan2(to.y(), to.x()) : node.heading;
}

double SpaceTimePlanner::time_left(const Node& node) const noexcept {
  const ReferencePath& path = input_->path;
  const Vector2d place(node.x, node.y);
  const std::size_t piece = path.count > 2 ? nearest_piece(path, place) : 1;
  const Vector2d to = path.points[piece] - place;
  const double distance = to.norm();
  const double rest = path.length() - path.arc[piece];
  const double ahead =
      distance > 1e-3 ? (node.cosine * to.x() + node.sine * to.y()) / distance : 1.0;
  const double top = robot_.linear_max;
  const double slow = std::max(0.0, top - node.speed);
  const double far = std::min(1.0, (distance + rest) / 0.5);
  return (distance + rest) / top +
         far * (slow * slow / (2.0 * acceleration_ * top) + kTurnTime * (1.0 - ahead));
}

// Time and encounters where the robot drives along the reference path at its greatest speed.
double SpaceTimePlanner::cost_of_reference() const noexcept {
  double along = 0.0;
  double speed = std::max(0.0, input_->speed);
  double risk = 0.0;
  const double length = input_->path.length();
  for (std::size_t k = 1; k < forecast_.samples; ++k) {
    const double next = std::min(robot_.linear_max, speed + acceleration_ * forecast_.interval);
    along += 0.5 * (speed + next) * forecast_.interval;
    speed = next;
    if (along > length) break;
    const Vector2d place = input_->path.at(along);
    risk += forecast_.interval * cost_at(place.x(), place.y(), speed, k);
  }
  return risk;
}

// The last plan from now on, at its cost under the new predictions.
bool SpaceTimePlanner::continue_last(SpaceTimePlan& continued) noexcept {
  const double since = input_->time - plan_.start;
  if (plan_.stages != stages_ || since < 0.0 || since > 2.0 * kStage) return false;
  bound_ = std::numeric_limits<double>::infinity();
  const double change = acceleration_ * kStage;
  Node node = start_node();
  if (!locate(node.x, node.y, node.rectangle)) return false;
  continued.start = input_->time;
  continued.stage = kStage;
  continued.stages = stages_;
  const auto note = [&](std::size_t k) {
    continued.states[k] = {.pose = {.position = {node.x, node.y}, .heading = node.heading},
                           .speed = node.arrived ? 0.0 : node.speed};
  };
  note(0);
  for (std::size_t k = 0; k < stages_; ++k) {
    if (!node.arrived) {
      const double end = since + static_cast<double>(k + 1) * kStage;
      const bool beyond = end > static_cast<double>(stages_) * kStage;
      const SpaceTimePlan::State aim =
          plan_.at(std::min(end, static_cast<double>(stages_) * kStage - 1e-6));
      const double wanted =
          shortest_turn(node.heading, beyond ? bearing_of_path(node) : aim.pose.heading);
      const double speed = std::clamp(beyond ? robot_.linear_max : aim.speed, node.speed - change,
                                      node.speed + change);
      Node next;
      if (!extend(node, k, speed,
                  turn_by(std::clamp(wanted, -turn_max_ * kStage, turn_max_ * kStage)), next))
        return false;
      node = next;
    }
    note(k + 1);
  }
  continued.cost = node.total;
  return true;
}

bool SpaceTimePlanner::update(const SpaceTimeInput& input) noexcept {
  constexpr double kBetter = 0.25;   // by which another motion must cost less [s]
  constexpr double kRenewal = 0.15;  // between two trees while the last plan keeps its cost [s]
  if (stages_ == 0 || input.path.count < 2) return false;
  prepare(input);
  if ((forecast_.count == 0 && input.entrances == nullptr) || cost_of_reference() < kNegligible) {
    plan_.stages = 0;
    return false;
  }
  Node first = start_node();
  if (!locate(first.x, first.y, first.rectangle)) {
    plan_.stages = 0;
    return false;
  }
  const bool has_last = continue_last(other_);
  if (has_last && input.time - tree_time_ < kRenewal - 1e-9 &&
      other_.cost < plan_.cost - (input.time - plan_.start) + kBetter) {
    plan_ = other_;
    return true;
  }
  tree_time_ = input.time;
  layers_[0].assign(1, first);
  for (std::size_t k = 0; k < stages_; ++k) {
    grow(k);
    if (child_count_ == 0) {
      plan_.stages = 0;
      return false;
    }
    select(k);
  }
  if (has_last && other_.cost < layers_[stages_].front().total + kBetter) {
    plan_ = other_;
  } else {
    store(0, plan_);
  }
  return true;
}

}  // namespace fairway
