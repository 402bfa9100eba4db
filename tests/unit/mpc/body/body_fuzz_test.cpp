// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/body/input_bounds.hpp"
#include "fairway/mpc/interior_point/body/body_solver.hpp"
#include "support/random/random_body_problem.hpp"

namespace fairway {
namespace {

template <typename Motion>
class BodySolverFuzz : public testing::Test {
 protected:
  // One of several values, at random.
  double one_of(std::initializer_list<double> values) {
    const double index = problems.uniform(0.0, static_cast<double>(values.size()));
    return *(values.begin() + static_cast<int>(index));
  }

  // A valid problem whose numbers are far from what a robot needs.
  BodyProblem<Motion> extreme() {
    BodyProblem<Motion> problem = problems.next<Motion>(
        {.horizon = static_cast<int>(problems.uniform(1.0, kMaxHorizon + 0.99)),
         .obstacles = static_cast<int>(one_of({0.0, 1.0, 16.0}))});
    problem.dt = one_of({0.001, 0.1, 1.0});
    problem.violation_weight = one_of({1.0, 1e4, 1e8});
    problem.input_weight.setConstant(one_of({0.0, 0.1, 1e6}));
    problem.change_weight.setConstant(one_of({0.0, 0.1, 1e6}));
    problem.max_change *= one_of({1e-3, 1.0, std::numeric_limits<double>::infinity()});
    problem.previous_input *= one_of({0.0, 1.0, 20.0});
    problem.num_points = static_cast<int>(one_of({0.0, 4.0, 6.0}));
    problem.barrier_retention = one_of({0.0, 0.5, 0.999});
    const double far = one_of({0.0, 0.0, 1e6});
    const double weight = one_of({0.0, 1.0, 1e5});
    const double shrink = one_of({0.0, 0.5, 5.0});
    problem.start.position.array() += far;
    for (std::size_t k = 1; k <= static_cast<std::size_t>(problem.horizon); ++k) {
      problem.targets[k].position.array() += far * one_of({1.0, 1.001});
      problem.targets[k].weight *= weight;
      for (OrientedRectangle& r : problem.regions[k].rectangles) {
        r.seed.array() += far;
        r = r.shrunk(shrink);  // 5 m: empty
      }
    }
    for (PredictedObstacle& obstacle : problem.obstacles) {
      for (Eigen::Vector2d& place : obstacle.position)
        place.array() += far;
      obstacle.keep_out.fill(one_of({0.0, 0.4, 20.0}));
    }
    return problem;
  }
  test::RandomBodyProblems problems{99};
};
using Motions = testing::Types<UnicycleMotion, SteeredMotion, OmniMotion>;
TYPED_TEST_SUITE(BodySolverFuzz, Motions);

TYPED_TEST(BodySolverFuzz, IsAlwaysFiniteAndWithinItsLimits) {
  using Input = typename TypeParam::Input;
  const auto solver = std::make_unique<BodySolver<TypeParam>>();
  for (int i = 0; i < 400; ++i) {
    const auto problem = this->extreme();
    ASSERT_EQ(validate(problem), ProblemFault::None) << to_text(validate(problem));
    const auto& solution = solver->solve(problem);
    ASSERT_NE(solution.status, SolveStatus::InvalidProblem) << "problem " << i;
    ASSERT_TRUE(std::isfinite(solution.cost));
    InputBounds<TypeParam> bounds;
    find_input_bounds(problem, bounds);
    Input before = problem.previous_input;
    for (std::size_t k = 0; k < static_cast<std::size_t>(problem.horizon); ++k) {
      const Input& input = solution.inputs[k];
      ASSERT_TRUE(input.allFinite());
      ASSERT_TRUE(is_finite(solution.poses[k + 1]));
      const double rounding = 1e-12 * (1.0 + input.norm());
      EXPECT_LE((input - bounds.high[k]).maxCoeff(), rounding) << "problem " << i;
      EXPECT_LE((bounds.low[k] - input).maxCoeff(), rounding) << "problem " << i;
      EXPECT_LE(((input - before).cwiseAbs() - problem.max_change).maxCoeff(), rounding)
          << "problem " << i;
      for (std::size_t j = 0; j < static_cast<std::size_t>(problem.num_input_limits); ++j) {
        EXPECT_LE(std::abs(problem.input_limits[j].normal.dot(input)),
                  bounds.limits[k][j] + rounding)
            << "problem " << i;
      }
      before = input;
    }
  }
}

}  // namespace
}  // namespace fairway
