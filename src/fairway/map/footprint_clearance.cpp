// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/footprint_clearance.hpp"

#include <algorithm>

#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

constexpr double kResolution = 1e-4;  // [m], of the bisection

// Finds the largest value in [low, high] for which `holds` is true. @pre holds(low).
template <typename Predicate>
double bisect(double low, double high, Predicate&& holds) noexcept {
  while (high - low > kResolution) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

bool is_free(const BitGrid& obstacles,
             const Footprint& footprint,
             const Pose2& pose,
             double clearance) noexcept {
  if (footprint.is_rectangle()) {
    return is_free(obstacles, footprint.rectangle_at(pose), clearance, ZoneSubject::Body);
  }
  for (int i = 0; i < footprint.num_discs(); ++i) {
    const Footprint::Disc& disc = footprint.disc_at(i);
    const Eigen::Vector2d center = transform(pose, disc.center);
    if (!is_free(obstacles, center, center, disc.radius + clearance, ZoneSubject::Body))
      return false;
  }
  return true;
}

double footprint_clearance(const BitGrid& obstacles,
                           const Footprint& footprint,
                           const Pose2& pose,
                           double limit) noexcept {
  if (!footprint.is_rectangle()) {
    double least = limit;
    for (int i = 0; i < footprint.num_discs(); ++i) {
      const Footprint::Disc& disc = footprint.disc_at(i);
      const double distance = distance_to_blocked(obstacles, transform(pose, disc.center),
                                                  disc.radius + limit, ZoneSubject::Body);
      least = std::min(least, distance - disc.radius);
    }
    return least;
  }
  const OrientedRectangle body = footprint.rectangle_at(pose);
  const auto keeps = [&](const OrientedRectangle& rectangle, double clearance) {
    return is_free(obstacles, rectangle, clearance, ZoneSubject::Body);
  };
  if (keeps(body, 0.0)) {
    if (keeps(body, limit)) return limit;
    return bisect(0.0, limit, [&](double c) { return keeps(body, c); });
  }
  const double most = 0.5 * (body.max - body.min).maxCoeff();
  return -bisect(0.0, most, [&](double shrink) {
    return !keeps(footprint.shrunk(shrink).rectangle_at(pose), 0.0);
  }) - kResolution;
}

}  // namespace fairway
