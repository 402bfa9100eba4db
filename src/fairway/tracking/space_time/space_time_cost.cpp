// SPDX-License-Identifier: Apache-2.0
// What motions cost: encounters, the time that is left, and the last plan.
#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "fairway/tracking/space_time/space_time_planner.hpp"

namespace fairway {

// Cost of encounters with people who are there, and with those who may appear.
double SpaceTimePlanner::cost_at(const NearObstacles& near,
                                 double x,
                                 double y,
                                 double speed,
                                 std::size_t sample) const noexcept {
  const double known = cost_.at(forecast_, near, x, y, speed, sample);
  return input_->entrances == nullptr ? known : known + entrance_cost(x, y);
}

double SpaceTimePlanner::entrance_cost(double x, double y) const noexcept {
  // A goal at an entrance must be entered.
  constexpr double kNearGoal = 3.0;     // [m]
  constexpr double kAppearance = 60.0;  // per expected appearance [s]
  constexpr double kMost = 3.0;         // [s/s]
  const ReferencePath& path = input_->path;
  const Eigen::Vector2d end = path.points[static_cast<std::size_t>(path.count - 1)];
  const double away = path.ends_at_goal ? (end - Eigen::Vector2d(x, y)).norm() / kNearGoal : 1.0;
  return std::min(kMost, kAppearance * input_->entrances->rate(x, y)) * std::min(1.0, away * away);
}

// The obstacles that a motion of a stage can meet.
NearObstacles SpaceTimePlanner::near_stage(const Node& from, std::size_t stage) const noexcept {
  const double fastest = std::max(robot_.linear_max, -robot_.linear_min);
  return cost_.near(forecast_, from.x, from.y, fastest * kStage, 2 * stage + 1);
}

namespace {

using Eigen::Vector2d;

constexpr double kTurnTime = 0.4;  // of turning back to the path [s]

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

// The time along the reference path at the greatest speed [s].
double SpaceTimePlanner::straight_time(const Vector2d& place) const noexcept {
  const ReferencePath& path = input_->path;
  const std::size_t piece = path.count > 2 ? nearest_piece(path, place) : 1;
  return ((path.points[piece] - place).norm() + path.length() - path.arc[piece]) * per_top_;
}

// Adds what the robot needs to accelerate and turn to what a point needs.
double SpaceTimePlanner::time_left(const Node& node, double left) const noexcept {
  const ReferencePath& path = input_->path;
  const Vector2d place(node.x, node.y);
  const Vector2d to = path.points[path.count > 2 ? nearest_piece(path, place) : 1] - place;
  const double distance = to.norm();
  const double ahead =
      distance > 1e-3 ? (node.cosine * to.x() + node.sine * to.y()) / distance : 1.0;
  const double slow = std::max(0.0, robot_.linear_max - node.speed);
  const double far = std::min(1.0, left * robot_.linear_max / 0.5);
  return left + far * (slow * slow * slowness_ + kTurnTime * (1.0 - ahead));
}

void SpaceTimePlanner::find_costs_to_go() noexcept {
  const double beyond = 0.7 * to_go_.cell();
  to_go_.begin(input_->pose.position);
  to_go_.for_each_cell([&](const Vector2d& place, float& last, float& arrival) {
    constexpr float kClosed = 1000.0F;  // [s]
    last = static_cast<float>(straight_time(place));
    arrival = kClosed;
    for (std::size_t i = 0; i < rectangle_count_; ++i) {
      const Rectangle& r = rectangles_[i];
      const Vector2d from = place - r.seed;
      const double u = r.cosine * from.x() + r.sine * from.y();
      const double v = r.cosine * from.y() - r.sine * from.x();
      if (u < r.min.x() - beyond || u > r.max.x() + beyond || v < r.min.y() - beyond ||
          v > r.max.y() + beyond)
        continue;
      arrival = static_cast<float>(kStage);
      break;
    }
    if (input_->entrances != nullptr)
      arrival += static_cast<float>(kStage * entrance_cost(place.x(), place.y()));
  });
  to_go_.solve(forecast_, cost_, input_->path.ends_at_goal);
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
    const NearObstacles near = cost_.near(forecast_, place.x(), place.y(), 0.0, k);
    risk += forecast_.interval * cost_at(near, place.x(), place.y(), speed, k);
  }
  return risk;
}

// Finds what a plan costs from now on under the new predictions. After its end the robot drives
// towards the path. Returns false where the plan leaves the corridor.
bool SpaceTimePlanner::evaluate(const SpaceTimePlan& plan, double& cost) const noexcept {
  const double since = input_->time - plan.start;
  const double end = static_cast<double>(stages_) * kStage;
  Node node = start_node();
  if (!locate(node.x, node.y, node.rectangle)) return false;
  for (std::size_t k = 1; k < forecast_.samples && !node.arrived; ++k) {
    const double time = since + static_cast<double>(k) * forecast_.interval;
    const SpaceTimePlan::State before = {
        .pose = {.position = {node.x, node.y}, .heading = node.heading}, .speed = node.speed};
    SpaceTimePlan::State now;
    if (time <= end) {
      now = plan.at(time - 1e-9);
    } else {
      now.pose.heading =
          before.pose.heading + shortest_turn(before.pose.heading, bearing_of_path(node));
      now.pose.position = before.pose.position +
                          forecast_.interval * robot_.linear_max * direction(now.pose.heading);
      now.speed = robot_.linear_max;
    }
    node.x = now.pose.position.x();
    node.y = now.pose.position.y();
    node.heading = now.pose.heading;
    node.speed = now.speed;
    node.cosine = std::cos(node.heading);
    node.sine = std::sin(node.heading);
    if (!locate(node.x, node.y, node.rectangle)) return false;
    const NearObstacles near = cost_.near(forecast_, node.x, node.y, 0.0, k);
    node.risk += forecast_.interval * cost_at(near, node.x, node.y, node.speed, k) +
                 effort(before, now, forecast_.interval);
    node.time += forecast_.interval;
    node.arrived = is_goal(node);
  }
  cost = node.time + (node.arrived ? 0.0 : time_left(node, straight_time({node.x, node.y}))) +
         node.risk;
  return true;
}

}  // namespace fairway
