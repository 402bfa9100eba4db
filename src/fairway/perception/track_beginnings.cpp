// SPDX-License-Identifier: Apache-2.0
// How a MovingObjectTracker detects objects and starts their tracks.
#include <algorithm>
#include <optional>

#include "fairway/perception/beam_assignment.hpp"
#include "fairway/perception/moving_object_tracker.hpp"
#include "fairway/perception/object_disc.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kFirstSigma = 0.06;  // of the centre of a new track [m]
constexpr int kMostMissing = 4;       // invalid beams between two beams of one object

// What is beside an object, seen from the sensor.
enum class Border { None, Front, Behind };

double length_of(const Beam& beam) noexcept { return (beam.to - beam.from).norm(); }

// Whether an object ends at `beam`: the beam beside it leads past it, or ends at something that
// hides the rest of it.
Border border_of(const Beam& beam, const Beam& beside) noexcept {
  constexpr double kPast = 0.3;   // [m]
  constexpr double kHides = 0.1;  // [m]
  const double further = length_of(beside) - length_of(beam);
  if (further > kPast) return Border::Front;
  return further < -kHides ? Border::Behind : Border::None;
}

}  // namespace

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
  if (tracks_.size() >= kMaxTracks) return;
  const std::optional<ObjectDisc> disc = disc_of(cluster_, sensor, settings_.object_size);
  if (!disc) return;
  tracks_.push_back(new_track(next_id_++, time, disc->center, kFirstSigma, disc->radius));
  tracks_.back().radius_weight = disc->round ? 1.0 : 0.0;
}

// Starts tracks of round objects that were there when they came into view. They may be posts: they
// count as moving only after they have left their place.
void MovingObjectTracker::begin_round_tracks(double time,
                                             std::span<const Beam> beams,
                                             const RollingGrid& grid) noexcept {
  constexpr double kFurthest = 5.0;  // [m]
  cluster_.clear();
  int missing = 0;
  const Beam* last = nullptr;
  Border left = Border::None;
  const auto end_cluster = [&](Border right) {
    const bool is_object = left != Border::None && right != Border::None &&
                           (left == Border::Front || right == Border::Front);
    if (is_object && cluster_.size() >= kFewestRound) begin_round_track(time, last->from, grid);
    cluster_.clear();
  };
  for (std::size_t b = 0; b < beams.size(); ++b) {
    const Beam& beam = beams[b];
    if (beam.end == BeamEnd::Nothing) {
      ++missing;
      continue;
    }
    const bool fits = beam.end == BeamEnd::Hit && owner_[b] < 0;
    const bool continues = fits && !cluster_.empty() && missing <= kMostMissing &&
                           (beam.to - cluster_.back()).norm() < 0.5 * settings_.cluster_gap;
    if (!continues) {
      if (!cluster_.empty()) end_cluster(border_of(*last, beam));
      left = last != nullptr ? border_of(beam, *last) : Border::None;
    }
    if (fits && left != Border::None && length_of(beam) < kFurthest) cluster_.push_back(beam.to);
    missing = 0;
    last = &beam;
  }
  if (!cluster_.empty()) end_cluster(Border::None);
  begin_departed_tracks();
}

// Starts tracks of objects that stood and leave their place. They count as moving once they have
// gone far enough from it.
void MovingObjectTracker::begin_departed_tracks() noexcept {
  while (tracks_.size() < kMaxTracks) {
    const MovingTrack* const departed = resting_.take_departed();
    if (departed == nullptr) return;
    tracks_.push_back(*departed);
    MovingTrack& track = tracks_.back();
    track.id = next_id_++;
    track.may_be_post = true;
    track.stood = true;
  }
}

void MovingObjectTracker::begin_round_track(double time,
                                            const Vector2d& sensor,
                                            const RollingGrid& grid) noexcept {
  const auto is_static = [&](const Vector2d& point) {
    return grid.is_proven_static(grid.frame().cell_at(point));
  };
  if (resting_.observe(cluster_, sensor)) return;
  if (is_static(cluster_[cluster_.size() / 2])) {
    resting_.begin(cluster_, sensor);
    return;
  }
  const std::size_t all = cluster_.size();
  const std::optional<std::size_t> waist = find_waist(cluster_, sensor, settings_.object_size);
  const std::span<const Vector2d> points(cluster_);
  for (const std::span<const Vector2d> part :
       {points.first(waist.value_or(all)), points.subspan(waist.value_or(all))}) {
    if (part.size() < kFewestRound || tracks_.size() >= kMaxTracks) continue;
    const std::optional<ObjectDisc> disc = disc_of(part, sensor, settings_.object_size);
    if (!disc || !disc->round) continue;
    tracks_.push_back(new_track(next_id_++, time, disc->center, kFirstSigma, disc->radius));
    tracks_.back().may_be_post = true;
    tracks_.back().radius_weight = 1.0;
  }
}

}  // namespace fairway
