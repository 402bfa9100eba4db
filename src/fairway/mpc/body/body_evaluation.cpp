// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/body/body_evaluation.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/mpc/step_index.hpp"

namespace fairway {
namespace {

// A point of the body in the world, with the offset from the reference point.
struct PlacedPoint {
  Eigen::Vector2d world, offset;
};

PlacedPoint placed(const Pose2& pose, const Eigen::Vector2d& point) noexcept {
  const Eigen::Vector2d offset = rotated(point, pose.heading);
  return {.world = pose.position + offset, .offset = offset};
}

// Derivative of a linear function of the placed point by the pose.
Eigen::Vector3d by_pose(const Eigen::Vector2d& normal, const Eigen::Vector2d& offset) noexcept {
  return {normal.x(), normal.y(), normal.y() * offset.x() - normal.x() * offset.y()};
}

// Second derivative of |placed point - center|^2 by the pose.
Eigen::Matrix3d square_curvature(const PlacedPoint& point, const Eigen::Vector2d& center) noexcept {
  const Eigen::Vector2d& w = point.offset;
  Eigen::Matrix3d m;
  m << 2.0, 0.0, -2.0 * w.y(),  //
      0.0, 2.0, 2.0 * w.x(),    //
      -2.0 * w.y(), 2.0 * w.x(), 2.0 * w.squaredNorm() - 2.0 * (point.world - center).dot(w);
  return m;
}

BodyConstraint corridor_side(const OrientedRectangle& rectangle,
                             int side,
                             const PlacedPoint& point,
                             double inset) noexcept {
  const Eigen::Vector2d along = direction(rectangle.orientation);
  const Eigen::Vector2d axis = side < 2 ? along : Eigen::Vector2d(-along.y(), along.x());
  const double place = axis.dot(point.world - rectangle.seed);
  const Eigen::Index coordinate = side / 2;
  const bool upper = side % 2 == 1;
  const Eigen::Vector2d normal = upper ? Eigen::Vector2d(-axis) : axis;
  BodyConstraint c;
  c.margin =
      (upper ? rectangle.max[coordinate] - place : place - rectangle.min[coordinate]) - inset;
  c.gradient = by_pose(normal, point.offset);
  c.curvature(2, 2) = -normal.dot(point.offset);
  return c;
}

double square(double a) noexcept { return a * a; }

}  // namespace

template <typename Motion>
void rollout(const BodyProblem<Motion>& problem,
             std::span<const typename Motion::Input> inputs,
             std::span<Pose2> poses) noexcept {
  poses[0] = problem.start;
  for (std::size_t k = 0; k < step_index(problem.horizon); ++k)
    poses[k + 1] = midpoint_step(poses[k], problem.motion.twist(inputs[k]), problem.dt);
}

template <typename Motion>
double cost(const BodyProblem<Motion>& problem,
            std::span<const typename Motion::Input> inputs,
            std::span<const Pose2> poses) noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < step_index(problem.horizon); ++k) {
    const StepTarget& target = problem.targets[k + 1];
    Eigen::Vector3d error;
    error << poses[k + 1].position - target.position, poses[k + 1].heading - target.heading;
    sum += target.weight.dot(error.cwiseAbs2());
    sum += problem.input_weight.dot(inputs[k].cwiseAbs2());
    if (k == 0 && !problem.penalise_first_change) continue;
    const typename Motion::Input change =
        inputs[k] - (k == 0 ? problem.previous_input : inputs[k - 1]);
    sum += problem.change_weight.dot(change.cwiseAbs2());
  }
  return sum;
}

template <typename Motion>
BodyConstraint soft_constraint(const BodyProblem<Motion>& problem,
                               std::span<const Pose2> poses,
                               const BodyConstraintName& name) noexcept {
  const std::size_t k = step_index(name.step);
  const std::size_t part = step_index(name.part);
  if (name.kind == ConstraintKind::Corridor) {
    return corridor_side(problem.regions[k].rectangles[step_index(name.index / 4)], name.index % 4,
                         placed(poses[k], problem.points[part]), problem.insets[part]);
  }
  const PredictedObstacle& obstacle = problem.obstacles[step_index(name.index)];
  const BodyDisc& disc = problem.discs[part];
  const double beta = problem.barrier_retention;
  const PlacedPoint now = placed(poses[k], disc.center);
  const PlacedPoint before = placed(poses[k - 1], disc.center);
  const Eigen::Vector2d away = now.world - obstacle.position[k];
  const Eigen::Vector2d away_before = before.world - obstacle.position[k - 1];
  BodyConstraint c;
  c.margin = away.squaredNorm() - square(obstacle.keep_out[k] + disc.radius) -
             beta * (away_before.squaredNorm() - square(obstacle.keep_out[k - 1] + disc.radius));
  c.gradient = by_pose(2.0 * away, now.offset);
  c.gradient_before = by_pose(-2.0 * beta * away_before, before.offset);
  c.curvature = square_curvature(now, obstacle.position[k]);
  c.curvature_before = -beta * square_curvature(before, obstacle.position[k - 1]);
  return c;
}

// The next position is p + dt R(phi) (u, v), phi = psi + dt / 2 r; the next heading psi + dt r.
template <typename Motion>
BodyStepDerivatives<Motion> step_derivatives(const BodyProblem<Motion>& problem,
                                             const Pose2& pose,
                                             const typename Motion::Input& input,
                                             const Eigen::Vector3d& multiplier) noexcept {
  const double dt = problem.dt;
  const double half = 0.5 * dt;
  const PlanarTwist twist = problem.motion.twist(input);
  const double phi = pose.heading + half * twist.angular;
  const Eigen::Vector2d along = dt * direction(phi);
  const Eigen::Vector2d left(-along.y(), along.x());
  const Eigen::Vector2d by_angle = twist.linear * left - twist.lateral * along;
  Eigen::Matrix3d by_twist = Eigen::Matrix3d::Zero();
  by_twist.block<2, 1>(0, 0) = along;
  by_twist.block<2, 1>(0, 1) = left;
  by_twist.col(2) << half * by_angle, dt;

  BodyStepDerivatives<Motion> d;
  const Eigen::Matrix<double, 3, Motion::kInputs> jacobian = problem.motion.jacobian(input);
  d.by_pose.template block<2, 1>(0, 2) = by_angle;
  d.by_input = by_twist * jacobian;

  // Second derivatives by (phi, linear, lateral), then by (heading, inputs).
  const Eigen::Vector2d lambda = multiplier.head<2>();
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  m(0, 0) = -lambda.dot(twist.linear * along + twist.lateral * left);
  m(0, 1) = m(1, 0) = lambda.dot(left);
  m(0, 2) = m(2, 0) = -lambda.dot(along);
  Eigen::Matrix<double, 3, Motion::kInputs + 1> chain;
  chain.setZero();
  chain(0, 0) = 1.0;
  chain.template block<1, Motion::kInputs>(0, 1) = half * jacobian.row(2);
  chain.template block<2, Motion::kInputs>(1, 1) = jacobian.template topRows<2>();
  d.hessian = chain.transpose() * m * chain;
  d.hessian.template bottomRightCorner<Motion::kInputs, Motion::kInputs>() +=
      problem.motion.hessian(input, by_twist.transpose() * multiplier);
  return d;
}

template <typename Motion>
typename Motion::Input cost_gradient_by_input(const BodyProblem<Motion>& problem,
                                              std::span<const typename Motion::Input> inputs,
                                              int k) noexcept {
  const std::size_t i = step_index(k);
  typename Motion::Input gradient = problem.input_weight.cwiseProduct(inputs[i]);
  if (k > 0 || problem.penalise_first_change) {
    const typename Motion::Input& before = k > 0 ? inputs[i - 1] : problem.previous_input;
    gradient += problem.change_weight.cwiseProduct(inputs[i] - before);
  }
  if (k + 1 < problem.horizon)
    gradient -= problem.change_weight.cwiseProduct(inputs[i + 1] - inputs[i]);
  return 2.0 * gradient;
}

template <typename Motion>
void add_pullback(const BodyProblem<Motion>& problem,
                  std::span<const typename Motion::Input> inputs,
                  std::span<const Pose2> poses,
                  std::span<const Eigen::Vector3d> by_pose,
                  std::span<typename Motion::Input> by_input) noexcept {
  Eigen::Vector3d adjoint = Eigen::Vector3d::Zero();
  for (std::size_t k = step_index(problem.horizon); k-- > 0;) {
    adjoint += by_pose[k + 1];
    const BodyStepDerivatives<Motion> d =
        step_derivatives(problem, poses[k], inputs[k], Eigen::Vector3d::Zero());
    by_input[k] += d.by_input.transpose() * adjoint;
    adjoint = (d.by_pose.transpose() * adjoint).eval();
  }
}

template <typename Motion>
void assess(const BodyProblem<Motion>& problem, BodySolution<Motion>& solution) noexcept {
  solution.horizon = problem.horizon;
  rollout<Motion>(problem, solution.inputs, solution.poses);
  solution.cost = cost<Motion>(problem, solution.inputs, solution.poses);
  solution.max_violation = 0.0;
  solution.sum_violation = 0.0;
  visit_soft_constraints(problem, [&](const BodyConstraintName& name) {
    const double violation =
        std::max(0.0, -soft_constraint<Motion>(problem, solution.poses, name).margin);
    solution.max_violation = std::max(solution.max_violation, violation);
    solution.sum_violation += violation;
  });
}

#define FAIRWAY_INSTANTIATE(Motion)                                                               \
  template void rollout(const BodyProblem<Motion>&, std::span<const Motion::Input>,               \
                        std::span<Pose2>) noexcept;                                               \
  template double cost(const BodyProblem<Motion>&, std::span<const Motion::Input>,                \
                       std::span<const Pose2>) noexcept;                                          \
  template BodyConstraint soft_constraint(const BodyProblem<Motion>&, std::span<const Pose2>,     \
                                          const BodyConstraintName&) noexcept;                    \
  template BodyStepDerivatives<Motion> step_derivatives(const BodyProblem<Motion>&, const Pose2&, \
                                                        const Motion::Input&,                     \
                                                        const Eigen::Vector3d&) noexcept;         \
  template Motion::Input cost_gradient_by_input(const BodyProblem<Motion>&,                       \
                                                std::span<const Motion::Input>, int) noexcept;    \
  template void add_pullback(const BodyProblem<Motion>&, std::span<const Motion::Input>,          \
                             std::span<const Pose2>, std::span<const Eigen::Vector3d>,            \
                             std::span<Motion::Input>) noexcept;                                  \
  template void assess(const BodyProblem<Motion>&, BodySolution<Motion>&) noexcept;
FAIRWAY_INSTANTIATE(UnicycleMotion)
FAIRWAY_INSTANTIATE(SteeredMotion)
FAIRWAY_INSTANTIATE(OmniMotion)
#undef FAIRWAY_INSTANTIATE

}  // namespace fairway
