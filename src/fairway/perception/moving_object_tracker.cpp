// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/moving_object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fairway/perception/beam_assignment.hpp"
#include "fairway/perception/circle_fit.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kSmallestRadius = 0.1;  // [m]
constexpr std::size_t kFewestPoints = 3;
constexpr double kSeenThroughFor = 0.25;  // [s]; after this the object is gone
constexpr double kStoppedFor = 1.0;       // [s]; after this the object no longer counts as moving
constexpr int kFewestSightings = 4;

}  // namespace

MovingObjectTracker::MovingObjectTracker(const PerceptionSettings& settings, std::size_t max_beams)
    : settings_(settings) {
  tracks_.reserve(kMaxTracks);
  obstacles_.reserve(kMaxTracks);
  owner_.reserve(max_beams);
  cluster_.reserve(max_beams);
}

void MovingObjectTracker::update(double time,
                                 std::span<Beam> beams,
                                 const RollingGrid& grid) noexcept {
  const double dt = time_ < 0.0 ? 0.0 : std::clamp(time - time_, 0.0, 1.0);
  time_ = time;
  for (MovingTrack& track : tracks_)
    track.predict(dt, settings_.acceleration_noise);
  owner_.resize(beams.size());
  assign_beams(beams, tracks_, grid, owner_);
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    correct(i, time, beams);
    judge_unseen(tracks_[i], dt, beams);
    judge_motion(tracks_[i], dt, beams);
  }
  begin_tracks(time, beams, grid);
  mark_moving(beams);
  drop_lost(time);
  emit();
}

void MovingObjectTracker::correct(std::size_t index,
                                  double time,
                                  std::span<const Beam> beams) noexcept {
  MovingTrack& track = tracks_[index];
  cluster_.clear();
  Vector2d sensor = Vector2d::Zero();
  for (std::size_t b = 0; b < beams.size(); ++b) {
    if (owner_[b] != static_cast<int>(index)) continue;
    cluster_.push_back(beams[b].to);
    sensor = beams[b].from;
  }
  if (cluster_.size() < kFewestPoints) return;
  // A well-fitting circle gives the size. The estimate is kept, so that a half hidden disc keeps
  // its size.
  const std::optional<CircleFit> circle = fit_circle(cluster_);
  const bool behind =
      circle && (circle->center - sensor).norm() > (cluster_[cluster_.size() / 2] - sensor).norm();
  if (behind && circle->deviation < kPointSigma && circle->radius < 0.5 * settings_.object_size &&
      circle->radius > kSmallestRadius) {
    constexpr double kMostWeight = 20.0;  // [scans]; the size changes by at most 1/20 per scan
    const double share = 1.0 / (track.radius_weight + 1.0);
    track.radius += share * (circle->radius - track.radius);
    track.radius_weight = std::min(kMostWeight, track.radius_weight + 1.0);
  }
  const double guess_sigma = std::max(0.05, track.position_sigma());
  const CenterFit fit =
      fit_center(cluster_, track.radius, track.position(), kPointSigma, guess_sigma);
  if (fit.deviation > 3.0 * kPointSigma && !behind) return;
  // The errors of the points of a scan are correlated, so they do not average out. The object is
  // not a perfect disc.
  const Eigen::Matrix2d noise =
      fit.covariance + kPointSigma * kPointSigma * Eigen::Matrix2d::Identity();
  track.correct(fit.center, noise);
  track.last_seen = time;
  ++track.sightings;
}

// Decides whether an unseen track is hidden or gone: it is gone if beams pass through its position.
void MovingObjectTracker::judge_unseen(MovingTrack& track,
                                       double dt,
                                       std::span<const Beam> beams) const noexcept {
  if (track.last_seen >= time_) {
    track.seen_through = 0.0;
    return;
  }
  constexpr int kEnough = 3;  // number of beams
  int through = 0;
  for (const Beam& beam : beams) {
    if (beam.end == BeamEnd::Nothing) continue;
    const Vector2d ray = beam.to - beam.from;
    const double length = ray.norm();
    const double along = (track.position() - beam.from).dot(ray) / length;
    const Vector2d nearest = beam.from + along / length * ray;
    if (along > 0.0 && along + track.radius < length &&
        (track.position() - nearest).norm() < 0.7 * track.radius) {
      ++through;
    }
  }
  track.seen_through = through >= kEnough ? track.seen_through + dt : 0.0;
}

// Returns whether a track may be a part of a wall. An object that is not a disc can be a part of a
// wall that gradually comes into view, or that appears at a new place because the pose drifted.
// Beams then still end where the track was first seen; a moving object leaves that place.
bool MovingObjectTracker::slides_along_a_wall(const MovingTrack& track,
                                              std::span<const Beam> beams) noexcept {
  constexpr double kFewFits = 3.0;  // after this many good circles the track is no part of a wall
  constexpr int kFewest = 2;        // number of beams
  constexpr double kNear = 0.05;    // [m] around the first position of the disc
  constexpr double kOff = 0.1;      // [m] outside its present outline
  if (track.radius_weight >= kFewFits) return false;
  int remain = 0;
  for (const Beam& beam : beams) {
    if (beam.end != BeamEnd::Hit) continue;
    if ((beam.to - track.born_at).norm() < track.radius + kNear &&
        (beam.to - track.position()).norm() > track.radius + kOff) {
      ++remain;
    }
  }
  return remain >= kFewest;
}

// Moves are counted from the present position on.
void MovingObjectTracker::count_from_here(MovingTrack& track) const noexcept {
  track.born_at = track.position();
  track.born_time = time_;
}

// Whether the mean velocity since the first sighting is that of a moving object, and the present
// one agrees with it. The error of a mean shrinks with time. That of the filter's velocity does
// not: it stays at 0.5 m/s, so that a person who walks at 0.4 m/s would never count.
bool MovingObjectTracker::walks_steadily(const MovingTrack& track) const noexcept {
  constexpr double kSameDirection = 0.8;  // cosine
  constexpr double kManyFits = 3.0;       // good circles: a part of a wall is none
  if (track.radius_weight < kManyFits) return false;
  const Vector2d moved = track.position() - track.born_at;
  const double mean = moved.norm() / std::max(time_ - track.born_time, 1e-3);
  return mean > settings_.moving_speed &&
         moved.dot(track.velocity()) > kSameDirection * moved.norm() * track.velocity().norm();
}

void MovingObjectTracker::judge_motion(MovingTrack& track,
                                       double dt,
                                       std::span<const Beam> beams) const noexcept {
  const double speed = track.velocity().norm();
  const bool fast = speed > settings_.moving_speed;
  track.slow_for = fast ? 0.0 : track.slow_for + dt;
  if (track.moving) {
    track.moving = track.slow_for < kStoppedFor;
    if (!track.moving) count_from_here(track);
    return;
  }
  const double moved = (track.position() - track.born_at).norm();
  const bool may_move = track.sightings >= kFewestSightings && track.last_seen >= time_ && fast &&
                        moved > settings_.moving_distance && moved > 3.0 * track.position_sigma() &&
                        (speed > track.velocity_sigma() || walks_steadily(track));
  if (!may_move) return;
  track.moving = !slides_along_a_wall(track, beams);
  if (!track.moving) count_from_here(track);
}

void MovingObjectTracker::drop_lost(double time) noexcept {
  const auto lost = [&](const MovingTrack& track) {
    constexpr double kForgetUnproven = 0.3;  // [s]
    const double hidden = time - track.last_seen;
    return !track.state.allFinite() || track.seen_through > kSeenThroughFor ||
           hidden > (track.moving ? settings_.forget_after : kForgetUnproven);
  };
  std::erase_if(tracks_, lost);
  // Of two tracks on the same object, keep the one with more evidence. Two objects that pass
  // through each other have different velocities.
  constexpr double kSameVelocity = 0.6;  // [m/s]
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    for (std::size_t j = tracks_.size(); j-- > i + 1;) {
      const double away = (tracks_[i].position() - tracks_[j].position()).norm();
      if (away > 0.5 * std::max(tracks_[i].radius, tracks_[j].radius)) continue;
      if (tracks_[i].moving && tracks_[j].moving &&
          (tracks_[i].velocity() - tracks_[j].velocity()).norm() > kSameVelocity) {
        continue;
      }
      const bool later_is_better = tracks_[j].moving && !tracks_[i].moving;
      if (later_is_better) tracks_[i] = tracks_[j];
      tracks_.erase(tracks_.begin() + static_cast<std::ptrdiff_t>(j));
    }
  }
}

// Whether a hit can belong to a new object. Where the pose drifts, a wall appears in front of its
// own cells, so a new object has to be further from every static obstacle than that.
bool MovingObjectTracker::is_new(const Beam& beam, const RollingGrid& grid) const noexcept {
  constexpr double kDrift = 0.2;          // [m]
  constexpr double kMatchedDrift = 0.15;  // [m], of poses corrected by scans
  const double drift = settings_.match_scans ? kMatchedDrift : kDrift;
  const CellIndex cell = grid.frame().cell_at(beam.to);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (!grid.would_be_new({.x = cell.x + dx, .y = cell.y + dy})) return false;
    }
  }
  return !grid.is_static_near(cell, static_cast<int>(drift / grid.frame().resolution + 0.5));
}

void MovingObjectTracker::begin_tracks(double time,
                                       std::span<const Beam> beams,
                                       const RollingGrid& grid) noexcept {
  constexpr int kMostMissing = 4;  // invalid beams between two beams of one cluster
  cluster_.clear();
  int missing = 0;
  Vector2d sensor = Vector2d::Zero();
  for (std::size_t b = 0; b < beams.size(); ++b) {
    const Beam& beam = beams[b];
    const bool fits = beam.end == BeamEnd::Hit && owner_[b] < 0 && is_new(beam, grid);
    const bool continues = fits && missing <= kMostMissing && !cluster_.empty() &&
                           (beam.to - cluster_.back()).norm() < settings_.cluster_gap;
    if (fits && !continues) {
      begin_track(time, sensor);
      cluster_.clear();
    }
    missing = fits ? 0 : missing + 1;
    if (!fits) continue;
    cluster_.push_back(beam.to);
    sensor = beam.from;
  }
  begin_track(time, sensor);
}

void MovingObjectTracker::begin_track(double time, const Vector2d& sensor) noexcept {
  if (cluster_.size() < kFewestPoints || tracks_.size() >= kMaxTracks) return;
  const Vector2d chord = cluster_.back() - cluster_.front();
  if (chord.norm() > settings_.object_size) return;
  const std::optional<CircleFit> circle = fit_circle(cluster_);
  const Vector2d middle = 0.5 * (cluster_.front() + cluster_.back());
  double radius = std::max(kSmallestRadius, 0.5 * chord.norm());
  Vector2d center = middle + 0.5 * radius * (middle - sensor).normalized();
  if (circle && circle->deviation < kPointSigma && circle->radius > kSmallestRadius &&
      circle->radius < 0.5 * settings_.object_size &&
      (circle->center - sensor).norm() > (middle - sensor).norm()) {
    radius = circle->radius;
    center = circle->center;
  }
  tracks_.push_back(new_track(next_id_++, time, center, 2.0 * kPointSigma, radius));
}

// Marks the beams that end on a moving disc, or slightly inside or outside of it.
void MovingObjectTracker::mark_moving(std::span<Beam> beams) const noexcept {
  for (std::size_t b = 0; b < beams.size(); ++b) {
    beams[b].moving = owner_[b] >= 0 && tracks_[static_cast<std::size_t>(owner_[b])].moving;
  }
}

void MovingObjectTracker::emit() noexcept {
  constexpr double kMostGrowth = 0.5;  // [m]
  obstacles_.clear();
  for (const MovingTrack& track : tracks_) {
    if (!track.moving) continue;
    const double growth =
        std::min(kMostGrowth, settings_.uncertainty_share * track.position_sigma());
    obstacles_.push_back({.position = track.position(),
                          .velocity = track.velocity(),
                          .radius = track.radius + growth});
  }
}

}  // namespace fairway
