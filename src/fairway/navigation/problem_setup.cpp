// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/problem_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fairway {

namespace {

struct Range {
  double low;
  double high;
};

Range reachable(double low, double high, double last, double change) noexcept {
  return {.low = std::min(low, last + change), .high = std::max(high, last - change)};
}

// The indices of the nearest, counted in time until the bodies could touch; the fleet's come after
// the obstacles'.
class NearestMoving {
 public:
  NearestMoving(const MovingAround& around, const Eigen::Vector2d& position) noexcept {
    std::size_t index = 0;
    for (const MovingObstacle& obstacle : around.obstacles) {
      insert(index++,
             (obstacle.position - position).norm() - obstacle.radius - obstacle.velocity.norm());
    }
    for (const FleetMember& member : around.fleet) {
      const SharedMotion& motion = *member.motion;
      insert(index++, (motion.position - position).norm() - motion.radius - motion.speed);
    }
  }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] std::size_t operator[](std::size_t i) const noexcept { return index_[i]; }

 private:
  void insert(std::size_t index, double gap) noexcept {
    if (count_ == kMaxObstacles && gap >= gap_[count_ - 1]) return;
    std::size_t at = count_ < kMaxObstacles ? count_++ : count_ - 1;
    for (; at > 0 && gap_[at - 1] > gap; --at) {
      gap_[at] = gap_[at - 1];
      index_[at] = index_[at - 1];
    }
    gap_[at] = gap;
    index_[at] = index;
  }

  std::array<std::size_t, kMaxObstacles> index_{};
  std::array<double, kMaxObstacles> gap_{};
  std::size_t count_ = 0;
};

// The distance to keep at the samples so that `distance` is kept between them too, at relative
// speeds up to `speed`. On a straight piece of length L the foot of the perpendicular is within L/2
// of one end, so with D at both ends nothing on it is nearer than sqrt(D^2 - L^2/4).
double between_samples(double distance, double speed, double dt) noexcept {
  return std::hypot(distance, 0.5 * speed * dt);
}

}  // namespace

void set_limits(const Settings& settings,
                const Pose2& pose,
                const Twist2& last_command,
                ControlProblem& problem) noexcept {
  const MpcSettings& mpc = settings.mpc;
  problem.horizon = mpc.horizon;
  problem.dt = mpc.dt;
  problem.integration = mpc.integration;
  // A base that ramps from command to command is, half a cycle later, where one that jumps would
  // be.
  problem.start =
      step(pose, last_command, settings.navigation.actuation_lag * mpc.dt, Integration::Midpoint);
  problem.previous_command = last_command;
  problem.max_change = {.linear = mpc.linear_acceleration_max * mpc.dt,
                        .angular = mpc.angular_acceleration_max * mpc.dt};
  const Range linear =
      reachable(mpc.linear_min, mpc.linear_max, last_command.linear, problem.max_change.linear);
  const Range angular = reachable(-mpc.angular_max, mpc.angular_max, last_command.angular,
                                  problem.max_change.angular);
  problem.command_min = {.linear = linear.low, .angular = angular.low};
  problem.command_max = {.linear = linear.high, .angular = angular.high};
  problem.command_weight = {mpc.weight_linear, mpc.weight_angular};
  problem.change_weight = {mpc.weight_linear_change, mpc.weight_angular_change};
  problem.penalise_first_change = mpc.penalise_first_change;
  problem.cost_offset = 0.0;
  problem.barrier_retention = 1.0 - mpc.decay_rate * mpc.dt;
  problem.violation_weight = mpc.violation_weight;
}

void set_predictions(const Settings& settings,
                     const MovingAround& around,
                     const Eigen::Vector2d& position,
                     ControlProblem& problem) noexcept {
  const NearestMoving nearest(around, position);
  const double fastest = std::max(settings.mpc.linear_max, -settings.mpc.linear_min);
  const NavigationSettings& nav = settings.navigation;
  const double room = settings.robot.radius + nav.obstacle_margin;
  problem.num_obstacles = static_cast<int>(nearest.count());
  for (std::size_t j = 0; j < nearest.count(); ++j) {
    PredictedObstacle& predicted = problem.obstacles[j];
    const bool robot = nearest[j] >= around.obstacles.size();
    for (int k = 0; k <= problem.horizon; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double ahead = k * problem.dt;
      const double grown = std::min(nav.obstacle_growth * ahead, nav.obstacle_growth_max);
      if (robot) {
        const FleetMember& member = around.fleet[nearest[j] - around.obstacles.size()];
        predicted.position[at] = member.motion->plan.at(around.time + ahead);
        predicted.keep_out[at] = between_samples(room + member.motion->radius,
                                                 fastest + member.motion->speed_max, problem.dt);
      } else {
        const MovingObstacle& obstacle = around.obstacles[nearest[j]];
        predicted.position[at] = nav.predict_motion
                                     ? predicted_position(obstacle, around.age + ahead)
                                     : obstacle.position;
        predicted.keep_out[at] = between_samples(room + obstacle.radius + grown,
                                                 fastest + obstacle.velocity.norm(), problem.dt);
      }
    }
  }
}

Limit limit_of(const RowName& row) noexcept {
  switch (row.kind) {
    case RowKind::None:
      return Limit::None;
    case RowKind::LinearSpeed:
    case RowKind::AngularSpeed:
      return Limit::Speed;
    case RowKind::LinearChange:
    case RowKind::AngularChange:
      return Limit::Acceleration;
    case RowKind::Corridor:
      return Limit::Corridor;
    case RowKind::Barrier:
      return Limit::MovingObstacle;
  }
  return Limit::None;
}

double turning_speed(double turn, const MpcSettings& limits) noexcept {
  // Half of the limit, so that the delay of one cycle does not make it swing.
  const double stoppable = std::sqrt(limits.angular_acceleration_max * std::abs(turn));
  return std::copysign(
      std::min({limits.angular_max, stoppable, std::abs(turn) / (2.0 * limits.dt)}), turn);
}

}  // namespace fairway
