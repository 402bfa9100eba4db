// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/object_disc.hpp"

#include <algorithm>

#include "fairway/perception/beam_assignment.hpp"
#include "fairway/perception/object/circle_fit.hpp"

namespace fairway {

using Eigen::Vector2d;

std::optional<ObjectDisc> disc_of(std::span<const Vector2d> points,
                                  const Vector2d& sensor,
                                  double object_size) noexcept {
  if (points.size() < kFewestPoints) return std::nullopt;
  const Vector2d chord = points.back() - points.front();
  if (chord.norm() > object_size) return std::nullopt;
  const Vector2d middle = 0.5 * (points.front() + points.back());
  const std::optional<CircleFit> circle = fit_circle(points);
  if (circle && circle->deviation < kPointSigma && circle->radius > kSmallestRadius &&
      circle->radius < 0.5 * object_size &&
      (circle->center - sensor).norm() > (middle - sensor).norm()) {
    return ObjectDisc{.center = circle->center, .radius = circle->radius, .round = true};
  }
  const double radius = std::max(kSmallestRadius, 0.5 * chord.norm());
  return ObjectDisc{.center = middle + 0.5 * radius * (middle - sensor).normalized(),
                    .radius = radius,
                    .round = false};
}

std::optional<std::size_t> find_waist(std::span<const Vector2d> points,
                                      const Vector2d& sensor,
                                      double object_size) noexcept {
  constexpr std::size_t kFewest = 6;  // points of an object
  constexpr std::size_t kPlaces = 16;
  constexpr double kDeep = 0.04;  // [m]; the waist lies that much behind a straight line
  const std::optional<ObjectDisc> whole = disc_of(points, sensor, object_size);
  if (points.size() < 2 * kFewest || (whole && whole->round)) return std::nullopt;
  const std::size_t step = 1 + (points.size() - 2 * kFewest) / kPlaces;
  std::optional<std::size_t> best;
  double least = kPointSigma;
  const auto range = [&](std::size_t i) { return (points[i] - sensor).norm(); };
  for (std::size_t place = kFewest; place + kFewest <= points.size(); place += step) {
    // The deepest point around this place.
    std::size_t n = place;
    for (std::size_t i = place; i < place + step && i + kFewest <= points.size(); ++i) {
      if (range(i) > range(n)) n = i;
    }
    const std::span<const Vector2d> first = points.first(n);
    const std::span<const Vector2d> second = points.subspan(n);
    // The points of one object bulge towards the sensor; between two objects there is a waist.
    const Vector2d ends = 0.5 * (first[first.size() / 2] + second[second.size() / 2]);
    if (range(n) < (ends - sensor).norm() + kDeep) continue;
    const std::optional<CircleFit> one = fit_circle(first);
    const std::optional<CircleFit> two = fit_circle(second);
    if (!one || !two || std::max(one->deviation, two->deviation) >= least) continue;
    const std::optional<ObjectDisc> left = disc_of(first, sensor, object_size);
    const std::optional<ObjectDisc> right = disc_of(second, sensor, object_size);
    if (!left || !right || !left->round || !right->round) continue;
    least = std::max(one->deviation, two->deviation);
    best = n;
  }
  return best;
}

}  // namespace fairway
