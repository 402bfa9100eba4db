// SPDX-License-Identifier: Apache-2.0
#include "synthetic_run.hpp"

#include <cmath>
#include <numbers>

#include "fairway/geometry/angle.hpp"

namespace fairway::test {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kPeriod = 30.0;  // of a round [s]

Pose2 pose_at(double time, double phase, const Eigen::Vector2d& center, double radius) {
  const double angle = phase + kTurn * time / kPeriod;
  return {.position = center + radius * direction(angle),
          .heading = wrap_to_pi(angle + 0.5 * std::numbers::pi)};
}

Plan plan_along(double time, double phase, const Eigen::Vector2d& center, double radius) {
  Plan plan;
  plan.path_status = PathStatus::Found;
  plan.corridor_status = CorridorStatus::Built;
  plan.corridor.robot_radius = 0.25;
  plan.margin = 0.02;
  for (int i = 0; i < 8; ++i) {
    const Pose2 pose = pose_at(time + 2.0 * i, phase, center, radius);
    plan.path.waypoints.push_back(pose.position);
    plan.corridor.rectangles.push_back({.seed = pose.position,
                                        .orientation = pose.heading,
                                        .min = {-0.5, -0.4},
                                        .max = {0.3 * radius, 0.4}});
  }
  plan.goal = {.position = plan.path.waypoints.back(), .heading = 0.5};
  return plan;
}

}  // namespace

Scenario SyntheticRun::scenario() const {
  Scenario scenario;
  scenario.name = "synthetic";
  if (rectangular) scenario.settings.robot = {.radius = 0.37, .length = 0.6, .width = 0.4};
  const GridFrame frame{.width = map_side,
                        .height = map_side,
                        .resolution = 0.05,
                        .origin = {.position = {-1.0, 0.5}, .heading = 0.0}};
  scenario.map = OccupancyGrid(frame);
  for (int i = 0; i < map_side; ++i) {
    for (const CellIndex cell :
         {CellIndex{.x = i, .y = 0}, CellIndex{.x = 0, .y = i},
          CellIndex{.x = i, .y = map_side - 1}, CellIndex{.x = map_side - 1, .y = i}}) {
      scenario.map.set(cell, CellState::Occupied);
    }
    scenario.map.set({.x = i, .y = map_side / 2},
                     i % 7 == 0 ? CellState::Unknown : CellState::Free);
  }
  for (int i = 0; i < robots; ++i) {
    scenario.robots.push_back({.name = "robot " + std::to_string(i), .start = {}, .goal = {}});
  }
  for (int i = 0; i < bodies; ++i) {
    scenario.bodies.push_back({.name = "person " + std::to_string(i),
                               .radius = 0.3,
                               .key_frames = {{.time = 0.0, .position = {1.0, 1.0 + i}}},
                               .loop = false});
  }
  return scenario;
}

void SyntheticRun::play(EpisodeObserver& observer) const {
  const Scenario all = scenario();
  const double side = map_side * all.map.frame().resolution;
  const Eigen::Vector2d center =
      all.map.frame().origin.position + Eigen::Vector2d::Constant(0.5 * side);
  const double radius = 0.35 * side;
  BitGrid obstacles(all.map);
  // The first robot uses its own map, and estimates a person who does not exist.
  BitGrid seen(all.map.frame(), false);
  for (int x = 0; x < map_side / 2; ++x)
    seen.set({.x = x, .y = map_side / 3}, true);
  observer.on_start(all);
  observer.on_navigators(0.0, all.settings, std::vector<NavigatorStart>(all.robots.size()));
  MpcSolution solution;
  solution.horizon = all.settings.mpc.horizon;
  solution.iterations = 5;
  solution.limiting = {.kind = ConstraintKind::Corridor, .step = 3, .index = 1};
  const auto phase = [&](std::size_t i) { return kTurn * static_cast<double>(i) / robots; };
  for (int cycle = 0; cycle * 0.1 <= seconds; ++cycle) {
    const double time = cycle * 0.1;
    if (cycle % 10 == 5)
      obstacles.set({.x = (20 + cycle) % map_side, .y = 30 % map_side}, cycle % 20 == 5);
    std::vector<UnicycleRobot> bases;
    for (std::size_t i = 0; i < all.robots.size(); ++i)
      bases.push_back({.pose = pose_at(time, phase(i), center, radius), .twist = {}, .limits = {}});
    std::vector<MovingObstacle> moving;
    for (int i = 0; i < bodies; ++i)
      moving.push_back({.position = center + Eigen::Vector2d(std::sin(time / 3.0 + i), 0.3 * i),
                        .velocity = {std::cos(time / 3.0 + i) / 3.0, 0.0},
                        .radius = 0.3});
    const std::vector<Encounter> encounters(bases.size(),
                                            {.min_clearance = 1.0, .min_separation = 1.0});
    observer.on_world({.time = time,
                       .obstacles = &obstacles,
                       .bodies = moving,
                       .robots = bases,
                       .encounters = encounters});
    for (std::size_t i = 0; i < all.robots.size(); ++i) {
      if (cycle % 50 == 0) observer.on_plan(time, i, plan_along(time, phase(i), center, radius));
      for (int k = 0; k <= solution.horizon; ++k)
        solution.poses[static_cast<std::size_t>(k)] =
            pose_at(time + 0.1 * k, phase(i), center, radius);
      const Pose2& pose = bases[i].pose;
      std::vector<MovingObstacle> believed = moving;
      if (i == 0) believed.push_back({.position = center, .velocity = {0.1, 0.0}, .radius = 0.2});
      observer.on_cycle(
          {.robot = i,
           .input = {.time = time,
                     .pose = pose,
                     .pose_time = time,
                     .obstacles = believed,
                     .obstacles_time = time,
                     .map = i == 0 ? &seen : &obstacles,
                     .map_time = time},
           .step = {.command = {.linear = 0.8 + 0.2 * std::sin(time), .angular = kTurn / kPeriod},
                    .status = cycle % 40 < 30 ? NavigationStatus::Ok : NavigationStatus::Degraded,
                    .limit = LimitingFactor::Corridor,
                    .wants_plan = false,
                    .rectangle = static_cast<std::size_t>(cycle % 50 / 20),
                    .plan = &solution},
           .twist = {.linear = 0.8 + 0.2 * std::sin(time - 0.1), .angular = kTurn / kPeriod},
           .clearance = 0.5 + 0.4 * std::cos(time / 2.0),
           .seconds = 60e-6,
           .mark = {.shape = LimitMark::Shape::Side,
                    .row = solution.limiting,
                    .a = pose.position,
                    .b = pose.position + direction(pose.heading),
                    .radius = 0.0}});
    }
  }
}

}  // namespace fairway::test
