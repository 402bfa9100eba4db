// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "experiments/solver/paper_problem.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/mpc/problem_from_settings.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Case {
  const char* what;
  std::function<void(ControlProblem&)> spoil;
  ProblemFault fault;
};

ControlProblem sound_problem() {
  ControlProblem problem;
  problem.horizon = 5;
  problem.num_obstacles = 1;
  problem.obstacles[0].position.fill({3.0, 3.0});
  problem.obstacles[0].keep_out.fill(0.5);
  problem.regions[1] = {.rectangles = {}, .count = 1};
  return problem;
}

TEST(Validate, NamesTheFault) {
  const std::vector<Case> cases{
      {"nothing", [](auto&) {}, ProblemFault::None},
      {"no step", [](auto& p) { p.horizon = 0; }, ProblemFault::Horizon},
      {"too many steps", [](auto& p) { p.horizon = kMaxHorizon + 1; }, ProblemFault::Horizon},
      {"too many obstacles", [](auto& p) { p.num_obstacles = kMaxObstacles + 1; },
       ProblemFault::Counts},
      {"negative number of rectangles", [](auto& p) { p.regions[5].count = -1; },
       ProblemFault::Counts},
      {"three rectangles", [](auto& p) { p.regions[5].count = 3; }, ProblemFault::Counts},
      {"NaN in the start", [](auto& p) { p.start.heading = kNaN; }, ProblemFault::NotFinite},
      {"infinite target", [](auto& p) { p.targets[5].position.x() = kInfinity; },
       ProblemFault::NotFinite},
      {"huge target", [](auto& p) { p.targets[5].position.x() = 1e200; }, ProblemFault::NotFinite},
      {"NaN in a rectangle", [](auto& p) { p.regions[1].rectangles[0].max.y() = kNaN; },
       ProblemFault::NotFinite},
      {"NaN obstacle", [](auto& p) { p.obstacles[0].position[5].y() = kNaN; },
       ProblemFault::NotFinite},
      {"NaN change bound", [](auto& p) { p.max_change.angular = kNaN; }, ProblemFault::NotFinite},
      {"NaN offset", [](auto& p) { p.cost_offset = kNaN; }, ProblemFault::NotFinite},
      {"no time", [](auto& p) { p.dt = 0.0; }, ProblemFault::TimeStep},
      {"negative weight", [](auto& p) { p.targets[3].weight.z() = -1.0; }, ProblemFault::Weights},
      {"free violation", [](auto& p) { p.violation_weight = 0.0; }, ProblemFault::Weights},
      {"dt gamma 0", [](auto& p) { p.barrier_retention = 1.0; }, ProblemFault::Retention},
      {"dt gamma above 1", [](auto& p) { p.barrier_retention = -0.1; }, ProblemFault::Retention},
      {"dt gamma 1", [](auto& p) { p.barrier_retention = 0.0; }, ProblemFault::None},
      {"negative keep-out", [](auto& p) { p.obstacles[0].keep_out[0] = -0.1; },
       ProblemFault::KeepOut},
      {"empty range", [](auto& p) { p.command_min.linear = 2.0; }, ProblemFault::CommandRange},
      {"negative change", [](auto& p) { p.max_change.linear = -0.1; }, ProblemFault::CommandRange},
      {"stop outside the range",
       [](auto& p) {
         p.stop_at_end = true;
         p.command_min.linear = 0.05;
       },
       ProblemFault::Contradiction},
      {"no stop in time",
       [](auto& p) {
         p.stop_at_end = true;
         p.max_change.linear = 0.1;
         p.previous_command.linear = 0.51;
       },
       ProblemFault::Contradiction},
      {"a stop just in time",
       [](auto& p) {
         p.stop_at_end = true;
         p.max_change.linear = 0.1;
         p.previous_command.linear = 0.5;
       },
       ProblemFault::None},
      {"too fast now",
       [](auto& p) {
         p.max_change.linear = 0.1;
         p.previous_command.linear = 1.2;
       },
       ProblemFault::Contradiction},
      {"beyond the horizon nothing counts",
       [](auto& p) { p.targets[6].position.x() = p.obstacles[1].keep_out[0] = kNaN; },
       ProblemFault::None},
  };
  for (const Case& c : cases) {
    ControlProblem problem = sound_problem();
    c.spoil(problem);
    EXPECT_EQ(validate(problem), c.fault) << c.what << ": " << to_text(validate(problem));
  }
}

TEST(Validate, AcceptsThePapersProblemForDtGammaUpToOne) {
  MpcSettings settings = paper_mpc_settings();
  for (const double decay_rate : {0.01, 1.0, 5.0, 10.0}) {
    settings.decay_rate = decay_rate;
    EXPECT_EQ(validate(paper_problem(settings, paper_robot_settings(), {})), ProblemFault::None)
        << decay_rate;
  }
  settings.decay_rate = 10.1;
  EXPECT_EQ(validate(paper_problem(settings, paper_robot_settings(), {})), ProblemFault::Retention);
}

TEST(PaperProblem, HasTheValuesOfTableOne) {
  const std::array<MovingObstacle, 1> obstacles{
      MovingObstacle{.position = {1.0, 2.0}, .velocity = {0.5, -1.0}, .radius = 0.5}};
  PaperScene scene;
  scene.obstacles = obstacles;
  scene.robot_radius = 0.3;
  scene.region = {.min = {-1.0, -1.0}, .max = {1.0, 1.0}};
  const ControlProblem problem = paper_problem(paper_mpc_settings(), paper_robot_settings(), scene);
  EXPECT_EQ(problem.horizon, 10);
  EXPECT_EQ(problem.command_min.linear, 0.05);
  EXPECT_EQ(problem.command_max.linear, 1.0);
  EXPECT_EQ(problem.command_min.angular, -1.5);
  EXPECT_EQ(problem.barrier_retention, 0.5);
  EXPECT_EQ(problem.max_change.linear, kInfinity) << "the paper bounds no acceleration";
  EXPECT_EQ(problem.targets[10].weight, Eigen::Vector3d(25.0, 25.0, 0.1 + 0.05));
  EXPECT_EQ(problem.regions[1].count, 1);
  EXPECT_EQ(problem.num_obstacles, 1);
  EXPECT_EQ(problem.obstacles[0].keep_out[0], 0.8);
  EXPECT_NEAR((problem.obstacles[0].position[10] - Eigen::Vector2d(1.5, 1.0)).norm(), 0.0, 1e-12);
}

TEST(PaperProblem, AccelerationLimitsBecomeChangeBounds) {
  ControlProblem problem;
  set_from_settings(MpcSettings{}, RobotSettings{}, Twist2{}, problem);
  EXPECT_DOUBLE_EQ(problem.max_change.linear, 0.2);
  EXPECT_DOUBLE_EQ(problem.max_change.angular, 0.4);
}

}  // namespace
}  // namespace fairway
