// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/problem_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fairway {

namespace {

// Collects the indices of the nearest, measured by the time until the bodies could touch. Indices
// of the fleet follow those of the obstacles.
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

// Returns the distance to keep at the samples so that `distance` is kept between them too. The
// relative speed is at most `speed`. On a straight piece of length L the foot of the perpendicular
// is within L/2 of one end, so with D at both ends no point on it is closer than sqrt(D^2 - L^2/4).
double between_samples(double distance, double speed, double dt) noexcept {
  return std::hypot(distance, 0.5 * speed * dt);
}

}  // namespace

void set_predictions(const PredictionSettings& settings,
                     const RobotSettings& robot,
                     const MovingAround& around,
                     const Eigen::Vector2d& position,
                     ControlProblem& problem) noexcept {
  const NearestMoving nearest(around, position);
  const double fastest = std::max(robot.linear_max, -robot.linear_min);
  const double body_distance = robot.radius + settings.obstacle_margin;
  problem.num_obstacles = static_cast<int>(nearest.count());
  for (std::size_t j = 0; j < nearest.count(); ++j) {
    PredictedObstacle& predicted = problem.obstacles[j];
    const bool is_robot = nearest[j] >= around.obstacles.size();
    for (int k = 0; k <= problem.horizon; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double ahead = k * problem.dt;
      const double grown = std::min(settings.obstacle_growth * ahead, settings.obstacle_growth_max);
      if (is_robot) {
        const FleetMember& member = around.fleet[nearest[j] - around.obstacles.size()];
        predicted.position[at] = member.motion->plan.at(around.time + ahead);
        predicted.keep_out[at] = between_samples(body_distance + member.motion->radius,
                                                 fastest + member.motion->speed_max, problem.dt);
      } else {
        const MovingObstacle& obstacle = around.obstacles[nearest[j]];
        predicted.position[at] = settings.predict_motion
                                     ? predicted_position(obstacle, around.age + ahead)
                                     : obstacle.position;
        predicted.keep_out[at] = between_samples(body_distance + obstacle.radius + grown,
                                                 fastest + obstacle.velocity.norm(), problem.dt);
      }
    }
  }
}

double turning_speed(double turn, const RobotSettings& robot, double period) noexcept {
  // Half of the limit, so that the delay of one cycle does not cause oscillation.
  const double stoppable = std::sqrt(change_max(angular_actuation(robot)) * std::abs(turn));
  return std::copysign(std::min({robot.angular_max, stoppable, std::abs(turn) / (2.0 * period)}),
                       turn);
}

}  // namespace fairway
