// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/derivatives.hpp"

#include <array>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "support/oracles/central_difference.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

using Eigen::VectorXd;
using test::Random;

constexpr double kTolerance = 1e-7;  // rounding over a step of 1e-6, for values up to about 100

constexpr std::size_t at(Eigen::Index k) { return static_cast<std::size_t>(k); }

// Maps (x, y, heading, linear, angular) to the pose after one step.
VectorXd stepped(const VectorXd& z, double dt, Integration integration) {
  const Pose2 next = step({.position = z.head<2>(), .heading = z[2]},
                          {.linear = z[3], .angular = z[4]}, dt, integration);
  return Eigen::Vector3d(next.position.x(), next.position.y(), next.heading);
}

TEST(Derivatives, OfAStepAgreeWithDifferences) {
  Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    const Integration integration = trial % 2 == 0 ? Integration::Euler : Integration::Midpoint;
    const double dt = random.uniform(0.01, 1.0);
    VectorXd z(5);
    for (double& value : z)
      value = random.uniform(-2.0, 2.0);
    const Pose2 pose{.position = z.head<2>(), .heading = z[2]};
    const Twist2 command{.linear = z[3], .angular = z[4]};
    const auto jacobian = [&](const VectorXd& x) {
      const StepJacobian j = step_jacobian({.position = x.head<2>(), .heading = x[2]},
                                           {.linear = x[3], .angular = x[4]}, dt, integration);
      Eigen::Matrix<double, 3, 5> all;
      all << j.by_pose, j.by_command;
      return all;
    };
    const Eigen::MatrixXd by_differences =
        test::central_difference([&](const VectorXd& x) { return stepped(x, dt, integration); }, z);
    EXPECT_LT((jacobian(z) - by_differences).cwiseAbs().maxCoeff(), kTolerance);

    const Eigen::Vector3d multiplier(random.uniform(-1, 1), random.uniform(-1, 1), 5.0);
    const Eigen::MatrixXd hessian = test::central_difference(
        [&](const VectorXd& x) { return VectorXd(jacobian(x).transpose() * multiplier); }, z);
    EXPECT_LT((step_hessian(pose, command, dt, integration, multiplier) -
               hessian.bottomRightCorner<3, 3>())
                  .cwiseAbs()
                  .maxCoeff(),
              kTolerance);
    EXPECT_LT(hessian.topRows<2>().cwiseAbs().maxCoeff(), kTolerance) << "position enters linearly";
  }
}

std::array<Twist2, kMaxHorizon> as_commands(const VectorXd& v) {
  std::array<Twist2, kMaxHorizon> commands;
  for (Eigen::Index k = 0; k < v.size() / 2; ++k)
    commands[at(k)] = {.linear = v[2 * k], .angular = v[2 * k + 1]};
  return commands;
}

VectorXd random_vector(Random& random, const ControlProblem& problem) {
  VectorXd v(2 * problem.horizon);
  for (double& value : v)
    value = random.uniform(-1.0, 1.0);
  return v;
}

VectorXd total_gradient(const ControlProblem& problem, const VectorXd& v) {
  const auto commands = as_commands(v);
  std::array<Pose2, kMaxHorizon + 1> poses;
  rollout(problem, commands, poses);
  std::array<Eigen::Vector2d, kMaxHorizon> gradient;
  cost_gradient(problem, commands, poses, gradient);
  VectorXd flat(v.size());
  for (Eigen::Index k = 0; k < problem.horizon; ++k)
    flat.segment<2>(2 * k) = gradient[at(k)];
  return flat;
}

TEST(Derivatives, OfTheCostThroughTheRolloutAgreeWithDifferences) {
  Random random(22);
  for (int trial = 0; trial < 100; ++trial) {
    const ControlProblem problem = test::random_control_problem(random);
    const VectorXd v = random_vector(random, problem);
    const auto total_cost = [&](const VectorXd& x) {
      const auto commands = as_commands(x);
      std::array<Pose2, kMaxHorizon + 1> poses;
      rollout(problem, commands, poses);
      return VectorXd(VectorXd::Constant(1, cost(problem, commands, poses)));
    };
    const VectorXd by_differences = test::central_difference(total_cost, v).row(0);
    const VectorXd gradient = total_gradient(problem, v);
    EXPECT_LT((gradient - by_differences).cwiseAbs().maxCoeff(),
              kTolerance * (1.0 + by_differences.cwiseAbs().maxCoeff()));
  }
}

TEST(Derivatives, OfTheCommandCostAgreeWithDifferences) {
  Random random(23);
  for (int trial = 0; trial < 100; ++trial) {
    ControlProblem problem = test::random_control_problem(random);
    problem.change_weight = {0.3, 0.7};
    const VectorXd v = random_vector(random, problem);
    const auto gradient = [&](const VectorXd& x) {
      const auto commands = as_commands(x);
      VectorXd flat(x.size());
      for (int k = 0; k < problem.horizon; ++k)
        flat.segment<2>(2 * k) = cost_gradient_by_command(problem, commands, k);
      return flat;
    };
    const Eigen::MatrixXd hessian = test::central_difference(gradient, v);
    for (int k = 0; k < problem.horizon; ++k) {
      const Eigen::Vector2d diagonal = hessian.diagonal().segment<2>(2 * k);
      EXPECT_LT((cost_hessian_by_command(problem, k) - diagonal).norm(), kTolerance);
      if (k + 1 < problem.horizon) {
        EXPECT_NEAR(hessian(2 * k, 2 * k + 2), -2.0 * problem.change_weight[0], kTolerance);
      }
    }
  }
}

TEST(Derivatives, OfSoftConstraintsAgreeWithDifferences) {
  Random random(24);
  for (int trial = 0; trial < 100; ++trial) {
    const ControlProblem problem = test::random_control_problem(random);
    std::array<Pose2, kMaxHorizon + 1> poses;
    for (Pose2& pose : poses)
      pose.position = problem.start.position + test::random_point(random, 2.0);
    visit_soft_constraints(problem, [&](const ConstraintName& name) {
      // By (p_{step-1}, p_step): value, then gradient.
      VectorXd z(4);
      z << poses[at(name.step - 1)].position, poses[at(name.step)].position;
      const auto row_at = [&](const VectorXd& x) {
        auto moved = poses;
        moved[at(name.step - 1)].position = x.head<2>();
        moved[at(name.step)].position = x.tail<2>();
        return soft_constraint(problem, moved, name);
      };
      const auto gradient = [&](const VectorXd& x) {
        const SoftConstraint row = row_at(x);
        VectorXd g(4);
        g << row.gradient_before, row.gradient;
        return g;
      };
      const auto margin = [&](const VectorXd& x) {
        return VectorXd(VectorXd::Constant(1, row_at(x).margin));
      };
      const VectorXd by_differences = test::central_difference(margin, z).row(0);
      EXPECT_LT((gradient(z) - by_differences).cwiseAbs().maxCoeff(), kTolerance);
      const SoftConstraint row = row_at(z);
      const Eigen::Vector4d curvature(row.curvature_before, row.curvature_before, row.curvature,
                                      row.curvature);
      const Eigen::MatrixXd expected = curvature.asDiagonal();
      const Eigen::MatrixXd hessian = test::central_difference(gradient, z);
      EXPECT_LT((expected - hessian).cwiseAbs().maxCoeff(), kTolerance);
    });
  }
}

}  // namespace
}  // namespace fairway
