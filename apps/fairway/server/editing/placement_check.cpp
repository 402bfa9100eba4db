// SPDX-License-Identifier: Apache-2.0
#include "server/editing/placement_check.hpp"

#include <fmt/core.h>

#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway::app {

namespace {

constexpr double kClearanceReach = 1.0;  // [m]

// Explains why a body at `pose` touches a robot or another body; empty if it does not.
std::string contact_reason(const World& world,
                           const Footprint& body,
                           const Pose2& pose,
                           std::optional<std::size_t> ignored,
                           bool with_bodies) {
  const double radius = world.footprint().circumscribed_radius();
  for (std::size_t i = 0; i < world.robots().size(); ++i) {
    if (i == ignored || world.encounters()[i].absent) continue;
    const Eigen::Vector2d& other = world.robots()[i].pose.position;
    if (body.distance(inverse_transform(pose, other)) < radius) return "A robot is already here.";
  }
  if (!with_bodies) return {};
  for (std::size_t i = 0; i < world.num_bodies(); ++i) {
    if (!world.body(i).is_there(world.time())) continue;
    const MovingObstacle now = world.body(i).at(world.time());
    if (body.distance(inverse_transform(pose, now.position)) < now.radius)
      return fmt::format("{} is here.", world.body(i).name);
  }
  return {};
}

}  // namespace

std::string off_map_reason(const World& world, const Eigen::Vector2d& point) {
  const GridFrame& frame = world.obstacles().frame();
  if (frame.contains(frame.cell_at(point))) return {};
  return fmt::format("({:.2f}, {:.2f}) is outside the map.", point.x(), point.y());
}

std::string robot_refusal(const World& world,
                          const Pose2& pose,
                          std::optional<std::size_t> ignored) {
  if (std::string reason = off_map_reason(world, pose.position); !reason.empty()) return reason;
  const double clearance =
      footprint_clearance(world.obstacles(), world.footprint(), pose, kClearanceReach);
  if (clearance < 0.0) {
    return fmt::format("The robot does not fit here: its body overlaps an obstacle by {:.2f} m.",
                       -clearance);
  }
  return contact_reason(world, world.footprint(), pose, ignored, true);
}

std::string person_refusal(const World& world,
                           const Eigen::Vector2d& point,
                           double radius,
                           bool on_robots) {
  if (std::string reason = off_map_reason(world, point); !reason.empty()) return reason;
  const double clearance = distance_to_blocked(world.obstacles(), point, kClearanceReach);
  if (clearance < radius) {
    return fmt::format(
        "A person does not fit here: the nearest obstacle is {:.2f} m away, {:.2f} m are needed.",
        clearance, radius);
  }
  if (on_robots) return {};
  return contact_reason(world, Footprint::disc(radius), {.position = point, .heading = 0.0}, {},
                        false);
}

}  // namespace fairway::app
