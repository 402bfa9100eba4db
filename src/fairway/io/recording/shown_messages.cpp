// SPDX-License-Identifier: Apache-2.0
// The messages of a run that are for display only.
#include <algorithm>
#include <array>

#include "fairway/io/recording/foxglove_json.hpp"
#include "fairway/io/recording/message_text.hpp"
#include "fairway/io/recording/run_messages.hpp"

namespace fairway::io {

namespace {

constexpr double kMapPeriod = 1.0;        // least time between two writes of a changing map [s]
constexpr std::size_t kShownTracks = 12;  // moving obstacles estimated by a robot with a lidar

// Returns the true pose of a frame in which a robot estimates its pose as `believed` while its true
// pose is `truth`.
Pose2 frame_pose(const Pose2& truth, const Pose2& believed) {
  const double turn = truth.heading - believed.heading;
  const Pose2 turned{.position = Eigen::Vector2d::Zero(), .heading = turn};
  return {.position = truth.position - transform(turned, believed.position), .heading = turn};
}

}  // namespace

void RunMessages::show_robot(foxglove::Scene& scene,
                             const std::string& name,
                             const Pose2& pose) const {
  constexpr double kHeight = 0.3;  // [m]
  constexpr foxglove::Tint kBlue{.red = 0.0, .green = 0.45, .blue = 0.7};
  const Footprint body = footprint_of(body_);
  if (body.is_rectangle()) scene.box(name, pose, body_.length, body_.width, kHeight, kBlue);
  for (int i = 0; i < body.num_discs(); ++i) {
    const Footprint::Disc& disc = body.disc_at(i);
    const std::string id = i == 0 ? name : name + " disc " + std::to_string(i + 1);
    scene.disc(id, transform(pose, disc.center), disc.radius, kHeight, kBlue);
  }
  scene.arrow(name + " heading", pose, 1.4 * body_.radius, {.red = 0.1, .green = 0.1, .blue = 0.1});
}

void RunMessages::show_map(double time, const BitGrid& obstacles) {
  if (time < shown_time_ + kMapPeriod || !sink_.wants(map_)) return;
  bool changed = false;
  const GridFrame& frame = obstacles.frame();
  for (int y = 0; y < frame.height; ++y) {
    if (std::ranges::equal(shown_obstacles_.row(y), obstacles.row(y))) continue;
    changed = true;
    for (int x = 0; x < frame.width; ++x) {
      const bool blocked = obstacles.blocked({.x = x, .y = y});
      if (blocked == shown_obstacles_.blocked({.x = x, .y = y})) continue;
      shown_cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
                   static_cast<std::size_t>(x)] = blocked ? kOccupiedCell : kFreeCell;
    }
  }
  if (!changed) return;
  shown_obstacles_ = obstacles;
  shown_time_ = time;
  write(map_, time, dumped(foxglove::grid(nanoseconds(time), frame, shown_cells_)));
}

void RunMessages::show_plan(double time, const Robot& robot, const Plan& plan) {
  foxglove::Scene scene(nanoseconds(time), robot.frame);
  scene.line("path", plan.path.waypoints, {.red = 0.0, .green = 0.62, .blue = 0.45});
  scene.outlines("corridor", plan.corridor.rectangles,
                 {.red = 0.34, .green = 0.71, .blue = 0.91, .opacity = 0.6});
  scene.disc("goal", plan.goal.position, 0.1, 0.02, {.red = 0.0, .green = 0.62, .blue = 0.45});
  write(robot.way, time, dumped(scene.json()));
}

void RunMessages::show_seen_map(Robot& robot, const NavigationCycle& cycle) {
  const double time = cycle.input.time;
  if (time < robot.map_shown + kMapPeriod || !sink_.wants(robot.map)) return;
  robot.map_shown = time;
  const GridFrame& frame = cycle.input.map->frame();
  std::string cells;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const CellIndex cell{.x = x, .y = y};
      cells.push_back(!cycle.input.map->blocked(cell) ? kFreeCell
                      : cycle.occupied->blocked(cell) ? kOccupiedCell
                                                      : kUnknownCell);
    }
  }
  write(robot.map, time, dumped(foxglove::grid(nanoseconds(time), frame, cells, robot.frame)));
}

void RunMessages::show_cycle(Robot& robot, const NavigationCycle& cycle) {
  const double time = cycle.input.time;
  const std::uint64_t stamp = nanoseconds(time);
  const Pose2& pose = cycle.input.pose;
  if (sink_.wants(robot.pose))
    write(robot.pose, time, dumped(foxglove::pose_in_frame(stamp, pose, robot.frame)));
  if (sink_.wants(tf_)) {
    if (lidar_ && cycle.robot < true_poses_.size()) {
      const Pose2 frame = frame_pose(true_poses_[cycle.robot], pose);
      write(tf_, time, dumped(foxglove::frame_transform(stamp, robot.frame, frame)));
    }
    write(tf_, time, dumped(foxglove::frame_transform(stamp, robot.name, pose, robot.frame)));
  }
  if (cycle.occupied != nullptr && cycle.input.map != nullptr) show_seen_map(robot, cycle);
  if (!sink_.wants(robot.scene)) return;

  foxglove::Scene scene(stamp, robot.frame);
  for (std::size_t i = 0; lidar_ && i < kShownTracks; ++i) {
    const std::string id = "track " + std::to_string(i);
    if (i >= cycle.input.obstacles.size()) {
      scene.remove(id);
      continue;
    }
    const MovingObstacle& track = cycle.input.obstacles[i];
    scene.disc(id, track.position, track.radius, 0.5,
               {.red = 0.9, .green = 0.6, .blue = 0.0, .opacity = 0.5});
  }
  std::vector<Eigen::Vector2d> points;
  if (const MpcSolution* plan = cycle.step.plan) {
    for (int k = 0; k <= plan->horizon; ++k)
      points.push_back(plan->poses[static_cast<std::size_t>(k)].position);
  }
  scene.line("prediction", points, {.red = 0.8, .green = 0.47, .blue = 0.65});
  const Corridor& corridor = plans_[cycle.robot].corridor;
  if (cycle.step.rectangle < corridor.rectangles.size()) {
    const OrientedRectangle current = corridor.admissible(cycle.step.rectangle);
    scene.outlines("current rectangle", std::span(&current, 1),
                   {.red = 0.0, .green = 0.45, .blue = 0.7});
  }
  constexpr foxglove::Tint kLimiting{.red = 0.85, .green = 0.1, .blue = 0.1};
  scene.remove("limit");
  if (cycle.mark.shape == LimitMark::Shape::Side) {
    scene.line("limit", std::array{cycle.mark.a, cycle.mark.b}, kLimiting);
  } else if (cycle.mark.shape == LimitMark::Shape::Disc) {
    scene.disc("limit", cycle.mark.a, cycle.mark.radius, 0.02,
               {.red = 0.85, .green = 0.1, .blue = 0.1, .opacity = 0.4});
  }
  write(robot.scene, time, dumped(scene.json()));
}

}  // namespace fairway::io
