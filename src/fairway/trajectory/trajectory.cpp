// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fairway/base/contract.hpp"

namespace fairway {

BaseInput operator+(const BaseInput& a, const BaseInput& b) noexcept {
  return {a.linear + b.linear, a.lateral + b.lateral, a.turn + b.turn};
}

BaseInput operator*(double factor, const BaseInput& input) noexcept {
  return {factor * input.linear, factor * input.lateral, factor * input.turn};
}

PlanarTwist twist_of(const BaseModel& base, const BaseInput& input) noexcept {
  if (!is_steered(base)) return {input.linear, input.lateral, input.turn};
  return {.linear = input.linear,
          .lateral = 0.0,
          .angular = input.linear * std::tan(input.turn) / base.wheelbase};
}

double steering_of(const BaseModel& base, const PlanarTwist& twist, double otherwise) noexcept {
  constexpr double kMoving = 0.05;  // [m/s]
  if (!is_steered(base) || std::abs(twist.linear) <= kMoving) return otherwise;
  return std::clamp(std::atan(base.wheelbase * twist.angular / twist.linear), -base.steering_max,
                    base.steering_max);
}

double Trajectory::duration() const noexcept {
  return std::accumulate(steps.begin(), steps.end(), 0.0);
}

void append(const Trajectory& next, Trajectory& trajectory) {
  trajectory.inputs.insert(trajectory.inputs.end(), next.inputs.begin() + 1, next.inputs.end());
  trajectory.steps.insert(trajectory.steps.end(), next.steps.begin(), next.steps.end());
}

Pose2 driven(const BaseModel& base,
             const Pose2& pose,
             const BaseInput& first,
             const BaseInput& last,
             double step) noexcept {
  const PlanarTwist a = twist_of(base, first);
  const PlanarTwist m = twist_of(base, 0.5 * (first + last));
  const PlanarTwist b = twist_of(base, last);
  const double turn_middle = step / 24.0 * (5.0 * a.angular + 8.0 * m.angular - b.angular);
  const double turn = step / 6.0 * (a.angular + 4.0 * m.angular + b.angular);
  const Eigen::Vector2d way = Eigen::Vector2d(a.linear, a.lateral) +
                              4.0 * rotated({m.linear, m.lateral}, turn_middle) +
                              rotated({b.linear, b.lateral}, turn);
  return {.position = transform(pose, step / 6.0 * way), .heading = pose.heading + turn};
}

std::vector<Pose2> knot_poses(const BaseModel& base, const Trajectory& trajectory) {
  std::vector<Pose2> poses{trajectory.start};
  for (std::size_t k = 0; k < trajectory.steps.size(); ++k)
    poses.push_back(driven(base, poses.back(), trajectory.inputs[k], trajectory.inputs[k + 1],
                           trajectory.steps[k]));
  return poses;
}

namespace {

// The integral of the inputs from the begin to any time, asked for in increasing order.
class InputIntegral {
 public:
  InputIntegral(const Trajectory& trajectory, double stretch) noexcept
      : trajectory_(trajectory),
        stretch_(stretch) {}

  BaseInput to(double time) noexcept {
    const std::vector<double>& steps = trajectory_.steps;
    while (knot_ < steps.size() && time >= begin_ + stretch_ * steps[knot_]) {
      sum_ = sum_ + stretch_ * steps[knot_] * 0.5 *
                        (trajectory_.inputs[knot_] + trajectory_.inputs[knot_ + 1]);
      begin_ += stretch_ * steps[knot_++];
    }
    if (knot_ == steps.size()) return sum_ + (time - begin_) * trajectory_.inputs.back();
    const double share = (time - begin_) / (stretch_ * steps[knot_]);
    const BaseInput& a = trajectory_.inputs[knot_];
    const BaseInput& b = trajectory_.inputs[knot_ + 1];
    return sum_ + (time - begin_) * ((1.0 - 0.5 * share) * a + 0.5 * share * b);
  }

 private:
  const Trajectory& trajectory_;
  double stretch_;
  std::size_t knot_ = 0;
  double begin_ = 0.0;
  BaseInput sum_;
};

// The trajectory of a base slowed down by a factor: the same geometry.
BaseInput slowed(const BaseModel& base, const BaseInput& input, double stretch) noexcept {
  return {.linear = input.linear / stretch,
          .lateral = input.lateral / stretch,
          .turn = is_steered(base) ? input.turn : input.turn / stretch};
}

}  // namespace

std::vector<TrajectoryRow> sampled(const BaseModel& base,
                                   const Trajectory& trajectory,
                                   double period) {
  FAIRWAY_EXPECTS(period > 0.0 && trajectory.inputs.size() == trajectory.steps.size() + 1);
  const double duration = trajectory.duration();
  const auto count = static_cast<std::size_t>(std::ceil(duration / period - 1e-9));
  const double stretch = duration > 0.0 ? static_cast<double>(count) * period / duration : 1.0;
  InputIntegral integral(trajectory, stretch);
  std::vector<TrajectoryRow> rows;
  rows.reserve(count + 1);
  Pose2 pose = trajectory.start;
  BaseInput before;
  for (std::size_t k = 0; k < count; ++k) {
    const BaseInput after = integral.to(static_cast<double>(k + 1) * period);
    const BaseInput mean = (1.0 / period) * (after + -1.0 * before);
    before = after;
    TrajectoryRow row{.pose = pose, .input = slowed(base, mean, stretch), .twist = {}};
    row.twist = twist_of(base, row.input);
    pose = moved(pose, row.twist, period);
    rows.push_back(row);
  }
  TrajectoryRow last{.pose = pose, .input = {}, .twist = {}};
  if (is_steered(base)) last.input.turn = trajectory.inputs.back().turn;
  rows.push_back(last);
  return rows;
}

double greatest_load(const BaseModel& base,
                     const std::vector<TrajectoryRow>& rows,
                     double period,
                     const BaseInput& begin) noexcept {
  double most = 0.0;
  const bool steered = is_steered(base);
  TrajectoryRow before{.pose = {}, .input = begin, .twist = twist_of(base, begin)};
  for (const TrajectoryRow& row : rows) {
    most = std::max(most, speed_load(base, row.twist));
    const auto rate = [&](double from, double to, double limit) {
      most = std::max(most, std::abs(to - from) / (period * limit));
    };
    rate(before.twist.linear, row.twist.linear, base.linear_acceleration);
    rate(before.twist.angular, row.twist.angular, base.angular_acceleration);
    if (base.kind == BaseKind::Omni)
      rate(before.twist.lateral, row.twist.lateral, base.lateral_acceleration);
    if (steered) {
      rate(before.input.turn, row.input.turn, base.steering_rate_max);
      most = std::max(most, std::abs(row.input.turn) / base.steering_max);
    }
    before = row;
  }
  return most;
}

}  // namespace fairway
