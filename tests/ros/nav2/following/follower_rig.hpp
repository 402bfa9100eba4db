// SPDX-License-Identifier: Apache-2.0
// Nav2 without Nav2: a robot in a true world, a local costmap that moves with it, and the frame of
// a path that may jump.
#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

#include "bridge/sensing/pose_history.hpp"
#include "fairway/simulation/world.hpp"
#include "nav2_fairway_controller/costmap_conversion.hpp"
#include "nav2_fairway_controller/path_follower.hpp"
#include "support/worlds/self_approaching_paths.hpp"

namespace fairway::nav2 {

/// The part of nav2_costmap_2d::Costmap2D that to_obstacles uses.
struct Costmap {
  unsigned int width = 0;
  unsigned int height = 0;
  double resolution = 0.05;
  double origin_x = 0.0;
  double origin_y = 0.0;
  std::vector<unsigned char> cells;

  [[nodiscard]] unsigned int getSizeInCellsX() const { return width; }
  [[nodiscard]] unsigned int getSizeInCellsY() const { return height; }
  [[nodiscard]] double getResolution() const { return resolution; }
  [[nodiscard]] double getOriginX() const { return origin_x; }
  [[nodiscard]] double getOriginY() const { return origin_y; }
  [[nodiscard]] const unsigned char* getCharMap() const { return cells.data(); }
};

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
};
struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};
struct PoseMessage {
  Vector3 position;
  Quaternion orientation;
};
struct StampedPose {
  int header = 0;
  PoseMessage pose;
};
struct PathMessage {
  int header = 7;
  std::vector<StampedPose> poses;
};

/// Drives a robot along paths with a PathFollower. The costmap's frame is that of the world; the
/// path's frame is at `frame` in it.
struct Rig {
  explicit Rig(const Scenario& scenario, const FollowerSettings& settings = {})
      : world(scenario),
        follower(settings),
        period(settings.robot.navigation.control_period) {}

  /// A free hall of 12 m x 6 m, with walls at its edges only.
  static Scenario free_hall(const Pose2& start) {
    Scenario scenario;
    scenario.map = OccupancyGrid({.width = 240, .height = 120, .resolution = 0.05, .origin = {}});
    scenario.robots = {{.name = "robot", .start = start, .goal = {}}};
    return scenario;
  }

  /// The hall with two posts.
  static Scenario hall() {
    Scenario scenario = free_hall({.position = {1, 3}, .heading = 0});
    block(scenario, {4.0, 2.5}, {4.5, 3.0});
    block(scenario, {7.5, 3.0}, {8.0, 3.5});
    return scenario;
  }

  /// Adds a box between two corners on the grid of 0.05 m.
  static void block(Scenario& scenario, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    const CellIndex last = scenario.map.frame().cell_at(high - Eigen::Vector2d(0.01, 0.01));
    const CellIndex first = scenario.map.frame().cell_at(low + Eigen::Vector2d(0.01, 0.01));
    for (int x = first.x; x <= last.x; ++x) {
      for (int y = first.y; y <= last.y; ++y)
        scenario.map.set({x, y}, CellState::Occupied);
    }
  }

  /// Poses every 0.05 m along lines.
  static Path dense(const std::vector<Eigen::Vector2d>& corners) {
    PathMessage message;
    fill_path({.waypoints = corners}, {}, 0.05, message);
    return to_path(message);
  }

  static Path path() { return dense({{1, 3}, {4, 4}, {7.5, 2.2}, {11, 3}}); }

  [[nodiscard]] const UnicycleRobot& robot() const { return world.robots()[0]; }

  /// The window of 6 m around the robot, as in a rolling costmap.
  [[nodiscard]] BitGrid window() const {
    const Eigen::Vector2d center = robot().pose.position;
    const Eigen::Vector2d corner =
        (((center - Eigen::Vector2d(3, 3)) / 0.05).array().round() * 0.05).matrix();
    Costmap costmap{.width = 120, .height = 120, .origin_x = corner.x(), .origin_y = corner.y()};
    costmap.cells.resize(std::size_t{120} * 120, 0);
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x) {
        const Eigen::Vector2d at = corner + 0.05 * Eigen::Vector2d(x + 0.5, y + 0.5);
        const bool blocked = world.obstacles().blocked(world.obstacles().frame().cell_at(at));
        costmap.cells[static_cast<std::size_t>(y * 120 + x)] = blocked ? kLethal : 0;
      }
    }
    return to_obstacles(costmap, UnknownCells::Occupied);
  }

  FollowerStep step() {
    BitGrid obstacles = window();
    Pose2 shifted = obstacles.frame().origin;
    shifted.position += offset;
    obstacles.move_to(shifted);
    const Pose2 pose{.position = robot().pose.position + offset, .heading = robot().pose.heading};
    const double now = world.time();
    const FollowerStep answer = follower.update({.time = now,
                                                 .pose = pose,
                                                 .pose_time = now,
                                                 .twist = robot().twist,
                                                 .obstacles = obstacles,
                                                 .obstacles_time = costmap_alive ? now : -1e9,
                                                 .moving = board,
                                                 .path_frame = frame,
                                                 .goal = goal});
    track.push_back(robot().pose.position);
    const double change = std::abs(answer.command.linear - last_speed);
    greatest_change = std::max(greatest_change, change);
    last_speed = answer.command.linear;
    if (answer.fault != FollowerFault::None) ++faults;
    world.advance({answer.command}, period);
    return answer;
  }

  FollowerStep drive(double seconds) {
    FollowerStep last;
    for (const double until = world.time() + seconds;
         world.time() < until && last.status != NavigationStatus::GoalReached;) {
      last = step();
    }
    return last;
  }

  /// Returns the share of the path's poses that the robot missed by more than `bound` [m], in the
  /// order of the path. A pose counts as met only at the time of those before it or soon after.
  [[nodiscard]] double missed(const Path& given, double bound) const {
    return test::missed_share(given, track, bound);
  }

  World world;
  PathFollower follower;
  double period;
  bridge::ObstacleBoard board;
  bool costmap_alive = true;
  std::optional<Pose2> frame = Pose2{};
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();  // of poses and costmap from the world [m]
  std::optional<GoalTolerance> goal;
  std::vector<Eigen::Vector2d> track;
  double last_speed = 0.0;
  double greatest_change = 0.0;  // of the linear command between two cycles [m/s]
  int faults = 0;
};

}  // namespace fairway::nav2
