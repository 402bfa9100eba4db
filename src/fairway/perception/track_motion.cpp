// SPDX-License-Identifier: Apache-2.0
// How a MovingObjectTracker decides which tracks move.
#include <algorithm>

#include "fairway/perception/moving_object_tracker.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kStoppedFor = 1.0;  // [s]; after this the object no longer counts as moving
constexpr int kFewestSightings = 4;
constexpr int kManySightings = 10;    // after these the motion of any shape is known
constexpr int kFewestMoving = 3;      // scans in a row, against jumps of the centre
constexpr double kFewFits = 3.0;      // after this many good circles the size is known
constexpr double kManyFits = 8.0;     // good circles after which the centre is known well
constexpr double kBadFits = 4.0;      // scans without a good circle, at most
constexpr int kManyFitted = 20;       // scans for which good circles are counted
constexpr double kLeastChange = 0.2;  // share of the hits of an object that moves

}  // namespace

// Returns whether a track may be a part of a wall. An object that is not a disc can be a part of a
// wall that gradually comes into view, or that appears at a new place because the pose drifted.
// Beams then still end where the track was first seen; a moving object leaves that place.
bool MovingObjectTracker::slides_along_a_wall(const MovingTrack& track,
                                              std::span<const Beam> beams) noexcept {
  constexpr int kFewest = 2;      // number of beams
  constexpr double kNear = 0.05;  // [m] around the first position of the disc
  constexpr double kOff = 0.1;    // [m] outside its present outline
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
  track.born_radius = track.radius;
}

// Whether the mean velocity since the first sighting is that of a moving object, and the present
// one agrees with it. The error of a mean shrinks with time. That of the filter's velocity does
// not: it stays at 0.5 m/s, so that a person who walks at 0.4 m/s would never count.
bool MovingObjectTracker::walks_steadily(const MovingTrack& track, double least) const noexcept {
  constexpr double kSameDirection = 0.8;  // cosine
  const Vector2d moved = track.position() - track.born_at;
  const double mean = moved.norm() / std::max(time_ - track.born_time, 1e-3);
  return mean > least &&
         moved.dot(track.velocity()) > kSameDirection * moved.norm() * track.velocity().norm();
}

// Whether a track that may be a post seems to be on its way out of its place: a slow walker needs
// more than a second until it counts. The mean speed of a short time is not exact.
bool MovingObjectTracker::is_leaving(const MovingTrack& track) const noexcept {
  constexpr double kShare = 0.75;  // of the speed of the slowest moving object
  return track.changed_share >= 0.5 * kLeastChange &&
         walks_steadily(track, kShare * settings_.moving_speed);
}

// Updates how much of a track's surface moves: hits in cells that were free before, and beams that
// pass an occupied cell before they end. Both are rare on a static object that is known.
void MovingObjectTracker::note_changes(std::size_t index,
                                       std::span<const Beam> beams,
                                       const RollingGrid& grid) noexcept {
  constexpr double kBefore = 0.1;  // [m]; before the end of a beam
  constexpr double kNewest = 0.3;  // share of the last scan in the mean
  int all = 0;
  int changed = 0;
  for_hits(index, beams, [&](const Beam& beam) {
    ++all;
    // Where the grid marks the hit.
    const Vector2d along = (beam.to - beam.from).normalized();
    const Vector2d mark = beam.to + settings_.hit_depth * along;
    const CellState now = grid.at(grid.frame().cell_at(mark));
    const bool fresh = now == CellState::Free;
    const bool passed =
        now != CellState::Occupied &&
        grid.at(grid.frame().cell_at(mark - kBefore * along)) == CellState::Occupied;
    if (fresh || passed) ++changed;
  });
  MovingTrack& track = tracks_[index];
  // All of a new object is new at first.
  if (all == 0 || track.sightings < kFewestSightings) return;
  track.changed_share += kNewest * (static_cast<double>(changed) / all - track.changed_share);
}

// Whether a track that may be a post has left its place: enough of its beams end outside of the
// disc where it was first seen, in cells that were free before. Parts of a static object that come
// into view were unknown before.
bool MovingObjectTracker::has_left_its_place(std::size_t index,
                                             std::span<const Beam> beams,
                                             const RollingGrid& grid) const noexcept {
  constexpr double kOff = 0.08;  // [m] outside of the first outline
  constexpr int kFewest = 4;     // number of beams
  const MovingTrack& track = tracks_[index];
  int all = 0;
  int left = 0;
  for_hits(index, beams, [&](const Beam& beam) {
    ++all;
    if ((beam.to - track.born_at).norm() <= track.born_radius + kOff) return;
    const Vector2d along = (beam.to - beam.from).normalized();
    const CellIndex cell = grid.frame().cell_at(beam.to + settings_.hit_depth * along);
    if (grid.would_be_new(cell) || grid.at(cell) == CellState::Free) ++left;
  });
  return left >= kFewest && 3 * left >= all;
}

// Whether a track is much faster than the mean since its first sighting: its points may have become
// those of another object.
bool MovingObjectTracker::has_jumped(const MovingTrack& track, double moved) const noexcept {
  const double mean = moved / std::max(time_ - track.born_time, 1e-3);
  return track.velocity().norm() > 2.0 * mean;
}

// Whether a track that counts as moving has gone on: the centre of a part of a wall may jump once
// as more of it comes into view, but it stays there. Judged once, some time after it began to
// count.
bool MovingObjectTracker::keeps_its_pace(const MovingTrack& track, double dt) const noexcept {
  constexpr double kJudgedAfter = 0.4;  // [s]
  constexpr double kShare = 0.5;        // of the distance at its mean speed before
  const double since = time_ - track.counted_since;
  if (since < kJudgedAfter || since - dt >= kJudgedAfter) return true;
  return (track.position() - track.counted_at).norm() >= kShare * since * track.first_pace;
}

void MovingObjectTracker::judge_motion(std::size_t index,
                                       double dt,
                                       std::span<const Beam> beams,
                                       const RollingGrid& grid) noexcept {
  constexpr double kFar = 0.3;       // [m]; a static object never seems to walk that far
  constexpr double kClearly = 0.22;  // [m]
  MovingTrack& track = tracks_[index];
  const double speed = track.velocity().norm();
  const bool fast = speed > settings_.moving_speed;
  const bool steady = walks_steadily(track, settings_.moving_speed);
  track.slow_for = fast ? 0.0 : track.slow_for + dt;
  if (track.last_seen >= time_) note_changes(index, beams, grid);
  // The velocity of an object at rest has errors; its place has not.
  constexpr double kStays = 0.5;  // share of the distance of the slowest moving object
  if ((track.position() - track.stayed_at).norm() > kStays * kStoppedFor * settings_.moving_speed) {
    track.stayed_at = track.position();
    track.stayed_since = time_;
  }
  if (track.moving) {
    if (track.last_seen >= time_) track.moving_for += dt;
    track.moving = track.slow_for < kStoppedFor && time_ - track.stayed_since <= kStoppedFor &&
                   keeps_its_pace(track, dt);
    if (!track.moving) count_from_here(track);
    return;
  }
  // The first fits are inaccurate.
  if (track.sightings < kFewestSightings) count_from_here(track);
  const double moved = (track.position() - track.born_at).norm();
  const double far_enough = track.may_be_post && !track.stood
                                ? std::max(kClearly, settings_.moving_distance)
                                : settings_.moving_distance;
  // A slow object changes little from scan to scan, but it leaves its place. One that moves away
  // does not leave it soon, but changes.
  const bool changes = track.changed_share >= kLeastChange;
  const bool may_move = track.sightings >= kFewestSightings && track.last_seen >= time_ &&
                        (fast || steady) && moved > far_enough &&
                        moved > 3.0 * track.position_sigma() &&
                        (speed > track.velocity_sigma() || steady || (changes && moved > kClearly));
  const bool shape_known =
      track.may_be_post || track.radius_weight >= kFewFits || track.sightings >= kManySightings;
  const bool walks_far = moved > kFar && steady && !has_jumped(track, moved);
  const bool changes_somewhat = track.changed_share >= 0.5 * kLeastChange;
  const bool has_left = changes_somewhat && has_left_its_place(index, beams, grid);
  // The centre of an object to which circles fit nearly always is known to centimetres, also where
  // the object leaves its outline slowly because it walks away.
  const bool is_round = track.radius_weight >= kManyFits &&
                        track.radius_weight + kBadFits >= std::min(track.sightings, kManyFitted);
  const bool walks_round = is_round && changes_somewhat && steady && !has_jumped(track, moved);
  const bool seems_to_move =
      may_move && shape_known &&
      (has_left || walks_round || (!track.may_be_post && (changes || walks_far)));
  track.moving_scans = seems_to_move ? track.moving_scans + 1 : 0;
  if (track.moving_scans < kFewestMoving) return;
  track.moving = !slides_along_a_wall(track, beams);
  if (!track.moving) {
    count_from_here(track);
    return;
  }
  track.may_be_post = false;
  track.moving_for = 0.0;
  track.counted_at = track.position();
  track.counted_since = time_;
  track.first_pace = moved / std::max(time_ - track.born_time, 1e-3);
  track.stayed_at = track.position();
  track.stayed_since = time_;
}

}  // namespace fairway
