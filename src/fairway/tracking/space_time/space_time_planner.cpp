// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/space_time_planner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kNegligible = 0.02;  // cost of encounters on the reference path [s]
constexpr double kSlack = 0.02;       // beyond a rectangle [m]
constexpr double kLongest = 2.0;      // for which a plan is kept [s]

}  // namespace

// The half and the whole turn follow from the quarter.
SpaceTimePlanner::Turn SpaceTimePlanner::turn_by(double angle) noexcept {
  const double c = std::cos(0.25 * angle);
  const double s = std::sin(0.25 * angle);
  const double half_c = c * c - s * s;
  const double half_s = 2.0 * c * s;
  return {.angle = angle,
          .cosine = half_c * half_c - half_s * half_s,
          .sine = 2.0 * half_c * half_s,
          .quarter_cosine = c,
          .quarter_sine = s,
          .half_cosine = half_c,
          .half_sine = half_s};
}

SpaceTimePlanner::SpaceTimePlanner(const RobotSettings& robot,
                                   const PredictionSettings& prediction,
                                   double horizon,
                                   std::shared_ptr<SpaceTimeWorkspace> shared)
    : robot_(robot),
      per_top_(1.0 / robot.linear_max),
      stages_(std::min(SpaceTimePlan::kMaxStages, static_cast<std::size_t>(horizon / kStage))),
      acceleration_(change_max(linear_actuation(robot))),
      slowness_(per_top_ / (2.0 * acceleration_)),
      turn_max_(std::min(robot.angular_max, 2.0)),
      prediction_(prediction),
      encounter_settings_({.radius = robot.radius,
                           .margin = prediction.obstacle_margin,
                           .comfort = prediction.comfort_distance,
                           .headway = prediction.time_headway,
                           .braking = change_max(linear_actuation(robot)),
                           .speed_max = robot.linear_max}),
      workspace_(shared ? std::move(shared) : std::make_shared<SpaceTimeWorkspace>()),
      forecast_(workspace_->forecast),
      cost_(workspace_->cost),
      to_go_(workspace_->to_go),
      layers_(workspace_->layers),
      children_(workspace_->children),
      order_(workspace_->order),
      table_(workspace_->table),
      keys_(workspace_->keys) {
  for (const double share : {0.0, 0.35, -0.35, 1.0, -1.0})
    turns_.push_back(turn_by(share * turn_max_ * kStage));
  workspace_->reserve(stages_);
}

void SpaceTimePlanner::prepare(const SpaceTimeInput& input) noexcept {
  input_ = &input;
  predict(input.obstacles, input.age, input.pose.position, prediction_, 0.5 * kStage,
          2 * stages_ + 1, forecast_);
  cost_.set(encounter_settings_);
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

bool SpaceTimePlanner::update(const SpaceTimeInput& input) noexcept {
  constexpr double kBetter = 0.25;   // by which another motion must cost less [s]
  constexpr double kRenewal = 0.25;  // between two trees while the last plan keeps its cost [s]
  constexpr double kOff = 0.3;       // from the robot to where the plan wants it [m]
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
  const double since = input.time - plan_.start;
  double last_cost = 0.0;
  const bool has_last = plan_.stages == stages_ && since >= 0.0 && since <= kLongest &&
                        (plan_.at(since).pose.position - input.pose.position).norm() < kOff &&
                        evaluate(plan_, last_cost);
  if (has_last && input.time - tree_time_ < kRenewal - 1e-9 &&
      last_cost < plan_.cost - since + kBetter)
    return true;
  tree_time_ = input.time;
  to_go_.set(stages_, kStage, robot_.linear_max);
  find_costs_to_go();
  layers_[0].assign(1, first);
  for (std::size_t k = 0; k < stages_; ++k) {
    grow(k);
    if (child_count_ == 0) {
      plan_.stages = 0;
      return false;
    }
    select(k);
  }
  store(0, other_);
  double cost = 0.0;
  if (evaluate(other_, cost)) other_.cost = cost;
  if (!has_last || other_.cost < last_cost - kBetter) {
    plan_ = other_;
  } else {
    plan_.cost = last_cost + since;
  }
  return true;
}

}  // namespace fairway
