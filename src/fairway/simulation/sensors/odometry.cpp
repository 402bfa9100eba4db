// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/sensors/odometry.hpp"

#include "fairway/geometry/angle.hpp"

namespace fairway {

Odometry::Odometry(const OdometryModel& model, const Pose2& start, Noise& noise)
    : scale_(1.0 + noise.uniform(-model.most_scale_error, model.most_scale_error)),
      drift_(noise.uniform(-model.most_drift, model.most_drift)),
      truth_(start),
      believed_(start) {}

void Odometry::move_to(const Pose2& pose) {
  const Eigen::Vector2d way = scale_ * inverse_transform(truth_, pose.position);
  const double turn = shortest_turn(truth_.heading, pose.heading) + drift_ * way.norm();
  believed_.position = transform(believed_, way);
  believed_.heading = wrap_to_pi(believed_.heading + turn);
  truth_ = pose;
}

}  // namespace fairway
