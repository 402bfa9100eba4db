// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/stage_program.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway::internal {
namespace {

// A random convex program: strictly convex, with constraints that 0 keeps strictly.
StageProgram random_program(test::Random& random, int stages, int constraints) {
  StageProgram program;
  const auto fill = [&](auto& matrix, double size) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i)
      matrix.data()[i] = random.uniform(-size, size);
  };
  for (int k = 0; k < stages; ++k) {
    Stage stage;
    fill(stage.transition, 0.4);
    fill(stage.offset, 0.05);
    StageMatrix root;
    fill(root, 1.0);
    stage.hessian = root * root.transpose() + 0.1 * StageMatrix::Identity();
    fill(stage.gradient, 2.0);
    for (int i = 0; i < constraints; ++i) {
      StageConstraint c;
      fill(c.gradient, 1.0);
      c.bound = random.uniform(0.05, 1.0);
      stage.constraints.push_back(c);
    }
    program.stages.push_back(std::move(stage));
  }
  program.last_hessian.diagonal().setConstant(3.0);
  program.last_gradient.setConstant(0.5);
  return program;
}

// All variables as one vector: controls of all stages. States follow.
struct Dense {
  Eigen::MatrixXd map;     // controls -> stage variables and the last state
  Eigen::VectorXd offset;  // of the same
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;

  explicit Dense(const StageProgram& program) {
    const auto count = static_cast<Eigen::Index>(program.stages.size());
    const Eigen::Index rows = count * kVariables + kStates;
    map = Eigen::MatrixXd::Zero(rows, count * kControls);
    offset = Eigen::VectorXd::Zero(rows);
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(rows, rows);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(rows);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Stage& stage = program.stages[static_cast<std::size_t>(k)];
      const Eigen::Index at = k * kVariables;
      map.block<kControls, kControls>(at + kStates, k * kControls).setIdentity();
      map.middleRows<kStates>(at + kVariables) = stage.transition * map.middleRows<kVariables>(at);
      offset.segment<kStates>(at + kVariables) =
          stage.transition * offset.segment<kVariables>(at) + stage.offset;
      h.block<kVariables, kVariables>(at, at) = stage.hessian;
      g.segment<kVariables>(at) = stage.gradient;
    }
    h.bottomRightCorner<kStates, kStates>() = program.last_hessian;
    g.tail<kStates>() = program.last_gradient;
    hessian = map.transpose() * h * map;
    gradient = map.transpose() * (h * offset + g);
  }
};

Eigen::VectorXd controls_of(const StageSolution& solution) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(solution.variables.size()) * kControls);
  for (std::size_t k = 0; k < solution.variables.size(); ++k)
    all.segment<kControls>(static_cast<Eigen::Index>(k) * kControls) =
        solution.variables[k].tail<kControls>();
  return all;
}

TEST(StageProgram, AgreesWithADenseSolutionWithoutConstraints) {
  test::Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    StageProgram program = random_program(random, 8, 0);
    const Dense dense(program);
    StageSolution solution;
    solve(program, 30, solution);
    EXPECT_TRUE(solution.solved);
    const Eigen::VectorXd best = dense.hessian.ldlt().solve(-dense.gradient);
    EXPECT_LT((controls_of(solution) - best).cwiseAbs().maxCoeff(), 1e-7);
  }
}

// The conditions of optimality, on the dense form: they are sufficient, the program is convex.
TEST(StageProgram, SolutionsWithConstraintsAreOptimal) {
  test::Random random(2);
  int active = 0;
  for (int trial = 0; trial < 30; ++trial) {
    StageProgram program = random_program(random, 10, 12);
    const Dense dense(program);
    StageSolution solution;
    solve(program, 40, solution);
    ASSERT_TRUE(solution.solved);
    const Eigen::VectorXd controls = controls_of(solution);
    Eigen::VectorXd stationarity = dense.hessian * controls + dense.gradient;
    const Eigen::VectorXd variables = dense.map * controls + dense.offset;
    for (std::size_t k = 0; k < program.stages.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k) * kVariables;
      EXPECT_LT((variables.segment<kVariables>(at) - solution.variables[k]).cwiseAbs().maxCoeff(),
                1e-8);
      for (const StageConstraint& c : program.stages[k].constraints) {
        const double left = c.bound - c.gradient.dot(variables.segment<kVariables>(at));
        EXPECT_GT(left, -1e-5);
        EXPECT_GE(c.multiplier, 0.0);
        EXPECT_LT(std::abs(left * c.multiplier), 1e-4);
        if (c.multiplier > 1e-2) ++active;
        stationarity +=
            dense.map.middleRows<kVariables>(at).transpose() * (c.multiplier * c.gradient);
      }
    }
    EXPECT_LT(stationarity.cwiseAbs().maxCoeff(), 1e-4);
  }
  EXPECT_GT(active, 30);
}

TEST(StageProgram, SaysSoWhereConstraintsExcludeEachOther) {
  test::Random random(3);
  StageProgram program = random_program(random, 3, 0);
  StageConstraint c;
  c.gradient(kStates) = 1.0;
  c.bound = -1.0;
  program.stages[0].constraints.push_back(c);
  c.gradient(kStates) = -1.0;
  program.stages[0].constraints.push_back(c);
  StageSolution solution;
  solve(program, 30, solution);
  EXPECT_FALSE(solution.solved);
}

}  // namespace
}  // namespace fairway::internal
