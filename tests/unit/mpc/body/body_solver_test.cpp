// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/body/body_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/body/body_evaluation.hpp"
#include "fairway/mpc/body/input_bounds.hpp"
#include "support/oracles/body_optimality.hpp"
#include "support/random/random_body_problem.hpp"

namespace fairway {
namespace {

constexpr int kProblems = 40;

template <typename Motion>
class BodySolverOf : public testing::Test {
 protected:
  BodyProblem<Motion> next(const test::BodyProblemKind& kind = {}) {
    return problems.next<Motion>(kind);
  }
  test::RandomBodyProblems problems{11};
  std::unique_ptr<BodySolver<Motion>> solver = std::make_unique<BodySolver<Motion>>();
};
using Motions = testing::Types<UnicycleMotion, SteeredMotion, OmniMotion>;
TYPED_TEST_SUITE(BodySolverOf, Motions);

// The greatest violation of a hard limit, with the limits relaxed as `find_input_bounds` does.
template <typename Motion>
double limit_violation(const BodyProblem<Motion>& problem, const BodySolution<Motion>& solution) {
  InputBounds<Motion> bounds;
  find_input_bounds(problem, bounds);
  double worst = 0.0;
  typename Motion::Input before = problem.previous_input;
  for (std::size_t k = 0; k < static_cast<std::size_t>(problem.horizon); ++k) {
    const typename Motion::Input& input = solution.inputs[k];
    worst = std::max(worst, (input - bounds.high[k]).maxCoeff());
    worst = std::max(worst, (bounds.low[k] - input).maxCoeff());
    worst = std::max(worst, ((input - before).cwiseAbs() - problem.max_change).maxCoeff());
    for (std::size_t i = 0; i < static_cast<std::size_t>(problem.num_input_limits); ++i)
      worst = std::max(worst,
                       std::abs(problem.input_limits[i].normal.dot(input)) - bounds.limits[k][i]);
    before = input;
  }
  return worst;
}

TYPED_TEST(BodySolverOf, SatisfiesTheOptimalityConditions) {
  int solved = 0;
  for (int i = 0; i < kProblems; ++i) {
    // Multipliers of constraints that are not near are then below 1e-5.
    const auto problem = this->next();
    const auto& solution = this->solver->solve(problem, {}, {.tolerance = 1e-8});
    if (solution.status != SolveStatus::Solved) continue;
    ++solved;
    test::BodyOptimality<TypeParam> optimality(problem, solution, 1e-3);
    EXPECT_LT(optimality.residual(), 1e-4) << "problem " << i;
  }
  EXPECT_GT(solved, kProblems / 2);
}

TYPED_TEST(BodySolverOf, ReportsWhatItsInputsCause) {
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = this->next({.horizon = 1 + i % kMaxHorizon});
    const auto& solution = this->solver->solve(problem);
    auto again = solution;
    assess(problem, again);
    EXPECT_NEAR(solution.cost, again.cost, 1e-9 * (1.0 + again.cost));
    EXPECT_NEAR(solution.sum_violation, again.sum_violation, 1e-9);
    EXPECT_NEAR(solution.max_violation, again.max_violation, 1e-9);
    EXPECT_LT((solution.poses[1].position - again.poses[1].position).norm(), 1e-12);
    EXPECT_LE(limit_violation(problem, solution), 1e-12);
  }
}

TYPED_TEST(BodySolverOf, StaysInsideBetweenTheSamples) {
  int solved = 0;
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = this->next({.obstacles = 0, .overlap = true});
    const auto& solution = this->solver->solve(problem);
    if (solution.status != SolveStatus::Solved) continue;
    ++solved;
    // The start itself is not constrained.
    for (std::size_t k = 1; k < static_cast<std::size_t>(problem.horizon); ++k) {
      const PlanarTwist twist = problem.motion.twist(solution.inputs[k]);
      const BodyRegion& region = problem.regions[k];
      for (double share = 0.0; share <= 1.0; share += 0.125) {
        const Pose2 pose = moved(solution.poses[k], twist, share * problem.dt);
        for (int point = 0; point < problem.num_points; ++point) {
          for (std::size_t r = 0; r < static_cast<std::size_t>(region.count); ++r) {
            if ((region.points[r] >> point & 1) == 0) continue;
            const Eigen::Vector2d place =
                transform(pose, problem.points[static_cast<std::size_t>(point)]);
            // 0.1 mm: the midpoint rule against the exact arc.
            EXPECT_TRUE(region.rectangles[r].contains(place, 1e-4));
          }
        }
      }
    }
  }
  EXPECT_GT(solved, kProblems / 2);
}

TYPED_TEST(BodySolverOf, GivesTheSameBitsWithBothRegisters) {
  using Kernels = interior_point::BodyKernels<TypeParam>;
  const Kernels* wide = interior_point::body_kernels_256<TypeParam>();
  if (wide == nullptr) GTEST_SKIP() << "this processor has no wide registers";
  const auto narrow =
      std::make_unique<BodySolver<TypeParam>>(interior_point::body_kernels_128<TypeParam>());
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = this->next();
    const auto& a = this->solver->solve(problem);
    const auto& b = narrow->solve(problem);
    ASSERT_EQ(a.iterations, b.iterations);
    EXPECT_EQ(a.cost, b.cost);
    EXPECT_EQ(a.inputs[0], b.inputs[0]);
  }
}

TYPED_TEST(BodySolverOf, DoesNotDependOnEarlierProblems) {
  const auto problem = this->next();
  const auto first = this->solver->solve(problem);
  static_cast<void>(this->solver->solve(this->next({.horizon = 50, .obstacles = 16})));
  const auto& again = this->solver->solve(problem);
  EXPECT_EQ(first.cost, again.cost);
  EXPECT_EQ(first.inputs[3], again.inputs[3]);
}

TYPED_TEST(BodySolverOf, NeedsFewerIterationsFromItsOwnSolution) {
  int cold = 0;
  int warm = 0;
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = this->next();
    const auto solution = this->solver->solve(problem);
    if (solution.status != SolveStatus::Solved) continue;
    BodyGuess<TypeParam> guess;
    guess.count = problem.horizon;
    guess.inputs = solution.inputs;
    const auto& again = this->solver->solve(problem, guess, InteriorPointSettings::warm());
    EXPECT_EQ(again.status, SolveStatus::Solved);
    EXPECT_NEAR(again.cost, solution.cost, 1e-3 * (1.0 + solution.cost));
    cold += solution.iterations;
    warm += again.iterations;
  }
  EXPECT_LT(warm, cold);
}

TYPED_TEST(BodySolverOf, ReturnsFromAnInputOutsideItsLimits) {
  auto problem = this->next({.obstacles = 0});
  problem.previous_input[0] = problem.input_max[0] + 2.5 * problem.max_change[0];
  const auto& solution = this->solver->solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::LeastViolation);
  EXPECT_LE(limit_violation(problem, solution), 1e-12);
  EXPECT_LT(solution.inputs[3][0], problem.input_max[0]);
}

TYPED_TEST(BodySolverOf, IsNeverWorseWithRestarts) {
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = this->next();
    const auto once = this->solver->solve(problem);
    const auto& best = this->solver->solve_with_restarts(problem);
    EXPECT_GE(best.iterations, once.iterations);
    if (once.status == SolveStatus::Solved) {
      EXPECT_EQ(best.cost, once.cost);
      continue;
    }
    EXPECT_LE(best.status == SolveStatus::Solved
                  ? 0.0
                  : best.cost + problem.violation_weight * best.sum_violation,
              once.cost + problem.violation_weight * once.sum_violation);
  }
}

// From the drive to the targets, the base ends with a corner of its body outside.
// A caller that bounds the iterations bounds those of every start.
TYPED_TEST(BodySolverOf, RestartsObeyTheSettings) {
  constexpr int kStarts = 4;
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = this->next();
    const auto& best = this->solver->solve_with_restarts(problem, {}, {.max_iterations = 1});
    EXPECT_LE(best.iterations, kStarts);
  }
}

TEST(BodySolverRestarts, FindAFeasiblePointBesideAViolatedMinimum) {
  test::RandomBodyProblems problems(12);
  static_cast<void>(problems.next<OmniMotion>({.obstacles = 0}));
  const auto problem = problems.next<OmniMotion>({.obstacles = 0});
  const auto solver = std::make_unique<BodySolver<OmniMotion>>();
  EXPECT_EQ(solver->solve(problem).status, SolveStatus::LeastViolation);
  EXPECT_EQ(solver->solve_with_restarts(problem).status, SolveStatus::Solved);
}

// A single rectangle whose far side the target lies beyond: the front vertices limit the drive.
TYPED_TEST(BodySolverOf, NamesTheConstraintThatLimitsMost) {
  auto problem = this->next({.obstacles = 0});
  problem.previous_input.setZero();
  OrientedRectangle rectangle{.seed = problem.start.position,
                              .orientation = problem.start.heading,
                              .min = {-3.0, -2.0},
                              .max = {problem.points[2].x() + 0.1, 2.0}};
  for (std::size_t k = 1; k <= static_cast<std::size_t>(problem.horizon); ++k) {
    problem.regions[k] = {
        .rectangles = {rectangle, rectangle}, .points = {0b111111, 0}, .count = 1};
    problem.targets[k].position = rectangle.to_world({3.0, 0.0});
    problem.targets[k].heading = problem.start.heading;
  }
  const auto& solution = this->solver->solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::Solved);
  EXPECT_EQ(solution.limiting.kind, ConstraintKind::Corridor);
  EXPECT_EQ(solution.limiting.index, 1);
  EXPECT_TRUE(solution.limiting.part == 2 || solution.limiting.part == 3);
}

TYPED_TEST(BodySolverOf, RefusesInvalidProblems) {
  const auto good = this->next();
  ASSERT_EQ(validate(good), ProblemFault::None);
  auto problem = good;
  problem.horizon = kMaxHorizon + 1;
  EXPECT_EQ(validate(problem), ProblemFault::Horizon);
  problem = good;
  problem.points[1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(validate(problem), ProblemFault::NotFinite);
  const auto& solution = this->solver->solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::InvalidProblem);
  EXPECT_EQ(solution.inputs[0].norm(), 0.0);
  problem = good;
  problem.input_max[0] = problem.input_min[0];
  EXPECT_EQ(validate(problem), ProblemFault::CommandRange);
  problem = good;
  problem.num_input_limits = 1;
  problem.input_limits[0].bound = 0.0;
  EXPECT_EQ(validate(problem), ProblemFault::Contradiction);
}

TYPED_TEST(BodySolverOf, AcceptsAGuessThatIsNotFinite) {
  const auto problem = this->next();
  BodyGuess<TypeParam> guess;
  guess.count = 2;
  guess.inputs[0].setConstant(std::numeric_limits<double>::quiet_NaN());
  guess.inputs[1].setConstant(1e300);
  const auto& solution = this->solver->solve(problem, guess);
  EXPECT_TRUE(std::isfinite(solution.cost));
  EXPECT_LE(limit_violation(problem, solution), 1e-12);
}

}  // namespace
}  // namespace fairway
