// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/perception/moving_track.hpp"
#include "fairway/perception/rolling_grid.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// Finds and follows what moves in lidar scans.
///
/// A beam that ends where space was surely free a moment ago is new: neighbouring ones form a
/// cluster, and each cluster of a plausible size begins a track. A track takes the beams that end
/// near where it should be, fits a disc of its size to them, and corrects its Kalman filter;
/// without beams it goes on at its velocity while it may be hidden, and ends when it is hidden for
/// too long or beams pass where it should be. It counts as moving once it has moved; until then,
/// and when it stands, its beams belong to the grid like all others. No allocation after
/// construction; deterministic.
class MovingObjectTracker {
 public:
  static constexpr std::size_t kMaxTracks = 48;  ///< beyond these nothing new is followed

  MovingObjectTracker(const PerceptionSettings& settings, std::size_t max_beams);

  /// Takes in one scan, before the grid does.
  /// @param beams  In order of their angle; those that hit a moving object are marked.
  /// @param grid   What was known before the scan.
  void update(double time, std::span<Beam> beams, const RollingGrid& grid) noexcept;

  /// All tracks, moving or not.
  [[nodiscard]] std::span<const MovingTrack> tracks() const noexcept { return tracks_; }

  /// What moves, as of the last scan; the radius grows with the uncertainty of the position.
  [[nodiscard]] MovingObstacles obstacles() const noexcept { return obstacles_; }

 private:
  void assign(std::span<const Beam> beams) noexcept;
  void correct(std::size_t track, double time, std::span<const Beam> beams) noexcept;
  void judge_unseen(MovingTrack& track, double dt, std::span<const Beam> beams) const noexcept;
  void judge_motion(MovingTrack& track, double dt, std::span<const Beam> beams) const noexcept;
  [[nodiscard]] static bool slides_along_a_wall(const MovingTrack& track,
                                                std::span<const Beam> beams) noexcept;
  void drop_lost(double time) noexcept;
  void begin_tracks(double time, std::span<const Beam> beams, const RollingGrid& grid) noexcept;
  void begin_track(double time, const Eigen::Vector2d& sensor) noexcept;
  void mark_moving(std::span<Beam> beams) const noexcept;
  void emit() noexcept;
  [[nodiscard]] bool is_new(const Beam& beam, const RollingGrid& grid) const noexcept;

  PerceptionSettings settings_;
  std::vector<MovingTrack> tracks_;
  std::vector<int> owner_;                // track of each beam; -1 for none
  std::vector<Eigen::Vector2d> cluster_;  // points of the one being looked at
  std::vector<MovingObstacle> obstacles_;
  double time_ = -1.0;  // of the last scan
  int next_id_ = 0;
};

}  // namespace fairway
