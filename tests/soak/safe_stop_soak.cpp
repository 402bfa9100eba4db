// SPDX-License-Identifier: Apache-2.0
// Drives through random worlds with inputs that are dropped, late, displaced or not finite, and
// counts all violations. Exit code 1 if there are any.
//
//   safe_stop_soak [CYCLES [SEED]]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "faults.hpp"
#include "support/random/free_poses.hpp"

namespace {

using namespace fairway;
using test::Random;

struct Count {
  long cycles = 0;
  long worlds = 0;
  long faults = 0;
  long arrivals = 0;
  long static_contacts = 0;
  long driven_into = 0;   // the robot drove into a moving obstacle at its measured position
  long run_over = 0;      // such an obstacle hit the robot at standstill or while it moved away
  long not_as_told = 0;   // contacts soon after wrong obstacle positions were measured
  long bad_commands = 0;  // not finite, too fast, or changed too much
  double metres = 0.0;

  [[nodiscard]] bool good() const { return static_contacts + driven_into + bad_commands == 0; }
};

class World {
 public:
  World(std::uint64_t seed, Count& count)
      : random_(seed),
        faults_(random_),
        count_(count),
        map_(test::random_world(random_, 220)) {
    settings_.robot.radius = random_.uniform(0.12, 0.35);
    if (random_.chance(0.3)) {
      settings_.robot.length = 1.5 * settings_.robot.radius;
      settings_.robot.width = 1.2 * settings_.robot.radius;
    }
    if (random_.chance(0.3)) settings_.robot.linear_min = -0.4;
    if (random_.chance(0.3)) settings_.robot.linear_max = 2.0;
  }

  void drive(int cycles, long stop_at) {
    if (!set_up()) return;
    ++count_.worlds;
    for (int k = 0; k < cycles && count_.cycles < stop_at; ++k) {
      if (!cycle()) break;
    }
    count_.faults += faults_.count();
  }

 private:
  bool set_up() {
    const double room = settings_.robot.radius + 0.05;
    const auto start = test::random_free_pose(random_, map_.obstacles, room);
    if (!start) return false;
    robot_.pose = *start;
    robot_.limits = {.linear_acceleration = settings_.robot.linear_acceleration_max,
                     .angular_acceleration = settings_.robot.angular_acceleration_max};
    const Eigen::Vector2d size =
        map_.obstacles.frame().resolution *
        Eigen::Vector2d(map_.obstacles.frame().width, map_.obstacles.frame().height);
    for (int i = random_.integer(0, 4); i > 0; --i) {
      MovingObstacle obstacle{
          .position = robot_.pose.position + Eigen::Vector2d(random_.uniform(-1, 1) * size.x(),
                                                             random_.uniform(-1, 1) * size.y()),
          .velocity = random_.uniform(0.0, 1.2) * direction(random_.uniform(-3.2, 3.2)),
          .radius = random_.uniform(0.1, 0.4)};
      if ((obstacle.position - robot_.pose.position).norm() > 2.5) obstacles_.push_back(obstacle);
    }
    navigator_ = std::make_unique<Navigator>(settings_);
    return new_goal();
  }

  bool new_goal() {
    const auto goal =
        test::random_free_pose(random_, map_.obstacles, settings_.robot.radius + 0.05);
    if (!goal) return false;
    goal_ = {.position = goal->position, .heading = {}};
    plan();
    return true;
  }

  void plan() {
    navigator_->follow(
        planner_.plan(map_, robot_.pose.position, goal_, planner_settings(settings_)));
  }

  bool cycle() {
    ++count_.cycles;
    faults_.begin_cycle(0.05);
    const NavigationInput input =
        faults_.tell({.time = time_, .pose = robot_.pose, .obstacles = obstacles_}, map_.obstacles);
    const NavigationStep step = navigator_->update(input);
    check_command(step.command);
    sent_ = step.command;
    const bool free = move(step.command);
    if (step.status == NavigationStatus::GoalReached) {
      ++count_.arrivals;
      return free && new_goal();
    }
    if (step.wants_plan) plan();
    if (step.status == NavigationStatus::NoPlan) return free && new_goal();
    return free;
  }

  void check_command(const Twist2& command) {
    constexpr double kRounding = 1e-9;
    const RobotSettings& robot = settings_.robot;
    const double period = settings_.navigation.control_period;
    const bool good = is_finite(command) && command.linear <= robot.linear_max + kRounding &&
                      command.linear >= robot.linear_min - kRounding &&
                      std::abs(command.angular) <= robot.angular_max + kRounding &&
                      std::abs(command.linear - sent_.linear) <=
                          robot.linear_acceleration_max * period + kRounding &&
                      std::abs(command.angular - sent_.angular) <=
                          robot.angular_acceleration_max * period + kRounding;
    if (!good) report("command out of limits", ++count_.bad_commands);
  }

  // Runs one cycle at fine steps. Returns whether there was no contact.
  bool move(const Twist2& command) {
    constexpr int kSteps = 20;
    const double h = settings_.navigation.control_period / kSteps;
    const Footprint body = footprint_of(settings_.robot);
    for (int i = 0; i < kSteps; ++i) {
      const Pose2 before = robot_.pose;
      robot_.advance(command, h);
      time_ += h;
      count_.metres += (robot_.pose.position - before.position).norm();
      for (MovingObstacle& obstacle : obstacles_)
        obstacle.position += h * obstacle.velocity;
      if (!is_free(map_.obstacles, body, robot_.pose, 0.0)) {
        report("contact with a static obstacle", ++count_.static_contacts);
        return false;
      }
      for (const MovingObstacle& obstacle : obstacles_) {
        if (body.distance(inverse_transform(robot_.pose, obstacle.position)) >= obstacle.radius) {
          continue;
        }
        judge(obstacle);
        return false;
      }
    }
    return true;
  }

  void judge(const MovingObstacle& obstacle) {
    const Eigen::Vector2d towards = (obstacle.position - robot_.pose.position).normalized();
    const double closing = robot_.twist.linear * direction(robot_.pose.heading).dot(towards);
    if (faults_.told_wrong_tracks(time_, 3.0)) {
      ++count_.not_as_told;
    } else if (closing > 0.05) {
      report("drove into a moving obstacle", ++count_.driven_into);
    } else {
      ++count_.run_over;
    }
  }

  void report(const char* what, long number) const {
    if (number <= 10) std::printf("%s: world %ld, time %.3f\n", what, count_.worlds, time_);
  }

  Random random_;
  test::Faults faults_;
  Count& count_;
  PreparedMap map_;
  Settings settings_;
  Planner planner_;
  std::unique_ptr<Navigator> navigator_;
  UnicycleRobot robot_;
  std::vector<MovingObstacle> obstacles_;
  Goal goal_;
  Twist2 sent_;
  double time_ = 0.0;
};

}  // namespace

int main(int argc, char** argv) {
  const long cycles = argc > 1 ? std::atol(argv[1]) : 10000;
  const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atol(argv[2]) : 1);
  constexpr int kCyclesPerWorld = 500;
  Count count;
  for (std::uint64_t world = 0; count.cycles < cycles; ++world)
    World(seed * 1000003 + world, count).drive(kCyclesPerWorld, cycles);
  std::printf(
      "%ld cycles, %ld worlds, %ld faults, %ld goals reached, %.0f m driven\n"
      "contacts with static obstacles: %ld\ndriven into moving obstacles: %ld\n"
      "commands out of limits: %ld\n"
      "not counted: hit %ld times at standstill or while moving away, %ld contacts within 3 s of "
      "wrong obstacle positions\n",
      count.cycles, count.worlds, count.faults, count.arrivals, count.metres, count.static_contacts,
      count.driven_into, count.bad_commands, count.run_over, count.not_as_told);
  return count.good() ? 0 : 1;
}
