// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/body/body_evaluation.hpp"
#include "support/random/random_body_problem.hpp"

namespace fairway {
namespace {

constexpr double kStep = 1e-5;  // of central differences

template <typename Motion>
class BodyDerivatives : public testing::Test {
 protected:
  typename Motion::Input random_input() {
    typename Motion::Input input;
    for (int j = 0; j < Motion::kInputs; ++j)
      input[j] = problems.uniform(-1.0, 1.0);
    return input;
  }
  test::RandomBodyProblems problems{7};
};
using Motions = testing::Types<UnicycleMotion, SteeredMotion, OmniMotion>;
TYPED_TEST_SUITE(BodyDerivatives, Motions);

Eigen::Vector3d as_vector(const Pose2& pose) {
  return {pose.position.x(), pose.position.y(), pose.heading};
}
Pose2 as_pose(const Eigen::Vector3d& v) { return {.position = v.head<2>(), .heading = v.z()}; }

// Central differences of a function of a vector.
template <typename Function, typename Vector>
Eigen::MatrixXd differences(const Function& f, const Vector& x) {
  Eigen::MatrixXd jacobian;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Vector above = x;
    Vector below = x;
    above[i] += kStep;
    below[i] -= kStep;
    const Eigen::VectorXd column = (f(above) - f(below)) / (2.0 * kStep);
    if (i == 0) jacobian.resize(column.size(), x.size());
    jacobian.col(i) = column;
  }
  return jacobian;
}

TYPED_TEST(BodyDerivatives, OfAStepMatchDifferences) {
  using Input = typename TypeParam::Input;
  constexpr int kInputs = TypeParam::kInputs;
  for (int round = 0; round < 20; ++round) {
    const auto problem = this->problems.template next<TypeParam>({.horizon = 2, .obstacles = 0});
    const Input input = this->random_input();
    const Eigen::Vector3d multiplier(0.7, -1.3, 0.4);
    using Full = Eigen::Matrix<double, kInputs + 3, 1>;
    Full at;
    at << as_vector(problem.start), input;
    const auto next = [&](const Full& x) -> Eigen::VectorXd {
      return as_vector(midpoint_step(as_pose(x.template head<3>()),
                                     problem.motion.twist(x.template tail<kInputs>()), problem.dt));
    };
    const auto gradient = [&](const Full& x) -> Eigen::VectorXd {
      const auto d = step_derivatives<TypeParam>(problem, as_pose(x.template head<3>()),
                                                 x.template tail<kInputs>(), multiplier);
      Eigen::VectorXd g(kInputs + 1);
      g << d.by_pose.col(2).dot(multiplier), d.by_input.transpose() * multiplier;
      return g;
    };
    const auto d = step_derivatives<TypeParam>(problem, problem.start, input, multiplier);
    const Eigen::MatrixXd first = differences(next, at);
    EXPECT_LT((first.leftCols(3) - d.by_pose).norm(), 1e-8);
    EXPECT_LT((first.rightCols(kInputs) - d.by_input).norm(), 1e-8);
    const Eigen::MatrixXd second = differences(gradient, at);
    EXPECT_LT((second.rightCols(kInputs + 1) - d.hessian).norm(), 1e-8);
  }
}

TYPED_TEST(BodyDerivatives, OfConstraintsMatchDifferences) {
  const auto problem = this->problems.template next<TypeParam>({.horizon = 4, .overlap = true});
  std::vector<Pose2> poses(5, problem.start);
  for (std::size_t k = 1; k < poses.size(); ++k)
    poses[k] = {.position = problem.start.position + Eigen::Vector2d(0.1, -0.2),
                .heading = problem.start.heading + 0.1 * static_cast<double>(k)};
  int count = 0;
  visit_soft_constraints(problem, [&](const BodyConstraintName& name) {
    ++count;
    const auto at = [&](int back, const Eigen::Vector3d& pose) {
      std::vector<Pose2> moved = poses;
      moved[static_cast<std::size_t>(name.step - back)] = as_pose(pose);
      return soft_constraint<TypeParam>(problem, moved, name);
    };
    const BodyConstraint c = soft_constraint<TypeParam>(problem, poses, name);
    for (const int back : {0, 1}) {
      const Eigen::Vector3d pose = as_vector(poses[static_cast<std::size_t>(name.step - back)]);
      const Eigen::MatrixXd first = differences(
          [&](const Eigen::Vector3d& x) -> Eigen::VectorXd {
            return Eigen::VectorXd::Constant(1, at(back, x).margin);
          },
          pose);
      const Eigen::MatrixXd second = differences(
          [&](const Eigen::Vector3d& x) -> Eigen::VectorXd {
            return back == 0 ? at(0, x).gradient : at(1, x).gradient_before;
          },
          pose);
      EXPECT_LT((first.transpose() - (back == 0 ? c.gradient : c.gradient_before)).norm(), 1e-7);
      EXPECT_LT((second - (back == 0 ? c.curvature : c.curvature_before)).norm(), 1e-7);
    }
  });
  EXPECT_EQ(count, 4 * (2 * 4 * 4 + 2 * 3));
}

TYPED_TEST(BodyDerivatives, OfTheCostMatchDifferencesThroughTheRollout) {
  using Input = typename TypeParam::Input;
  const auto problem = this->problems.template next<TypeParam>({.horizon = 5, .obstacles = 0});
  std::vector<Input> inputs(5);
  for (Input& input : inputs)
    input = this->random_input();
  std::vector<Pose2> poses(6);
  const auto cost_of = [&](const std::vector<Input>& all) {
    rollout<TypeParam>(problem, all, poses);
    return cost<TypeParam>(problem, all, poses);
  };
  cost_of(inputs);
  std::vector<Eigen::Vector3d> by_pose(6);
  for (std::size_t k = 1; k <= 5; ++k) {
    by_pose[k] << poses[k].position - problem.targets[k].position,
        poses[k].heading - problem.targets[k].heading;
    by_pose[k] = 2.0 * by_pose[k].cwiseProduct(problem.targets[k].weight);
  }
  std::vector<Input> gradient(5);
  for (int k = 0; k < 5; ++k)
    gradient[static_cast<std::size_t>(k)] = cost_gradient_by_input<TypeParam>(problem, inputs, k);
  add_pullback<TypeParam>(problem, inputs, poses, by_pose, gradient);
  for (std::size_t k = 0; k < 5; ++k) {
    for (int j = 0; j < TypeParam::kInputs; ++j) {
      std::vector<Input> above = inputs;
      std::vector<Input> below = inputs;
      above[k][j] += kStep;
      below[k][j] -= kStep;
      EXPECT_NEAR(gradient[k][j], (cost_of(above) - cost_of(below)) / (2.0 * kStep), 1e-6);
    }
  }
}

}  // namespace
}  // namespace fairway
