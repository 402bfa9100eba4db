// SPDX-License-Identifier: Apache-2.0
#include "results/run_animation.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/body_outline.hpp"
#include "fairway/io/drawing/animation.hpp"
#include "fairway/io/drawing/world_legend.hpp"

namespace fairway::app {

namespace {

using Eigen::Vector2d;

constexpr double kLongest = 12.0;  // of a loop [s]
constexpr std::size_t kMostFrames = 180;

// The outline of a robot as polygons in its own frame; none for a single disc in its centre.
std::vector<std::vector<Vector2d>> outline_of(const Scenario& scenario, const RobotTask& robot) {
  if (robot.model) return outlines_of(robot.model->body);
  std::vector<std::vector<Vector2d>> polygons;
  const RobotSettings& body = scenario.settings.robot;
  if (body.length > 0.0 && body.width > 0.0 && body.discs.count == 0) {
    const Vector2d half(0.5 * body.length, 0.5 * body.width);
    polygons = {{half, {-half.x(), half.y()}, -half, {half.x(), -half.y()}}};
  }
  return polygons;
}

}  // namespace

void RunAnimation::on_world(const WorldView& world) {
  Moment& moment = moments_.emplace_back();
  moment.time = world.time;
  moment.bodies.assign(world.bodies.begin(), world.bodies.end());
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const bool absent = world.encounters[i].absent;
    moment.robots.push_back(absent ? std::nullopt : std::optional(world.robots[i].pose));
  }
}

Expected<std::string> RunAnimation::draw(const Scenario& scenario,
                                         const EpisodeResult& result) const {
  io::Animation animation{
      .world = {.map = &scenario.map, .robots = {}, .bodies = {}, .zones = scenario.zones},
      .region = {},
      .moving = {}};
  const std::size_t every = 1 + moments_.size() / kMostFrames;
  std::size_t most_bodies = 0;
  for (const Moment& moment : moments_)
    most_bodies = std::max(most_bodies, moment.bodies.size());
  std::vector<io::MovingDrawing> people(most_bodies, {.color = io::palette::kPurple});
  std::vector<io::MovingDrawing> robots;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const RobotTask& task = scenario.robots[i];
    animation.world.robots.push_back({.name = task.name,
                                      .radius = scenario.settings.robot.radius,
                                      .start = task.start,
                                      .goal = task.goal.position,
                                      .path = result.robots[i].plan.path,
                                      .corridor = {},
                                      .track = {}});
    robots.push_back({.color = io::colors_of(i, scenario.robots.size()).track,
                      .radius = scenario.settings.robot.radius,
                      .outline = outline_of(scenario, task),
                      .heading = true});
  }
  io::WorldDrawing driven = animation.world;
  for (std::size_t k = 0; k < moments_.size(); k += every) {
    const Moment& moment = moments_[k];
    for (std::size_t i = 0; i < robots.size(); ++i) {
      robots[i].poses.push_back(moment.robots[i]);
      if (moment.robots[i]) driven.robots[i].track.push_back(*moment.robots[i]);
    }
    for (std::size_t i = 0; i < most_bodies; ++i) {
      const bool there = i < moment.bodies.size();
      if (there) people[i].radius = moment.bodies[i].radius;
      people[i].poses.push_back(there ? std::optional(Pose2{.position = moment.bodies[i].position})
                                      : std::nullopt);
    }
  }
  animation.region = shown_region(driven);
  animation.moving = std::move(people);
  animation.moving.insert(animation.moving.end(), robots.begin(), robots.end());
  animation.interval = static_cast<double>(every) * scenario.settings.navigation.control_period;
  animation.pace = std::max(1.0, std::ceil(2.0 * result.time / kLongest) / 2.0);
  return io::draw_animation(animation);
}

}  // namespace fairway::app
