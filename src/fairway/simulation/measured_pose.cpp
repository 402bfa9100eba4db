// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/measured_pose.hpp"

#include <limits>

namespace fairway {

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
