// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fairway/geometry/pose2.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

namespace {

constexpr double kLargest = 20.0;       // radius of a robot [m]
constexpr double kFastest = 100.0;      // [m/s] and [m/s^2]
constexpr double kMostTurning = 100.0;  // [rad/s]
constexpr double kWidest = 100.0;       // roundabout [m]
constexpr double kLongestStep = 10.0;   // between two samples [s]

// Written so that NaN is outside.
bool is_within(double value, double least, double most) noexcept {
  return value >= least && value <= most;
}

template <typename Points>
bool are_plausible(const Points& points, int count) noexcept {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (!is_plausible(points[i])) return false;
  }
  return true;
}

bool is_plausible(const SampledMotion& motion) noexcept {
  return std::isfinite(motion.start) && motion.interval > 0.0 && motion.interval <= kLongestStep &&
         motion.count >= 1 && motion.count <= SampledMotion::kMaxSamples &&
         are_plausible(motion.positions, motion.count);
}

bool is_plausible(const SharedOutline& outline) noexcept {
  if (!(outline.low.cwiseAbs().maxCoeff() <= kLargest) ||
      !(outline.high.cwiseAbs().maxCoeff() <= kLargest) ||
      !(outline.low.x() <= outline.high.x() && outline.low.y() <= outline.high.y()))
    return false;
  const auto finite = [](double heading) { return std::isfinite(heading); };
  return std::all_of(outline.plan_headings.begin(), outline.plan_headings.end(), finite) &&
         std::all_of(outline.stop_headings.begin(), outline.stop_headings.end(), finite);
}

bool is_plausible(const UpcomingWaypoints& way) noexcept {
  return way.count >= 0 && way.count <= UpcomingWaypoints::kMaxPoints &&
         are_plausible(way.points, way.count);
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
  motion.outline.low.array() -= kOff;
  motion.outline.high.array() += kOff;
  return motion;
}

bool is_plausible(const SharedMotion& motion) noexcept {
  return std::isfinite(motion.time) && is_plausible(motion.position) &&
         is_within(motion.speed, 0.0, kFastest) && is_within(motion.radius, 0.0, kLargest) &&
         is_within(motion.speed_max, 0.0, kFastest) &&
         is_within(motion.turn_max, 0.0, kMostTurning) && motion.acceleration > 0.0 &&
         motion.acceleration <= kFastest && is_plausible(motion.plan) &&
         is_plausible(motion.stop) && is_plausible(motion.way) && is_plausible(motion.outline) &&
         !std::isnan(motion.distance_to_bottleneck) && !std::isnan(motion.retreat_length) &&
         is_plausible(motion.roundabout.center) &&
         is_within(motion.roundabout.radius, 0.0, kWidest);
}

}  // namespace fairway
