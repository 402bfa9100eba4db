// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "fairway/geometry/angle.hpp"
#include "fairway/safety/base_response.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/world.hpp"

// What a contact of a run was.
namespace fairway::campaign {

using Eigen::Vector2d;

/// The classes of contacts, by this rule, which is tried from the top:
/// - `Static`: the robot touched the map.
/// - `Unpredictable`: what it touched changed its velocity within the time that the robot needs to
///   stop from its greatest speed, plus one second: it was not visible in time what it would do. By
///   lidar also: its middle was out of the lidar's view at some time within that.
/// - `RunInto`: the robot went towards it with at most 0.02 m/s: it came to the robot.
/// - `DroveInto`: all others.
enum class ContactKind : std::uint8_t { None, Static, Unpredictable, RunInto, DroveInto };

[[nodiscard]] constexpr const char* to_text(ContactKind contact) noexcept {
  switch (contact) {
    case ContactKind::None:
      return "none";
    case ContactKind::Static:
      return "static";
    case ContactKind::Unpredictable:
      return "not visible in time";
    case ContactKind::RunInto:
      return "was run into";
    case ContactKind::DroveInto:
      return "drove into it";
  }
  return "unknown";
}

/// The time that a robot needs until standstill, from its greatest speed [s].
[[nodiscard]] inline double stopping_time(const Settings& settings) {
  return settings.robot.linear_max / linear_actuation(settings.robot).braking +
         dead_time(settings.robot) +
         (1.0 + settings.safety.longest_hold) * settings.navigation.control_period;
}

/// Notes when the middle of each body was out of the lidar's view last: behind walls and others,
/// beside the field of view or too far away. Without a lidar everything is in view.
class Sight {
 public:
  explicit Sight(const Scenario& scenario)
      : lidar_(scenario.sensing.lidar),
        reach_(std::min(lidar_.max_range, scenario.settings.perception.reach)),
        looks_(scenario.sensing.sensing == Sensing::Lidar) {}

  void look(const World& world) {
    if (!looks_) return;
    hidden_at_.resize(world.num_bodies(), kNever);
    bodies_.clear();
    for (std::size_t i = 0; i < world.num_bodies(); ++i)
      bodies_.push_back(world.body(i).at(world.time()));
    const Pose2& robot = world.robots().front().pose;
    const Vector2d from = transform(robot, lidar_.mount);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Vector2d way = bodies_[i].position - from;
      const double angle = std::atan2(way.y(), way.x());
      const bool turned_to =
          std::abs(shortest_turn(robot.heading, angle)) < 0.5 * lidar_.field_of_view;
      const double front = way.norm() - bodies_[i].radius - 1e-3;
      const bool seen = turned_to && front < reach_ &&
                        cast_ray(world.obstacles(), bodies_, from, angle, reach_) >= front;
      if (!seen) hidden_at_[i] = world.time();
    }
  }

  [[nodiscard]] double hidden_at(std::size_t body) const {
    return body < hidden_at_.size() ? hidden_at_[body] : kNever;
  }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  LidarModel lidar_;
  double reach_;
  bool looks_;
  std::vector<double> hidden_at_;
  std::vector<MovingObstacle> bodies_;
};

[[nodiscard]] inline ContactKind classify(const World& world,
                                          const Settings& settings,
                                          const Sight& sight) {
  const Encounter& met = world.encounters().front();
  if (!met.collided) return ContactKind::None;
  if (met.min_clearance < 0.0) return ContactKind::Static;
  constexpr double kReaction = 1.0;  // [s]
  const double since = met.collision_time - stopping_time(settings) - kReaction;
  double nearest = std::numeric_limits<double>::infinity();
  bool changed = false;
  for (std::size_t i = 0; i < world.num_bodies(); ++i) {
    const MovingBody& body = world.body(i);
    const MovingObstacle now = body.at(met.collision_time);
    const double gap = (now.position - world.robots().front().pose.position).norm() - now.radius;
    if (!(gap < nearest)) continue;
    nearest = gap;
    changed = sight.hidden_at(i) > since;
    for (const MovingBody::KeyFrame& frame : body.key_frames) {
      if (frame.time > std::max(0.0, since) && frame.time <= met.collision_time) changed = true;
    }
  }
  if (changed) return ContactKind::Unpredictable;
  constexpr double kStill = 0.02;  // [m/s]
  return met.approach <= kStill ? ContactKind::RunInto : ContactKind::DroveInto;
}

}  // namespace fairway::campaign
