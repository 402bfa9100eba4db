// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "contacts.hpp"
#include "fairway/geometry/footprint.hpp"

namespace fairway::campaign {

/// Notes where a robot goes nearer to a body than docs/safety.md states.
///
/// The bound is `moving_margin`, at most `obstacle_margin`. It counts where the robot moves towards
/// a body that has moved as predicted for as long as the robot needs to stop, and one second.
class NearPass {
 public:
  explicit NearPass(const Scenario& scenario)
      : bound_(std::min(scenario.settings.safety.moving_margin,
                        scenario.settings.prediction.obstacle_margin)),
        since_(stopping_time(scenario.settings) + 1.0),
        footprint_(footprint_of(scenario.settings.robot)) {}

  /// Looks at the world at the begin of a cycle. @return whether the bound is broken now.
  [[nodiscard]] bool look(const World& world) {
    const Pose2 pose = world.robots().front().pose;
    const double time = world.time();
    bool broken = false;
    for (std::size_t i = 0; before_ && i < world.num_bodies(); ++i) {
      const MovingBody& body = world.body(i);
      const MovingObstacle now = body.at(time);
      const double gap = gap_to(world, pose, now);
      least = std::min(least, gap);
      // By the robot's own way: a long body that turns to a stop may swing nearer.
      const Pose2 turned{.position = before_->position, .heading = pose.heading};
      const double nearer = gap_to(world, turned, now) - gap;
      constexpr double kStill = 0.02;     // [m/s]
      constexpr double kRounding = 1e-3;  // [m]; bodies are linear between their frames
      if (gap < bound_ - kRounding && nearer > kStill * (time - before_->time) &&
          !changes(body, time))
        broken = true;
    }
    before_ = Known{.time = time, .position = pose.position};
    return broken;
  }

  double least = std::numeric_limits<double>::infinity();  ///< distance to a body [m]

 private:
  struct Known {
    double time = 0.0;
    Vector2d position;
  };

  [[nodiscard]] double gap_to(const World& world,
                              const Pose2& pose,
                              const MovingObstacle& body) const {
    const Vector2d local = inverse_transform(pose, body.position);
    const BodyRobot* const model = world.model_of(0);
    const double distance =
        model != nullptr ? model->model.body.distance(local) : footprint_.distance(local);
    return distance - body.radius;
  }

  [[nodiscard]] bool changes(const MovingBody& body, double time) const {
    return std::any_of(body.key_frames.begin(), body.key_frames.end(), [&](const auto& frame) {
      return frame.time > std::max(0.0, time - since_) && frame.time <= time;
    });
  }

  double bound_;
  double since_;
  Footprint footprint_;
  std::optional<Known> before_;
};

}  // namespace fairway::campaign
