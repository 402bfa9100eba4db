// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/resting_objects.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fairway/perception/beam_assignment.hpp"
#include "fairway/perception/object/circle_fit.hpp"
#include "fairway/perception/object_disc.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kRing = 0.15;         // [m], of points around the outline
constexpr double kCenterSigma = 0.06;  // of the centre of a new object [m]
constexpr int kFewestScans = 8;        // after these the place is known
constexpr double kManyScans = 20.0;    // the mean of the place is over about so many
constexpr double kAtPlace = 0.04;      // [m] from the place
constexpr double kLeft = 0.08;         // [m]; further away it has left its place
constexpr double kForgetAfter = 0.5;   // [s] out of view

}  // namespace

RestingObjects::RestingObjects(const PerceptionSettings& settings) : settings_(settings) {
  objects_.reserve(kMaxTracks);
  near_.reserve(kMaxTracks);
  points_.reserve(static_cast<std::size_t>(settings.max_beams));
}

void RestingObjects::begin_scan(double time, double dt) noexcept {
  time_ = time;
  ++scans_;
  std::erase_if(objects_, [&](const MovingTrack& object) {
    return time - object.last_seen > kForgetAfter || !object.state.allFinite();
  });
  for (MovingTrack& object : objects_)
    object.predict(dt, settings_.acceleration_noise);
}

bool RestingObjects::observe(std::span<const Vector2d> cluster, const Vector2d& sensor) noexcept {
  const double extent = 0.5 * (cluster.back() - cluster.front()).norm();
  const Vector2d& middle = cluster[cluster.size() / 2];
  near_.clear();
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const double reach = 2.0 * objects_[i].radius + kRing + extent;
    if ((middle - objects_[i].position()).norm() < reach) near_.push_back(i);
  }
  std::size_t explained = 0;
  for (const std::size_t i : near_) {
    points_.clear();
    for (const Vector2d& point : cluster) {
      if (nearest_outline(point, sensor) == i) points_.push_back(point);
    }
    explained += points_.size();
    if (points_.size() >= kFewestRound && objects_[i].last_seen < time_)
      correct(objects_[i], sensor);
  }
  return 2 * explained > cluster.size();
}

// Index of the object near whose outline a point is, among those near the cluster; that of no
// object if there is none.
std::size_t RestingObjects::nearest_outline(const Vector2d& point,
                                            const Vector2d& sensor) const noexcept {
  constexpr double kBehind = 0.1;  // [m]; the sensor sees the near side only
  std::size_t nearest = objects_.size();
  double least = kRing;
  for (const std::size_t i : near_) {
    const Vector2d off = point - objects_[i].position();
    const double away = std::abs(off.norm() - objects_[i].radius);
    if (away >= least) continue;
    const Vector2d sight = objects_[i].position() - sensor;
    if (off.dot(sight) > kBehind * sight.norm()) continue;
    least = away;
    nearest = i;
  }
  return nearest;
}

// Corrects an object by `points_`.
void RestingObjects::correct(MovingTrack& object, const Vector2d& sensor) noexcept {
  const std::optional<ObjectDisc> disc = disc_of(points_, sensor, settings_.object_size);
  if (disc && disc->round) {
    object.radius_weight = std::min(kManyScans, object.radius_weight + 1.0);
    object.resize(object.radius + (disc->radius - object.radius) / object.radius_weight, sensor);
  }
  constexpr double kRestShapeSigma = 0.02;  // [m]
  const CenterFit fit =
      fit_center(points_, object.radius, object.position(), kPointSigma, kCenterSigma);
  object.last_seen = time_;
  if (fit.deviation > kPointSigma) return;
  object.correct(fit.center,
                 fit.covariance + kRestShapeSigma * kRestShapeSigma * Eigen::Matrix2d::Identity());
  ++object.sightings;
  const double weight = std::min(kManyScans, static_cast<double>(object.sightings));
  object.born_at += (object.position() - object.born_at) / weight;
  object.born_radius = object.radius;
  if ((object.position() - object.born_at).norm() < kAtPlace || object.sightings < kFewestScans)
    object.born_time = time_;
}

void RestingObjects::begin(std::span<const Vector2d> cluster, const Vector2d& sensor) noexcept {
  constexpr unsigned int kEvery = 4U;  // scans; it takes some time
  if (scans_ % kEvery != 0) return;
  const std::size_t waist =
      find_waist(cluster, sensor, settings_.object_size).value_or(cluster.size());
  for (const std::span<const Vector2d> part : {cluster.first(waist), cluster.subspan(waist)}) {
    if (part.size() < kFewestRound || objects_.size() >= kMaxTracks) continue;
    const std::optional<ObjectDisc> disc = disc_of(part, sensor, settings_.object_size);
    if (!disc || !disc->round || is_known(disc->center)) continue;
    objects_.push_back(new_track(0, time_, disc->center, kCenterSigma, disc->radius));
    objects_.back().radius_weight = 1.0;
  }
}

bool RestingObjects::is_known(const Vector2d& center) const noexcept {
  return std::any_of(objects_.begin(), objects_.end(), [&](const MovingTrack& object) {
    return (object.position() - center).norm() < object.radius;
  });
}

const MovingTrack* RestingObjects::take_departed() noexcept {
  const auto left = std::find_if(objects_.begin(), objects_.end(), [&](const MovingTrack& object) {
    return object.last_seen >= time_ && object.sightings >= kFewestScans &&
           (object.position() - object.born_at).norm() > kLeft;
  });
  if (left == objects_.end()) return nullptr;
  departed_ = *left;
  objects_.erase(left);
  return &departed_;
}

}  // namespace fairway
