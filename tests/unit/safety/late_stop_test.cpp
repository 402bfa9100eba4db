// SPDX-License-Identifier: Apache-2.0
// A stop that was proven keeps free of a wall whatever cycles of it are early or late.
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/safety/safe_stop.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kRadius = 0.3;  // [m]

// A half-plane of obstacles, at a distance from the robot in a direction.
struct Wall {
  Vector2d robot;
  double bearing;   // of its normal, towards the wall [rad]
  double distance;  // [m]

  [[nodiscard]] BitGrid grid() const {
    constexpr int kCells = 80;
    constexpr double kFree = 50.0;  // cells, of 1 m
    const Vector2d local(kFree - distance, 0.5 * kCells);
    const Pose2 turned{.position = {0, 0}, .heading = bearing};
    BitGrid obstacles({.width = kCells,
                       .height = kCells,
                       .resolution = 1.0,
                       .origin = {robot - transform(turned, local), bearing}},
                      false);
    for (int y = 0; y < kCells; ++y) {
      for (int x = static_cast<int>(kFree); x < kCells; ++x)
        obstacles.set({.x = x, .y = y}, true);
    }
    return obstacles;
  }

  [[nodiscard]] double clearance(const Vector2d& at) const {
    return distance - kRadius - (at - robot).dot(direction(bearing));
  }
};

// A base, what is known of it, and its commands, at times that are not regular.
class IrregularDrive {
 public:
  IrregularDrive(test::Random& random, bool late_base) : random_(random) {
    robot_.radius = kRadius;
    robot_.linear_max = random.uniform(0.3, 3.0);
    robot_.angular_max = random.uniform(0.5, 2.5);
    robot_.linear_acceleration_max = random.uniform(0.3, 3.0);
    robot_.angular_acceleration_max = random.uniform(0.6, 6.0);
    if (late_base) {
      robot_.linear_delay = random.uniform(0.0, 0.6);
      robot_.angular_delay = random.uniform(0.0, 0.6);
    }
    period_ = random.uniform(0.03, 0.2);
    jitter_ = random.uniform(0.0, 0.45);
    lost_ = random.uniform(0.0, 0.3);
    longest_ = (2.0 + jitter_) * period_;
    base_.limits = limits_of(robot_);
    actuation_ = actuation_of(robot_);
  }

  // Some cycles of random commands, and the beginning of the next.
  void drive_on() {
    constexpr int kCycles = 40;
    for (int k = 0; k < kCycles; ++k) {
      begin();
      finish(drawn());
    }
    begin();
  }

  // A command that is proven, with the wall as near as that allows; false where there is none.
  [[nodiscard]] bool prove_beside_a_wall(Wall& wall) {
    const Twist2 command = drawn();
    wall = {.robot = base_.pose.position,
            .bearing = base_.pose.heading + random_.uniform(-1.5, 1.5),
            .distance = 0.0};
    double refused = kRadius;
    double proven = 0.0;
    constexpr int kHalvings = 24;
    for (double distance = 20.0, step = 10.0; step > 20.0 / (1 << kHalvings); step *= 0.5) {
      wall.distance = distance;
      const BitGrid obstacles = wall.grid();
      (takes(obstacles, command) ? proven : refused) = distance;
      distance = 0.5 * (proven == 0.0 ? distance + step : proven + refused);
    }
    if (proven == 0.0 || proven > 19.0) return false;
    wall.distance = proven;
    const BitGrid obstacles = wall.grid();
    if (!takes(obstacles, command)) return false;
    finish(command);
    return true;
  }

  // The stop, until standstill. Returns the least clearance on it.
  [[nodiscard]] double stop_beside(const Wall& wall) {
    double least = wall.clearance(base_.pose.position);
    watched_ = &wall;
    least_ = &least;
    const double end = time_ + 30.0;
    while (time_ < end && (base_.twist.linear != 0.0 || base_.twist.angular != 0.0 || moves_)) {
      begin();
      const Twist2 command = stop_.next();
      moves_ = command.linear != 0.0 || command.angular != 0.0;
      finish(command);
    }
    watched_ = nullptr;
    return least;
  }

 private:
  [[nodiscard]] double next_interval() {
    double interval = period_ * (1.0 + random_.uniform(-jitter_, jitter_));
    if (random_.chance(lost_)) interval += period_;
    return std::min(interval, longest_);
  }

  [[nodiscard]] Twist2 drawn() {
    const Twist2 wanted{.linear = random_.uniform(0.0, robot_.linear_max),
                        .angular = random_.uniform(-1.0, 1.0) * robot_.angular_max};
    return limited_change(sent_, wanted, robot_, step_);
  }

  // As a Navigator does it.
  void begin() {
    const double elapsed = next_interval();
    if (began_) move(elapsed);
    began_ = true;
    step_ = std::min(elapsed, period_);
    current_ = history_.reached(time_);
    advance(response_, history_, actuation_, time_ - elapsed, time_);
    stop_.begin_cycle(elapsed, step_);
  }

  void finish(const Twist2& command) {
    const auto ramp = [&](double from, double to, const AxisActuation& axis) {
      const double change = change_time(from, to, axis);
      return change > step_ * (1.0 + 1e-9) ? change : step_;
    };
    history_.send(time_, command,
                  {.linear = ramp(current_.linear, command.linear, actuation_.linear),
                   .angular = ramp(current_.angular, command.angular, actuation_.angular)});
    sent_ = command;
  }

  void move(double duration) {
    constexpr double kFine = 1e-3;  // [s]
    const int steps = 1 + static_cast<int>(duration / kFine);
    for (int i = 0; i < steps; ++i) {
      base_.advance(sent_, duration / steps);
      if (watched_ != nullptr)
        *least_ = std::min(*least_, watched_->clearance(base_.pose.position));
    }
    time_ += duration;
  }

  [[nodiscard]] bool takes(const BitGrid& obstacles, const Twist2& command) {
    const StopSituation now{.pose = base_.pose,
                            .current = current_,
                            .around = {.obstacles = &obstacles,
                                       .body = Footprint::disc(kRadius),
                                       .static_margin = 0.002,
                                       .moving = {}},
                            .irregular = true,
                            .shortest_interval = (1.0 - jitter_) * period_,
                            .response = &response_,
                            .history = &history_,
                            .time = time_};
    return stop_.take(now, {&command, 1});
  }

  test::Random& random_;
  RobotSettings robot_;
  BaseActuation actuation_;
  double period_ = 0.1;
  double jitter_ = 0.0;
  double lost_ = 0.0;
  double longest_ = 0.1;
  UnicycleRobot base_;
  CommandHistory history_;
  BaseResponse response_;
  Twist2 sent_;
  Twist2 current_;
  double time_ = 0.0;
  double step_ = 0.1;
  bool began_ = false;
  bool moves_ = true;
  const Wall* watched_ = nullptr;
  double* least_ = nullptr;

 public:
  SafeStop stop_{robot_, 0.1};
  void start() { stop_ = SafeStop(robot_, period_, longest_); }
};

void expect_no_contact(bool late_base) {
  test::Random random(11);
  int proven = 0;
  for (int trial = 0; trial < 300; ++trial) {
    IrregularDrive drive(random, late_base);
    drive.start();
    drive.drive_on();
    Wall wall{};
    if (!drive.prove_beside_a_wall(wall)) continue;
    ++proven;
    EXPECT_GE(drive.stop_beside(wall), 0.0) << trial;
  }
  EXPECT_GT(proven, 200);
}

TEST(LateStop, KeepsFreeOfAWallWhicheverCyclesAreLate) { expect_no_contact(false); }

TEST(LateStop, KeepsFreeOfAWallWithADelayToo) { expect_no_contact(true); }

}  // namespace
}  // namespace fairway
