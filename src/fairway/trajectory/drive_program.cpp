// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_program.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "fairway/trajectory/drive_limits.hpp"

namespace fairway::internal {

namespace {

using Eigen::Vector2d;

using PoseJacobian = Eigen::Matrix<double, 3, kVariables>;

// How the pose after the `share` of a step varies with the stage's variables.
PoseJacobian pose_jacobian(const BaseModel& base,
                           const Pose2& from,
                           const Inputs& input,
                           const Inputs& change,
                           double step,
                           double share) noexcept {
  Eigen::Matrix<double, 7, 1> at;
  at << input, change, step;
  const auto reached = [&](const Eigen::Matrix<double, 7, 1>& v) {
    const Pose2 pose = driven(base, {}, input_of(v.head<3>()),
                              input_of(v.head<3>() + share * v.segment<3>(3)), share * v(6));
    return Eigen::Vector3d(pose.position.x(), pose.position.y(), pose.heading);
  };
  constexpr double kDifference = 1e-6;
  PoseJacobian jacobian = PoseJacobian::Zero();
  for (int i = 0; i < 7; ++i) {
    Eigen::Matrix<double, 7, 1> v = at;
    v(i) += kDifference;
    const Eigen::Vector3d above = reached(v);
    v(i) -= 2.0 * kDifference;
    jacobian.col(kInputs + i) = (above - reached(v)) / (2.0 * kDifference);
  }
  const double c = std::cos(from.heading);
  const double s = std::sin(from.heading);
  Eigen::Matrix2d turn;
  turn << c, -s, s, c;
  jacobian.topRows<2>() = turn * jacobian.topRows<2>();
  if (base.kind != BaseKind::Omni) {
    jacobian.col(kInputs + 1).setZero();
    jacobian.col(kChanges + 1).setZero();
  }
  jacobian.leftCols<3>() = Eigen::Matrix3d::Identity();
  const Vector2d way = turn * reached(at).head<2>();
  jacobian.block<2, 1>(0, kHeading) = Vector2d(-way.y(), way.x());
  return jacobian;
}

void add_contacts(Stage& stage,
                  const DriveProblem& problem,
                  const DriveSample& sample,
                  const PoseJacobian& jacobian) {
  for (std::size_t i = 0; i < sample.count; ++i) {
    const BodyContact& contact = sample.contacts[i];
    const Vector2d arm = contact.point - sample.pose.position;
    const double lever = contact.normal.dot(Vector2d(-arm.y(), arm.x()));
    const StageVector gradient =
        -(jacobian.topRows<2>().transpose() * contact.normal + lever * jacobian.row(2).transpose());
    // What is missing is regained slowly: large steps away may have no solution.
    constexpr double kMostRegained = 0.003;  // [m]
    constrain(stage, gradient, std::max(contact.distance - problem.margin, -kMostRegained));
  }
}

void add_costs(Stage& stage,
               const DriveProblem& problem,
               const Inputs& now,
               const Inputs& change,
               double step,
               double damping) {
  const InputLimits limits(problem.base);
  stage.hessian.diagonal().setConstant(damping);
  stage.hessian(kStep, kStep) = 300.0 * damping;
  stage.gradient(kStep) = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double effort = i == 2 ? problem.cost.turn_effort : problem.cost.linear_effort;
    // effort (change / (limit step))^2 step
    const double weight = 2.0 * effort / (limits.slope(i) * limits.slope(i) * step);
    stage.hessian(kChanges + i, kChanges + i) += weight;
    stage.gradient(kChanges + i) += weight * change(i);
    stage.gradient(kStep) -= 0.5 * weight * change(i) * change(i) / step;
  }
  if (!limits.lateral) stage.hessian(kChanges + 1, kChanges + 1) += 1.0;
  if (is_steered(problem.base)) {
    const double weight = 2.0 * problem.cost.steering_angle * step;
    stage.hessian(kInputs + 2, kInputs + 2) += weight;
    stage.gradient(kInputs + 2) += weight * now.z();
    stage.gradient(kStep) += problem.cost.steering_angle * now.z() * now.z();
  }
}

// How far one pose is from another, a radian as half a metre.
double gap(const Pose2& a, const Pose2& b) noexcept {
  return (a.position - b.position).norm() + 0.5 * std::abs(shortest_turn(a.heading, b.heading));
}

// The side of the band as an obstacle that only the reference point touches.
double look_at_band(
    const DriveProblem& problem, double arc, double moved, double reach, DriveSample& sample) {
  const DriveBand::Nearest nearest = problem.band->next(sample.pose.position, arc, moved);
  const double left = problem.band->half_width - nearest.distance;
  if (left > reach || nearest.distance <= 0.0) return nearest.arc;
  const std::size_t place = std::min(sample.count, sample.contacts.size() - 1);
  sample.contacts[place] = {.distance = left + problem.margin,
                            .point = sample.pose.position,
                            .normal = (nearest.point - sample.pose.position) / nearest.distance};
  sample.count = place + 1;
  return nearest.arc;
}

}  // namespace

void evaluate(const DriveProblem& problem,
              const DriveIterate& iterate,
              double reach,
              DriveEvaluation& evaluation) {
  const Trajectory& trajectory = iterate.trajectory;
  const std::size_t count = trajectory.steps.size();
  evaluation.ends.resize(count);
  std::size_t used = 0;  // samples keep their memory
  evaluation.cost = 0.0;
  evaluation.violation = 0.0;
  evaluation.excess = 0.0;
  evaluation.gaps = gap(iterate.knots.back(), problem.goal);
  const InputLimits limits(problem.base);
  double arc = problem.arc;
  Vector2d before = iterate.knots.front().position;
  const auto look = [&](std::size_t step, double share, const Pose2& pose) {
    if (used == evaluation.samples.size()) evaluation.samples.emplace_back();
    DriveSample& sample = evaluation.samples[used];
    sample.step = step;
    sample.share = share;
    sample.pose = pose;
    sample.count = problem.clearance->contacts(pose, reach, sample.contacts);
    if (problem.band != nullptr) {
      arc = look_at_band(problem, arc, (pose.position - before).norm(), reach, sample);
      before = pose.position;
    }
    if (sample.count == 0) return;
    ++used;
    double missing = 0.0;
    for (std::size_t i = 0; i < sample.count; ++i)
      missing = std::max(missing, problem.margin - sample.contacts[i].distance);
    constexpr double kUnimportant = 5e-4;  // of a linearisation [m]
    evaluation.violation += std::max(0.0, missing - kUnimportant);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const BaseInput& now = trajectory.inputs[k];
    const BaseInput& next = trajectory.inputs[k + 1];
    const double step = trajectory.steps[k];
    const Pose2& from = iterate.knots[k];
    evaluation.ends[k] = driven(problem.base, from, now, next, step);
    evaluation.gaps += gap(evaluation.ends[k], iterate.knots[k + 1]);
    const PlanarTwist mean = twist_of(problem.base, 0.5 * (now + next));
    const double way =
        step * problem.clearance->body().greatest_speed(mean.linear, mean.lateral, mean.angular);
    // A corner of the body that passes a corner of an obstacle is nearer between two samples than
    // at both. By Pythagoras, with this spacing it keeps half of the margin.
    const double spacing = std::max(0.02, 1.7 * problem.margin);
    const int parts = std::clamp(static_cast<int>(std::ceil(way / spacing)), 1, 40);
    for (int i = 1; i <= parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      look(k, share,
           i == parts
               ? evaluation.ends[k]
               : driven(problem.base, from, now, (1.0 - share) * now + share * next, share * step));
    }
    evaluation.cost += step;
    const Inputs slope = (vector_of(next) - vector_of(now)) / step;
    for (int i = 0; i < 3; ++i) {
      const double share = slope(i) / limits.slope(i);
      evaluation.cost +=
          step * share * share * (i == 2 ? problem.cost.turn_effort : problem.cost.linear_effort);
    }
    const PlanarTwist after = twist_of(problem.base, next);
    evaluation.excess = std::max(evaluation.excess, speed_load(problem.base, after) - 1.0);
    if (is_steered(problem.base)) {
      evaluation.cost += step * problem.cost.steering_angle * now.turn * now.turn;
      const double rate = std::abs(after.angular - twist_of(problem.base, now).angular) / step;
      evaluation.excess =
          std::max(evaluation.excess, rate / problem.base.angular_acceleration - 1.0);
    }
  }
  evaluation.samples.resize(used);
}

void make_program(const DriveProblem& problem,
                  const DriveIterate& iterate,
                  const DriveEvaluation& evaluation,
                  const TrustRegion& trust,
                  StageProgram& program) {
  const Trajectory& trajectory = iterate.trajectory;
  const std::size_t count = trajectory.steps.size();
  program.stages.resize(count);
  std::size_t sample = 0;
  for (std::size_t k = 0; k < count; ++k) {
    Stage& stage = program.stages[k];
    stage.constraints.clear();
    stage.hessian.setZero();
    stage.gradient.setZero();
    const Inputs now = vector_of(trajectory.inputs[k]);
    const Inputs next = vector_of(trajectory.inputs[k + 1]);
    const double step = trajectory.steps[k];
    const Pose2& from = iterate.knots[k];
    const PoseJacobian end = pose_jacobian(problem.base, from, now, next - now, step, 1.0);
    stage.transition.topRows<3>() = end;
    stage.transition.bottomRows<3>().setZero();
    stage.transition.block<3, 3>(3, kInputs).setIdentity();
    stage.transition.block<3, 3>(3, kChanges).setIdentity();
    stage.offset.setZero();
    stage.offset.head<2>() = evaluation.ends[k].position - iterate.knots[k + 1].position;
    stage.offset(kHeading) = evaluation.ends[k].heading - iterate.knots[k + 1].heading;
    add_costs(stage, problem, now, next - now, step, trust.damping);
    add_limits(stage, problem.base, now, next, step, trust);
    for (int i = 0; i < 3 && k > 0; ++i) {
      StageVector g = StageVector::Zero();
      g(i) = 1.0;
      const double most = i == kHeading ? trust.heading : trust.position;
      constrain_between(stage, g, 0.0, -most, most, most);
    }
    for (; sample < evaluation.samples.size() && evaluation.samples[sample].step == k; ++sample) {
      const DriveSample& at = evaluation.samples[sample];
      add_contacts(stage, problem, at,
                   at.share >= 1.0
                       ? end
                       : pose_jacobian(problem.base, from, now, next - now, step, at.share));
    }
  }
  // The end: at the goal and at rest, by weights so large that nothing else matters.
  constexpr double kGoalWeight = 1e5;
  constexpr double kRestWeight = 1e5;
  const Pose2& end = iterate.knots.back();
  program.last_hessian.setZero();
  program.last_hessian.diagonal() << kGoalWeight, kGoalWeight, kGoalWeight, kRestWeight,
      kRestWeight, is_steered(problem.base) ? 0.0 : kRestWeight;
  program.last_gradient.setZero();
  program.last_gradient.head<2>() = kGoalWeight * (end.position - problem.goal.position);
  program.last_gradient(2) = -kGoalWeight * shortest_turn(end.heading, problem.goal.heading);
}

DriveIterate moved_along(const BaseModel& base,
                         const DriveIterate& iterate,
                         const StageSolution& solution,
                         double share) {
  DriveIterate next = iterate;
  const InputLimits limits(base);
  const std::size_t count = iterate.trajectory.steps.size();
  const auto shift = [&](std::size_t k, const StateVector& state) {
    next.knots[k].position += share * state.head<2>();
    next.knots[k].heading += share * state(kHeading);
    const Inputs input = vector_of(iterate.trajectory.inputs[k]) + share * state.tail<3>();
    next.trajectory.inputs[k] = input_of(input.cwiseMax(limits.low).cwiseMin(limits.high));
    if (base.kind != BaseKind::Omni) next.trajectory.inputs[k].lateral = 0.0;
  };
  for (std::size_t k = 0; k < count; ++k) {
    const StageVector& v = solution.variables[k];
    if (k > 0) shift(k, v.head<kStates>());
    next.trajectory.steps[k] =
        std::max(0.5 * kShortestStep, iterate.trajectory.steps[k] + share * v(kStep));
  }
  shift(count, solution.last_state);
  BaseInput& last = next.trajectory.inputs.back();
  last = {.turn = is_steered(base) ? last.turn : 0.0};
  return next;
}

}  // namespace fairway::internal
