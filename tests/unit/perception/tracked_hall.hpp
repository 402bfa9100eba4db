// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/perception/perception.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/odometry.hpp"
#include "support/random/random_world.hpp"

namespace fairway::test {

/// A hall of 24 m with posts, a noisy lidar, discs that move at the given velocities, and a robot.
class Hall {
 public:
  explicit Hall(std::uint64_t seed)
      : obstacles_(GridFrame{.width = 480,
                             .height = 480,
                             .resolution = 0.05,
                             .origin = {.position = {-12, -12}, .heading = 0.0}},
                   false),
        noise_(seed),
        perception_(settings(), {0, 0}) {
    lidar_.range_sigma = 0.01;
    lidar_.dropout = 0.01;
  }

  static PerceptionSettings settings() { return {}; }

  void put_post(const Eigen::Vector2d& at, double radius) {
    const GridFrame& frame = obstacles_.frame();
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        if ((frame.center({x, y}) - at).norm() < radius) obstacles_.set({x, y}, true);
      }
    }
  }

  const Perception& scan(const std::vector<MovingObstacle>& discs, const Pose2& robot) {
    return scan(discs, robot, robot);
  }

  // @param believed  Pose of the robot by odometry.
  const Perception& scan(const std::vector<MovingObstacle>& discs,
                         const Pose2& robot,
                         const Pose2& believed) {
    const auto sensor = [&](const Pose2& at) {
      return Pose2{.position = transform(at, lidar_.mount), .heading = at.heading};
    };
    scan_surroundings(lidar_, obstacles_, discs, sensor(robot), noise_, ranges_);
    const LidarScan scan{.time = time_,
                         .first_pose = sensor(believed),
                         .last_pose = sensor(believed),
                         .first_angle = -0.5 * lidar_.field_of_view,
                         .angle_step = lidar_.field_of_view / (lidar_.beams - 1),
                         .min_range = lidar_.min_range,
                         .max_range = lidar_.max_range,
                         .ranges = ranges_};
    perception_.observe(scan, believed.position, 0.3);
    time_ += 0.05;
    return perception_;
  }

  [[nodiscard]] double time() const { return time_; }

 private:
  BitGrid obstacles_;
  LidarModel lidar_;
  Noise noise_;
  Perception perception_;
  std::vector<float> ranges_;
  double time_ = 0.0;
};

/// A disc of 0.5 m that moves evenly.
inline MovingObstacle disc_at(double time,
                              const Eigen::Vector2d& start,
                              const Eigen::Vector2d& velocity) {
  return {.position = start + time * velocity, .velocity = velocity, .radius = 0.5};
}

}  // namespace fairway::test
