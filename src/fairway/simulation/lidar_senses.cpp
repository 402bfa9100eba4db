// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/lidar_senses.hpp"

#include <limits>

namespace fairway {

LidarSenses::LidarSenses(const SensingModel& model,
                         const World& world,
                         std::size_t robot,
                         std::uint64_t seed)
    : model_(model),
      robot_(robot),
      noise_(seed),
      odometry_(model.odometry, world.robots()[robot].pose, noise_),
      next_scan_(world.time()) {}

void LidarSenses::measure(const World& world) {
  const Pose2& truth = world.robots()[robot_].pose;
  odometry_.move_to(truth);
  if (world.time() < next_scan_ - 1e-9) return;
  next_scan_ += 1.0 / model_.lidar.rate;
  world.moving_around(robot_, around_);
  const auto sensor = [this](const Pose2& robot) {
    return Pose2{.position = transform(robot, model_.lidar.mount), .heading = robot.heading};
  };
  Pending scan{.taken = world.time(),
               .known = world.time() + model_.lidar.latency,
               .sensor = sensor(odometry_.pose()),
               .robot = odometry_.pose().position,
               .ranges = {}};
  scan_surroundings(model_.lidar, world.obstacles(), around_, sensor(truth), noise_, scan.ranges);
  pending_.push_back(std::move(scan));
}

MeasuredPose::MeasuredPose(const Scenario& scenario, const World& world, std::size_t robot)
    : robot_(robot) {
  if (scenario.sensing.pose == PoseSource::Exact) return;
  senses_.emplace(scenario.sensing, world, robot, scenario.seed + robot);
  localization_.emplace(scenario.map, scenario.settings.perception);
  localization_->set_pose(senses_->pose(), world.robots()[robot].pose);
}

double MeasuredPose::next_measurement() const noexcept {
  return senses_ ? senses_->next_scan() : std::numeric_limits<double>::infinity();
}

void MeasuredPose::measure(const World& world) {
  if (senses_) senses_->measure(world);
}

void MeasuredPose::locate(double time) {
  if (!senses_) return;
  senses_->deliver(time, [this](const LidarScan& scan, const Eigen::Vector2d& /*position*/) {
    localization_->observe(scan);
  });
}

Pose2 MeasuredPose::pose(const World& world) const noexcept {
  return senses_ ? localization_->locate(senses_->pose()).pose : world.robots()[robot_].pose;
}

}  // namespace fairway
