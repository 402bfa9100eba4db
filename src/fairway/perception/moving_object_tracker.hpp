// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/perception/object/moving_track.hpp"
#include "fairway/perception/resting_objects.hpp"
#include "fairway/perception/rolling_grid.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// Detects and tracks moving objects in lidar scans.
///
/// A beam is new if it ends where space was surely free shortly before. Neighbouring new beams form
/// a cluster, and each cluster of a plausible size starts a track. A track takes the beams that end
/// near its predicted position, fits a disc of its size to them, and corrects its Kalman filter.
/// Without beams it continues at its velocity while it may be hidden. It ends if it is hidden for
/// too long, or if beams pass through its position.
///
/// A round object that was there when it came into view starts a track too. It may be a post: it
/// counts as moving only after it has left its first place, into cells that were free before. Two
/// such objects that overlap are split at their waist.
///
/// Round objects that stood for so long that their cells are static are measured on the side: one
/// that leaves its place becomes a track, whose motion is counted from that place.
///
/// A velocity that jumps, as of a person who turns back, is noticed by the first improbable
/// position. What is not known of the velocity makes the obstacle larger.
///
/// A track counts as moving once it has moved. Before that, and after it stops, its beams belong to
/// the grid like all others. Beams at known static obstacles belong to no track, and begin none
/// near them: a wall stays a wall where the pose drifts, and a person who stands for long becomes
/// an obstacle. Does not allocate after construction; deterministic.
class MovingObjectTracker {
 public:
  MovingObjectTracker(const PerceptionSettings& settings, std::size_t max_beams);

  /// Processes one scan. Call it before the grid processes the same scan.
  /// @param beams  In order of their angle; those that hit a moving object are marked.
  /// @param grid   The grid before the scan.
  void update(double time, std::span<Beam> beams, const RollingGrid& grid) noexcept;

  /// All tracks, moving or not.
  [[nodiscard]] std::span<const MovingTrack> tracks() const noexcept { return tracks_; }

  /// The moving obstacles at the time of the last scan; each radius includes the uncertainty of the
  /// position and of the velocity.
  [[nodiscard]] MovingObstacles obstacles() const noexcept { return obstacles_; }

  /// Round objects at rest, for tests and diagnostics.
  [[nodiscard]] std::span<const MovingTrack> resting() const noexcept { return resting_.objects(); }

 private:
  void correct(std::size_t track, double time, std::span<const Beam> beams) noexcept;
  void judge_unseen(MovingTrack& track, double dt, std::span<const Beam> beams) const noexcept;
  void count_from_here(MovingTrack& track) const noexcept;
  [[nodiscard]] bool walks_steadily(const MovingTrack& track, double least) const noexcept;
  [[nodiscard]] bool is_leaving(const MovingTrack& track) const noexcept;
  [[nodiscard]] bool keeps_its_pace(const MovingTrack& track, double dt) const noexcept;
  [[nodiscard]] bool has_jumped(const MovingTrack& track, double moved) const noexcept;
  void judge_motion(std::size_t track,
                    double dt,
                    std::span<const Beam> beams,
                    const RollingGrid& grid) noexcept;
  void note_changes(std::size_t track,
                    std::span<const Beam> beams,
                    const RollingGrid& grid) noexcept;
  [[nodiscard]] bool has_left_its_place(std::size_t track,
                                        std::span<const Beam> beams,
                                        const RollingGrid& grid) const noexcept;
  [[nodiscard]] static bool slides_along_a_wall(const MovingTrack& track,
                                                std::span<const Beam> beams) noexcept;
  void drop_lost(double time) noexcept;
  void begin_tracks(double time, std::span<const Beam> beams, const RollingGrid& grid) noexcept;
  void begin_track(double time, const Eigen::Vector2d& sensor) noexcept;
  void begin_round_tracks(double time,
                          std::span<const Beam> beams,
                          const RollingGrid& grid) noexcept;
  void begin_round_track(double time,
                         const Eigen::Vector2d& sensor,
                         const RollingGrid& grid) noexcept;
  void begin_departed_tracks() noexcept;
  void mark_moving(std::span<Beam> beams) const noexcept;
  void emit() noexcept;
  [[nodiscard]] bool is_new(const Beam& beam, const RollingGrid& grid) const noexcept;

  // Calls visit(beam) for the beams of a track.
  template <typename Visit>
  void for_hits(std::size_t track, std::span<const Beam> beams, Visit&& visit) const {
    for (std::size_t b = hits_[track].first; b < hits_[track].end; ++b) {
      if (owner_[b] == static_cast<int>(track)) visit(beams[b]);
    }
  }
  void note_hits() noexcept;

  struct BeamRange {
    std::size_t first = 0;
    std::size_t end = 0;  // one past the last
  };

  PerceptionSettings settings_;
  std::vector<MovingTrack> tracks_;
  RestingObjects resting_;
  std::vector<int> owner_;                // track of each beam; -1 for none
  std::vector<BeamRange> hits_;           // beams among which those of each track are
  std::vector<Eigen::Vector2d> cluster_;  // points of the cluster being processed
  std::vector<MovingObstacle> obstacles_;
  double time_ = -1.0;  // time of the last scan [s]
  int next_id_ = 0;
};

}  // namespace fairway
