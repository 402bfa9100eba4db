// SPDX-License-Identifier: Apache-2.0
#include "bridge/sensing/robot_senses.hpp"

namespace fairway::bridge {

namespace {

constexpr double kNever = -1e9;  // [s]; time of a missing measurement

}  // namespace

void RobotSenses::add_odometry(double time, const Pose2& pose, const PlanarTwist& twist) {
  odometry_.add(time, pose, {.linear = twist.linear, .angular = twist.angular});
  twist_ = twist;
}

void RobotSenses::set_localisation(const Pose2& odometry_in_map, double time) {
  localisation_ = odometry_in_map;
  localisation_time_ = time;
}

Pose2 RobotSenses::in_world(const Pose2& pose) const {
  return options_.use_map ? compose(*localisation_, pose) : pose;
}

std::optional<Pose2> RobotSenses::pose() const {
  if (odometry_.empty() || (options_.use_map && !localisation_)) return std::nullopt;
  return in_world(odometry_.pose());
}

std::optional<PlacedScan> RobotSenses::place(const LidarScan& scan,
                                             double duration,
                                             const Pose2& sensor_on_robot) const {
  if (!options_.use_scan || (options_.use_map && !localisation_)) return std::nullopt;
  const std::optional<Pose2> first = odometry_.at(scan.time - duration);
  const std::optional<Pose2> last = odometry_.at(scan.time);
  if (!first || !last) return std::nullopt;
  PlacedScan placed{.in_odometry = scan, .in_world = scan, .position = in_world(*last).position};
  placed.in_odometry.first_pose = compose(*first, sensor_on_robot);
  placed.in_odometry.last_pose = compose(*last, sensor_on_robot);
  placed.in_world.first_pose = in_world(placed.in_odometry.first_pose);
  placed.in_world.last_pose = in_world(placed.in_odometry.last_pose);
  return placed;
}

Measurements RobotSenses::measure(double time) {
  seen_ = board_.collect(time);
  Measurements measured{.time = time,
                        .pose_time = kNever,
                        .obstacles = seen_.obstacles,
                        .obstacles_time = seen_.time,
                        .obstacles_due = board_.has_detectors(),
                        .robot = options_.robot};
  if (options_.use_scan && !scanned_) measured.map_time = kNever;
  if (const std::optional<Pose2> now = pose()) {
    measured.pose = *now;
    if (options_.use_map) measured.fleet = fleet_.around(now->position, time);
    if (!is_lost(time)) measured.pose_time = odometry_.time();
  }
  return measured;
}

}  // namespace fairway::bridge
