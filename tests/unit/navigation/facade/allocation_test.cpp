// SPDX-License-Identifier: Apache-2.0
// Cycles of both facades in which no plan is made or taken over: with a fleet, people and scans.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/noise.hpp"
#include "support/runs/allocation_guard.hpp"

namespace fairway {
namespace {

// Two rooms with a door of 1 m, in which robots cannot pass each other.
OccupancyGrid hall() {
  OccupancyGrid map({.width = 240, .height = 100, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 100; ++y) {
    if (y < 40 || y >= 60) map.set({120, y}, CellState::Occupied);
  }
  return map;
}

// Other users of the hall. Robots come through the door, and an obstacle crosses behind it; or
// people cross the path in front of the door.
enum class Others { Robots, People };

class Traffic {
 public:
  explicit Traffic(Others others) : motions_(others == Others::Robots ? 3 : 0) {
    if (others == Others::People) {
      obstacles_ = {{.position = {5.0, 4.5}, .velocity = {-0.2, -0.5}, .radius = 0.3},
                    {.position = {4.0, 0.5}, .velocity = {0.1, 0.4}, .radius = 0.3}};
    }
    for (const MovingObstacle& obstacle : obstacles_)
      starts_.push_back(obstacle.position);
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      SharedMotion& motion = motions_[i];
      motion.robot = static_cast<std::uint32_t>(i + 1);
      motion.radius = 0.25;
      motion.speed_max = 1.0;
      motion.acceleration = 2.0;
      motion.turn_max = 1.5;
      motion.speed = kSpeed;
      motion.under_way = true;
      motion.can_step_aside = i == 0;
      motion.way.count = 2;
      motion.way.points[0] = {6.0, 2.5};
      motion.way.points[1] = {1.0, 1.0 + static_cast<double>(i)};
      fleet_.push_back({.motion = &motion});
    }
  }

  void advance(double time) {
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      SharedMotion& motion = motions_[i];
      motion.time = time;
      motion.position = {std::max(6.5, 8.5 + static_cast<double>(i) - kSpeed * time), 2.5};
      motion.stop.start = time;
      motion.stop.count = 0;
      motion.stop.add(motion.position);
      motion.plan = motion.stop;
    }
    for (std::size_t i = 0; i < obstacles_.size(); ++i)
      obstacles_[i].position = starts_[i] + time * obstacles_[i].velocity;
  }

  [[nodiscard]] Fleet fleet() const { return fleet_; }
  [[nodiscard]] MovingObstacles obstacles() const { return obstacles_; }

 private:
  static constexpr double kSpeed = 0.4;  // [m/s]
  std::vector<SharedMotion> motions_;
  std::vector<FleetMember> fleet_;
  std::vector<MovingObstacle> obstacles_{
      {.position = {9.5, 1.0}, .velocity = {0.0, 0.2}, .radius = 0.3}};
  std::vector<Eigen::Vector2d> starts_;  // of the obstacles
};

// What happened in the cycles of a run.
struct Cycles {
  int without_plan = 0;      // cycles that neither made nor took over a plan
  bool met_a_robot = false;  // whether another robot was considered
  Pose2 end;                 // of the robot
};

// Drives `navigator` for 15 s. `sense` is called in each cycle, and counted.
template <typename Navigator>
Cycles drive(Navigator& navigator,
             const std::function<void(double, const Pose2&)>& sense,
             Others others = Others::Robots) {
  Cycles result;
  Traffic traffic(others);
  Pose2 robot{.position = {1.5, 2.5}, .heading = 0.0};
  for (int cycle = 0; cycle < 150; ++cycle) {
    const double time = 0.1 * cycle;
    traffic.advance(time);
    const test::AllocationGuard guard;
    sense(time, robot);
    const NavigationStep now = navigator.update({.time = time,
                                                 .pose = robot,
                                                 .obstacles = traffic.obstacles(),
                                                 .fleet = traffic.fleet(),
                                                 .robot = 0});
    const SharedMotion message = navigator.share(0, time, robot);
    const std::size_t calls = guard.count();
    result.met_a_robot = result.met_a_robot || message.roundabout.exists() ||
                         std::isfinite(message.distance_to_bottleneck);
    // The first cycles reserve memory for scans.
    if (cycle > 1 && !navigator.planned() && !navigator.follows_new_plan()) {
      ++result.without_plan;
      EXPECT_EQ(calls, 0U) << "cycle " << cycle << ", " << to_text(now.status);
    }
    robot = step(robot, now.command, 0.1, Integration::Midpoint);
  }
  result.end = robot;
  return result;
}

// Makes scans of `world`. Its storage is reserved by the first one.
class Scanner {
 public:
  explicit Scanner(const BitGrid& world) : world_(world) {}

  LidarScan scan(double time, const Pose2& robot) {
    scan_surroundings(lidar_, world_, {}, robot, noise_, ranges_);
    return {.time = time,
            .first_pose = robot,
            .last_pose = robot,
            .first_angle = -0.5 * lidar_.field_of_view,
            .angle_step = lidar_.field_of_view / (lidar_.beams - 1),
            .max_range = lidar_.max_range,
            .ranges = ranges_};
  }

 private:
  BitGrid world_;
  LidarModel lidar_;
  Noise noise_{1};
  std::vector<float> ranges_;
};

const Goal kBehindTheDoor{.position = {10.5, 2.5}};

TEST(Facades, CyclesOnAMapWithAFleetAndWithoutAPlanDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  MapNavigator navigator({}, hall());
  navigator.set_goal(kBehindTheDoor);
  const Cycles cycles = drive(navigator, [](double /*time*/, const Pose2& /*robot*/) {});
  EXPECT_GT(cycles.without_plan, 100);
  EXPECT_TRUE(cycles.met_a_robot);
}

TEST(Facades, CyclesOnAMapWithScansAndWithoutAPlanDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  MapNavigator navigator({}, hall());
  navigator.set_goal(kBehindTheDoor);
  Scanner scanner{BitGrid(hall())};
  const Cycles cycles = drive(navigator, [&](double time, const Pose2& robot) {
    navigator.observe(scanner.scan(time, robot), robot.position);
  });
  EXPECT_GT(cycles.without_plan, 50);
  EXPECT_TRUE(cycles.met_a_robot);
}

TEST(Facades, CyclesWithoutAMapAndWithoutAPlanDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  MaplessNavigator navigator({}, {1.5, 2.5});
  navigator.set_goal(kBehindTheDoor);
  Scanner scanner{BitGrid(hall())};
  const Cycles cycles = drive(navigator, [&](double time, const Pose2& robot) {
    navigator.observe(scanner.scan(time, robot), robot.position);
  });
  EXPECT_GT(cycles.without_plan, 50);
  EXPECT_TRUE(cycles.met_a_robot);
}

// Settings with and without the plan in space and time. Where it acts, the robot ends elsewhere.
Settings among_people(double space_time_horizon) {
  Settings settings;
  settings.tracking.space_time_horizon = space_time_horizon;
  return settings;
}

TEST(Facades, CyclesOnAMapAmongPeopleDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  const auto run = [](double space_time_horizon) {
    MapNavigator navigator(among_people(space_time_horizon), hall());
    navigator.set_goal(kBehindTheDoor);
    return drive(
        navigator, [](double /*time*/, const Pose2& /*robot*/) {}, Others::People);
  };
  const Cycles cycles = run(6.0);
  EXPECT_GT(cycles.without_plan, 100);
  EXPECT_NE(cycles.end.position, run(0.0).end.position) << "no plan in space and time was made";
}

TEST(Facades, CyclesWithoutAMapAmongPeopleDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  const auto run = [](double space_time_horizon) {
    MaplessNavigator navigator(among_people(space_time_horizon), {1.5, 2.5});
    navigator.set_goal(kBehindTheDoor);
    Scanner scanner{BitGrid(hall())};
    const auto sense = [&](double time, const Pose2& robot) {
      navigator.observe(scanner.scan(time, robot), robot.position);
    };
    return drive(navigator, sense, Others::People);
  };
  const Cycles cycles = run(6.0);
  EXPECT_GT(cycles.without_plan, 50);
  EXPECT_NE(cycles.end.position, run(0.0).end.position) << "no plan in space and time was made";
}

TEST(Facades, CyclesWithZonesAndOnHoldDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  MapNavigator navigator({}, hall());
  navigator.set_goal(kBehindTheDoor);
  navigator.set_zones(
      {{.kind = ZoneKind::KeepOut, .polygon = {{3, 1}, {4, 1}, {4, 2}}},
       {.kind = ZoneKind::Strip,
        .polygon = {{0.1, 0.1}, {11.9, 0.1}, {11.9, 4.9}, {0.1, 4.9}},
        .reference = ZoneReference::Centre},
       {.kind = ZoneKind::SpeedLimit, .polygon = {{2, 0}, {5, 0}, {5, 5}, {2, 5}}, .speed = 0.4},
       {.kind = ZoneKind::OneWay, .polygon = {{7, 0}, {8, 0}, {8, 5}, {7, 5}}, .direction = 0.0}});
  const Cycles cycles = drive(navigator, [&](double time, const Pose2& /*robot*/) {
    time > 5.0 && time < 6.0 ? navigator.hold() : navigator.resume();
  });
  EXPECT_GT(cycles.without_plan, 50);
}

// A robot at a closed door tries again from time to time; the cycles between do not plan.
TEST(Facades, CyclesOfARobotWithoutAPathDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  OccupancyGrid closed = hall();
  for (int y = 0; y < 100; ++y)
    closed.set({120, y}, CellState::Occupied);
  MapNavigator navigator({}, closed);
  navigator.set_goal(kBehindTheDoor);
  EXPECT_GT(drive(navigator, [](double /*time*/, const Pose2& /*robot*/) {}).without_plan, 100);
}

}  // namespace
}  // namespace fairway
