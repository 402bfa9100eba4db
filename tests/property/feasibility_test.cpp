// SPDX-License-Identifier: Apache-2.0
// The theorems of docs/feasibility.md, with solvers that break every promise but the hard
// constraints: what is proven must not depend on what the solver answers.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/free_poses.hpp"
#include "support/runs/idle_solver.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

// Random commands within the hard constraints, often fast and held for long: the worst answers that
// a solver may give.
class RecklessSolver final : public ControlSolver {
 public:
  explicit RecklessSolver(std::uint64_t seed) : random_(seed) {}

  const MpcSolution& solve(const ControlProblem& problem,
                           const InitialGuess& /*guess*/) noexcept override {
    solution_ = MpcSolution{};
    solution_.status = SolveStatus::Solved;
    solution_.horizon = problem.horizon;
    if (random_.chance(0.1)) {
      aim_ = {
          .linear = random_.chance(0.7) ? problem.command_max.linear : random_.uniform(-1.0, 1.0),
          .angular = random_.uniform(-2.0, 2.0)};
    }
    Twist2 last = problem.previous_command;
    Pose2 pose = problem.start;
    solution_.poses[0] = pose;
    for (int k = 0; k < problem.horizon; ++k) {
      last = {.linear = bounded(aim_.linear, last.linear, problem.max_change.linear,
                                problem.command_min.linear, problem.command_max.linear),
              .angular = bounded(aim_.angular, last.angular, problem.max_change.angular,
                                 problem.command_min.angular, problem.command_max.angular)};
      pose = step(pose, last, problem.dt, problem.integration);
      solution_.commands[static_cast<std::size_t>(k)] = last;
      solution_.poses[static_cast<std::size_t>(k) + 1] = pose;
    }
    return solution_;
  }

 private:
  static double bounded(double aim, double last, double change, double low, double high) {
    return std::clamp(std::clamp(aim, last - change, last + change), low, high);
  }

  test::Random random_;
  Twist2 aim_;
  MpcSolution solution_;
};

// A robot in a random world with a plan to a random goal.
struct Drive {
  PreparedMap map;
  Settings settings;
  UnicycleRobot robot;
  std::optional<Navigator> navigator;
  std::vector<MovingObstacle> obstacles;
  double time = 0.0;

  NavigationStep cycle() {
    const double period = settings.navigation.control_period;
    const NavigationStep result = navigator->update({.time = time,
                                                     .pose = robot.pose,
                                                     .pose_time = time,
                                                     .obstacles = obstacles,
                                                     .obstacles_time = time,
                                                     .map = &map.obstacles,
                                                     .map_time = time});
    robot.advance(result.command, period);
    for (MovingObstacle& obstacle : obstacles)
      obstacle.position += period * obstacle.velocity;
    time += period;
    return result;
  }

  [[nodiscard]] bool is_free(double radius) const {
    return fairway::is_free(map.obstacles, robot.pose.position, robot.pose.position, radius);
  }
};

// None where the world has no two free places, or no path between them.
bool start_in_random_world(std::uint64_t seed, ControlSolver& solver, Drive& drive) {
  test::Random random(seed);
  drive.settings.robot.radius = random.uniform(0.1, 0.3);
  drive.settings.robot.linear_max = random.uniform(0.5, 2.0);
  drive.settings.robot.linear_min = -0.3;
  drive.settings.robot.linear_acceleration_max = random.uniform(0.5, 2.0);
  drive.map = PreparedMap(BitGrid(test::random_world(random, 200)));
  const double clear = drive.settings.robot.radius + 0.05;
  const auto start = test::random_free_pose(random, drive.map.obstacles, clear);
  const auto goal = test::random_free_pose(random, drive.map.obstacles, clear);
  if (!start || !goal) return false;
  drive.robot.pose = *start;
  drive.robot.limits = limits_of(drive.settings.robot);
  Planner planner;
  Plan plan = planner.plan(drive.map, start->position, {.position = goal->position, .heading = {}},
                           planner_settings(drive.settings));
  if (!plan.usable()) return false;
  drive.navigator.emplace(drive.settings, solver);
  drive.navigator->follow(std::move(plan));
  return true;
}

// Theorem 1: braking alone meets the hard constraints of the next cycle, whatever was sent, and
// every command that is sent meets them.
TEST(Feasibility, EveryCommandLeavesTheNextProblemFeasible) {
  int cycles = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RecklessSolver solver(seed);
    Drive drive;
    if (!start_in_random_world(seed, solver, drive)) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (int k = 0; k < 200; ++k, ++cycles) {
      static_cast<void>(drive.cycle());
      const ControlProblem& problem = drive.navigator->problem();
      const Twist2& c = problem.previous_command;
      ASSERT_LE(c.linear, problem.command_max.linear + problem.max_change.linear + 1e-9);
      ASSERT_GE(c.linear, problem.command_min.linear - problem.max_change.linear - 1e-9);
      ASSERT_LE(problem.command_min.linear, problem.command_max.linear);
      ASSERT_LE(std::abs(c.angular), problem.command_max.angular + 1e-9);
      ASSERT_GT(problem.max_change.linear, 0.0);
      ASSERT_GT(problem.max_change.angular, 0.0);
    }
  }
  EXPECT_GT(cycles, 2000);
}

// Theorem 2: no static obstacle is touched, whatever the solver answers.
TEST(Feasibility, NoAnswerOfASolverTouchesAStaticObstacle) {
  double driven = 0.0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    RecklessSolver solver(seed);
    Drive drive;
    if (!start_in_random_world(seed, solver, drive)) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (int k = 0; k < 400; ++k) {
      const Vector2d before = drive.robot.pose.position;
      static_cast<void>(drive.cycle());
      driven += (drive.robot.pose.position - before).norm();
      ASSERT_TRUE(drive.is_free(drive.settings.robot.radius)) << "after " << drive.time << " s";
    }
  }
  EXPECT_GT(driven, 100.0);
}

// Theorem 3: without progress the robot says within a bounded time that it is blocked.
TEST(Feasibility, ARobotWithoutProgressSaysSo) {
  // Rounds of recovery, each of all actions with their time limits and the time to notice.
  constexpr double kBound = 4 * (4.0 + 15.0 + 1.5 + 1.5 + 10.0) + 60.0;  // [s]
  int runs = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    test::IdleSolver solver;
    Drive drive;
    if (!start_in_random_world(seed, solver, drive)) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    ++runs;
    double silent = 0.0;  // since the robot moved, arrived or gave a reason
    Vector2d last = drive.robot.pose.position;
    for (; drive.time < 400.0 && silent <= kBound;) {
      const NavigationStep result = drive.cycle();
      const bool moved = (drive.robot.pose.position - last).norm() > 0.05;
      if (moved) last = drive.robot.pose.position;
      const bool stated = result.status != NavigationStatus::Ok;
      silent = moved || stated ? 0.0 : silent + drive.settings.navigation.control_period;
      if (result.status == NavigationStatus::GoalReached) break;
    }
    EXPECT_LE(silent, kBound);
  }
  EXPECT_GT(runs, 10);
}

// Theorem 4: a robot that moves does not touch obstacles that keep their velocity. One that was
// caught at standstill may be touched, also while it tries to escape; then the run is over.
TEST(Feasibility, NoObstacleThatKeepsItsVelocityIsDrivenInto) {
  double driven = 0.0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    RecklessSolver solver(seed);
    test::Random random(seed + 1000);
    Drive drive;
    drive.settings.robot.radius = 0.3;
    drive.map = PreparedMap(
        BitGrid(GridFrame{.width = 200, .height = 200, .resolution = 0.1, .origin = {}}, false));
    drive.robot.pose = {.position = {10.0, 10.0}, .heading = random.uniform(-3.0, 3.0)};
    drive.robot.limits = limits_of(drive.settings.robot);
    for (int i = 0; i < 6; ++i) {
      const double angle = random.uniform(-3.14, 3.14);
      drive.obstacles.push_back(
          {.position = Vector2d(10.0, 10.0) + random.uniform(3.0, 8.0) * direction(angle),
           .velocity = random.uniform(0.0, 1.2) * direction(random.uniform(-3.14, 3.14)),
           .radius = 0.3});
    }
    Planner planner;
    drive.navigator.emplace(drive.settings, solver);
    drive.navigator->follow(planner.plan(drive.map, {10.0, 10.0},
                                         {.position = {18.0, 18.0}, .heading = {}},
                                         planner_settings(drive.settings)));
    SCOPED_TRACE("seed " + std::to_string(seed));
    bool caught = false;
    for (int k = 0; k < 150 && !caught; ++k) {
      const Vector2d before = drive.robot.pose.position;
      const NavigationStep result = drive.cycle();
      driven += (drive.robot.pose.position - before).norm();
      const bool evades = result.status == NavigationStatus::Degraded &&
                          result.limit == LimitingFactor::MovingObstacle;
      const bool stands = std::abs(drive.robot.twist.linear) < 0.02;
      for (const MovingObstacle& obstacle : drive.obstacles) {
        const double gap = (obstacle.position - drive.robot.pose.position).norm() -
                           obstacle.radius - drive.settings.robot.radius;
        caught = caught || evades || (gap < 0.0 && stands);
        ASSERT_TRUE(caught || gap > -1e-6) << "after " << drive.time << " s";
      }
    }
  }
  EXPECT_GT(driven, 50.0);
}

// Theorem 5: a faster obstacle that pursues the robot touches it, with the real solver and the plan
// in space and time. A test that no contact happens needs an assumption about the obstacles.
TEST(Feasibility, AFasterPursuerTouchesTheRobot) {
  constexpr double kGain = 0.5;  // of the pursuer on the robot [m/s]
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    Drive drive;
    drive.settings.robot.radius = 0.3;
    drive.settings.robot.linear_min = -0.5;
    drive.map = PreparedMap(
        BitGrid(GridFrame{.width = 400, .height = 400, .resolution = 0.1, .origin = {}}, false));
    drive.robot.pose = {.position = {20.0, 20.0}, .heading = random.uniform(-3.0, 3.0)};
    drive.robot.limits = limits_of(drive.settings.robot);
    const double away = random.uniform(2.0, 5.0);
    drive.obstacles = {
        {.position = Vector2d(20.0, 20.0) + away * direction(random.uniform(-3.14, 3.14)),
         .velocity = Vector2d::Zero(),
         .radius = 0.3}};
    drive.navigator.emplace(drive.settings);
    drive.navigator->follow(Planner().plan(drive.map, {20.0, 20.0},
                                           {.position = {36.0, 36.0}, .heading = {}},
                                           planner_settings(drive.settings)));
    MovingObstacle& pursuer = drive.obstacles.front();
    bool touched = false;
    while (!touched && drive.time < away / kGain + 1.0) {
      const Vector2d to_robot = drive.robot.pose.position - pursuer.position;
      pursuer.velocity = (drive.settings.robot.linear_max + kGain) * to_robot.normalized();
      drive.cycle();
      touched = (drive.robot.pose.position - pursuer.position).norm() <
                pursuer.radius + drive.settings.robot.radius;
    }
    EXPECT_TRUE(touched);
  }
}

}  // namespace
}  // namespace fairway
