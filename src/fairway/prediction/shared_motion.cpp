// SPDX-License-Identifier: Apache-2.0
#include "fairway/prediction/shared_motion.hpp"

namespace fairway {

namespace {

bool all_finite(const SampledMotion& motion) noexcept {
  if (!std::isfinite(motion.start) || !(motion.interval > 0.0) || motion.count < 1 ||
      motion.count > SampledMotion::kMaxSamples) {
    return false;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(motion.count); ++i) {
    if (!motion.positions[i].allFinite()) return false;
  }
  return std::isfinite(motion.interval);
}

bool all_finite(const UpcomingWaypoints& way) noexcept {
  if (way.count < 0 || way.count > UpcomingWaypoints::kMaxPoints) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(way.count); ++i) {
    if (!way.points[i].allFinite()) return false;
  }
  return true;
}

// Divided last, so that the result is the number nearest to a short decimal one.
double rounded(double value) noexcept {
  constexpr double kPerMetre = 1.0 / kToldQuantum;
  return std::round(value * kPerMetre) / kPerMetre;
}

template <typename Points>
void round_points(Points& points, int count) noexcept {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    points[i] = {rounded(points[i].x()), rounded(points[i].y())};
}

}  // namespace

SharedMotion rounded(SharedMotion motion) noexcept {
  constexpr double kOff = 0.72 * kToldQuantum;  // a little more than 1 / sqrt(2)
  round_points(motion.plan.positions, motion.plan.count);
  round_points(motion.stop.positions, motion.stop.count);
  round_points(motion.way.points, motion.way.count);
  motion.radius += kOff;
  return motion;
}

bool is_finite(const SharedMotion& motion) noexcept {
  return std::isfinite(motion.time) && motion.position.allFinite() && std::isfinite(motion.speed) &&
         std::isfinite(motion.radius) && std::isfinite(motion.speed_max) &&
         std::isfinite(motion.turn_max) && motion.acceleration > 0.0 &&
         std::isfinite(motion.acceleration) && all_finite(motion.plan) && all_finite(motion.stop) &&
         all_finite(motion.way) && !std::isnan(motion.distance_to_bottleneck) &&
         !std::isnan(motion.retreat_length) && motion.roundabout.center.allFinite() &&
         std::isfinite(motion.roundabout.radius);
}

}  // namespace fairway
