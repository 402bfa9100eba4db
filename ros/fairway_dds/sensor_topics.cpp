// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/sensor_topics.hpp"

#include <cstdio>
#include <limits>
#include <utility>

#include "bridge/message_conversions.hpp"
#include "fairway_dds/dds_conversions.hpp"

namespace fairway::dds {

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr int kManyFrames = 100;  // messages between two calls, from all robots

}  // namespace

SensorTopics::SensorTopics(Participant& participant, const SensorOptions& options)
    : options_(options),
      odometry_(participant, "odom", kSensor),
      scan_(participant, "scan", kSensor),
      obstacles_(participant, "obstacles", kSensor),
      transforms_(participant, "/tf", {.depth = kManyFrames}),
      static_transforms_(
          participant, "/tf_static", {.transient_local = true, .depth = kManyFrames}) {}

std::string SensorTopics::world_frame() const {
  return options_.use_map ? options_.map_frame : odometry_frame_;
}

std::optional<Pose2> SensorTopics::find_frame(const std::string& frame) const {
  const auto found = frames_.find(world_frame(), frame);
  return found ? std::optional(found->pose) : std::nullopt;
}

bool SensorTopics::take(bridge::SensorReceiver& robot) {
  static_transforms_.take([this](const auto& message) { take_transform(message, true); });
  transforms_.take([this](const auto& message) { take_transform(message, false); });
  odometry_.take([&](const nav_msgs_msg_dds__Odometry_& message) {
    odometry_frame_ = message.header.frame_id;
    robot.add_odometry(seconds_of(message.header.stamp), bridge::to_pose(message.pose.pose),
                       bridge::to_planar_twist(message.twist.twist));
  });
  update_localisation(robot);
  bool used = false;
  scan_.take([&](const auto& message) { used = take_scan(message, robot) || used; });
  obstacles_.take([&](const auto& message) { take_obstacles(message, robot); });
  return used;
}

void SensorTopics::take_transform(const tf2_msgs_msg_dds__TFMessage_& message, bool is_static) {
  for (const geometry_msgs_msg_dds__TransformStamped_& link : elements(message.transforms)) {
    frames_.set(link.header.frame_id, link.child_frame_id,
                bridge::transform_to_pose(link.transform),
                is_static ? kForever : seconds_of(link.header.stamp));
  }
}

void SensorTopics::update_localisation(bridge::SensorReceiver& robot) const {
  if (!options_.use_map || odometry_frame_.empty()) return;
  if (const auto found = frames_.find(options_.map_frame, odometry_frame_))
    robot.set_localisation(found->pose, found->time);
}

bool SensorTopics::take_scan(const sensor_msgs_msg_dds__LaserScan_& message,
                             bridge::SensorReceiver& robot) {
  const auto mount = frames_.find(options_.base_frame, message.header.frame_id);
  if (!mount || !options_.use_scan) return false;
  const ScanInput input = to_scan(message);
  return robot.add_scan(input.scan, input.duration, mount->pose);
}

void SensorTopics::take_obstacles(const sensor_msgs_msg_dds__PointCloud2_& message,
                                  bridge::SensorReceiver& robot) {
  Expected<std::vector<MovingObstacle>> read = to_obstacles(message);
  const auto frame = find_frame(message.header.frame_id);
  if (!read) std::fprintf(stderr, "fairway: %s\n", read.error().message.c_str());
  if (!read || !frame) return;
  for (MovingObstacle& obstacle : *read) {
    obstacle.position = transform(*frame, obstacle.position);
    obstacle.velocity = rotated(obstacle.velocity, frame->heading);
  }
  robot.board().set_detections(
      "obstacles", {.obstacles = *std::move(read), .time = seconds_of(message.header.stamp)});
}

}  // namespace fairway::dds
