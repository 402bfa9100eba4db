// SPDX-License-Identifier: Apache-2.0
#include "bridge/drive_progress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway::bridge {

double remaining_length(const Path& path, const Eigen::Vector2d& position) noexcept {
  double nearest = std::numeric_limits<double>::infinity();
  double after_nearest = 0.0;  // length from the nearest point to the end
  double after = 0.0;          // length from the end of the line to the end of the path
  for (std::size_t i = path.waypoints.size(); i > 1; --i) {
    const Eigen::Vector2d& from = path.waypoints[i - 2];
    const Eigen::Vector2d line = path.waypoints[i - 1] - from;
    const double length = line_length(line);
    const double along =
        length > 0.0 ? std::clamp((position - from).dot(line) / length, 0.0, length) : 0.0;
    const Eigen::Vector2d foot = length > 0.0 ? from + line * (along / length) : from;
    const double distance = (position - foot).norm();
    if (distance < nearest) {
      nearest = distance;
      after_nearest = after + length - along;
    }
    after += length;
  }
  return after_nearest;
}

void DriveProgress::begin(double time) noexcept {
  *this = {};
  begin_ = last_ = time;
}

void DriveProgress::update(const PilotStep& step, double remaining, double time) noexcept {
  const bool recovering = step.status == NavigationStatus::Recovering;
  if (recovering && !recovering_) ++recoveries_;
  recovering_ = recovering;
  driven_ += std::abs(speed_) * std::max(0.0, time - last_);
  last_ = time;
  seconds_ = std::max(0.0, time - begin_);
  remaining_ = remaining;
  speed_ = step.command.linear;
}

double DriveProgress::seconds_left() const noexcept {
  constexpr double kLeastSpeed = 0.01;  // [m/s]
  if (seconds_ <= 0.0 || driven_ / seconds_ < kLeastSpeed) return 0.0;
  return remaining_ * seconds_ / driven_;
}

}  // namespace fairway::bridge
