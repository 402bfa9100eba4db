// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/moving_object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fairway/perception/beam_assignment.hpp"
#include "fairway/perception/object/circle_fit.hpp"
#include "fairway/perception/object_disc.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kSeenThroughFor = 0.25;  // [s]; after this the object is gone

}  // namespace

MovingObjectTracker::MovingObjectTracker(const PerceptionSettings& settings, std::size_t max_beams)
    : settings_(settings),
      resting_(settings) {
  tracks_.reserve(kMaxTracks);
  obstacles_.reserve(kMaxTracks);
  owner_.reserve(max_beams);
  hits_.reserve(kMaxTracks);
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
  note_hits();
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    correct(i, time, beams);
    judge_unseen(tracks_[i], dt, beams);
    judge_motion(i, dt, beams, grid);
  }
  begin_tracks(time, beams, grid);
  resting_.begin_scan(time, dt);
  begin_round_tracks(time, beams, grid);
  mark_moving(beams);
  drop_lost(time);
  emit();
}

void MovingObjectTracker::note_hits() noexcept {
  hits_.assign(tracks_.size(), {.first = owner_.size(), .end = 0});
  for (std::size_t b = 0; b < owner_.size(); ++b) {
    if (owner_[b] < 0) continue;
    BeamRange& range = hits_[static_cast<std::size_t>(owner_[b])];
    range.first = std::min(range.first, b);
    range.end = b + 1;
  }
}

void MovingObjectTracker::correct(std::size_t index,
                                  double time,
                                  std::span<const Beam> beams) noexcept {
  MovingTrack& track = tracks_[index];
  cluster_.clear();
  Vector2d sensor = Vector2d::Zero();
  for_hits(index, beams, [&](const Beam& beam) {
    cluster_.push_back(beam.to);
    sensor = beam.from;
  });
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
    track.resize(track.radius + share * (circle->radius - track.radius), sensor);
    track.radius_weight = std::min(kMostWeight, track.radius_weight + 1.0);
  }
  const double guess_sigma = std::max(0.05, track.position_sigma());
  const CenterFit fit =
      fit_center(cluster_, track.radius, track.position(), kPointSigma, guess_sigma);
  if (fit.deviation > 3.0 * kPointSigma && !behind) return;
  // The errors of the points of a scan are correlated, so they do not average out. The object is
  // not a perfect disc.
  constexpr int kFewSightings = 4;      // before, its velocity is not known
  constexpr double kShapeSigma = 0.02;  // [m]
  const Eigen::Matrix2d noise =
      fit.covariance + kShapeSigma * kShapeSigma * Eigen::Matrix2d::Identity();
  // An object that turns back changes its velocity by more than the noise of its acceleration.
  if (track.moving && track.is_surprised_by(fit.center, noise))
    track.allow_jump(time - track.last_seen);
  // Other improbable centres come from points of something else.
  if (track.sightings >= kFewSightings && track.is_surprised_by(fit.center, noise)) return;
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

void MovingObjectTracker::drop_lost(double time) noexcept {
  const auto lost = [&](const MovingTrack& track) {
    constexpr double kForgetUnproven = 0.3;  // [s]
    constexpr double kPostAfter = 1.0;  // [s]; what has not left its place until then is a post
    if (track.may_be_post && time - track.born_time > kPostAfter && !is_leaving(track)) return true;
    const double hidden = time - track.last_seen;
    const double patience = std::min(settings_.forget_after, kForgetUnproven + track.moving_for);
    return !track.state.allFinite() || track.seen_through > kSeenThroughFor ||
           hidden > (track.moving ? patience : std::min(kForgetUnproven, settings_.forget_after));
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

// Marks the beams that end on a moving disc, or slightly inside or outside of it.
void MovingObjectTracker::mark_moving(std::span<Beam> beams) const noexcept {
  for (std::size_t b = 0; b < beams.size(); ++b) {
    beams[b].moving = owner_[b] >= 0 && tracks_[static_cast<std::size_t>(owner_[b])].moving;
  }
}

void MovingObjectTracker::emit() noexcept {
  constexpr double kMostGrowth = 0.5;  // [m]
  constexpr double kReaction = 0.2;    // [s]; until the next scans have corrected the velocity
  obstacles_.clear();
  for (const MovingTrack& track : tracks_) {
    if (!track.moving) continue;
    const double growth = std::min(
        kMostGrowth, settings_.uncertainty_share *
                         std::hypot(track.position_sigma(), kReaction * track.velocity_sigma()));
    obstacles_.push_back({.position = track.position(),
                          .velocity = track.velocity(),
                          .radius = track.radius + growth});
  }
}

}  // namespace fairway
