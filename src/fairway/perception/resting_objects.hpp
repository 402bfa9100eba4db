// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "fairway/perception/object/moving_track.hpp"
#include "fairway/perception/perception_settings.hpp"

namespace fairway {

/// Round objects at rest, whose cells of the grid are static by evidence: posts, and people who
/// stand.
///
/// The place of each is the mean of many scans, so that a small departure from it is noticed. Its
/// cells cannot show that: a person who sets off covers most of the same cells for long. Does not
/// allocate after construction; deterministic.
class RestingObjects {
 public:
  explicit RestingObjects(const PerceptionSettings& settings);

  /// Begins a scan: predicts all objects `dt` [s] ahead, and forgets those that are out of view.
  void begin_scan(double time, double dt) noexcept;

  /// Corrects the objects to which a cluster of points belongs, in the order of their beams.
  /// @return whether there are such objects.
  [[nodiscard]] bool observe(std::span<const Eigen::Vector2d> cluster,
                             const Eigen::Vector2d& sensor) noexcept;

  /// Begins an object whose cells are static, if the cluster is round. Two that
  /// overlap are split at their waist.
  void begin(std::span<const Eigen::Vector2d> cluster, const Eigen::Vector2d& sensor) noexcept;

  /// Removes an object that has left its place in this scan, and returns its track: `born_at` is
  /// its place, `born_time` the time when it was last there. Null if there is none. The result is
  /// valid until the next call.
  [[nodiscard]] const MovingTrack* take_departed() noexcept;

  [[nodiscard]] std::span<const MovingTrack> objects() const noexcept { return objects_; }

 private:
  [[nodiscard]] std::size_t nearest_outline(const Eigen::Vector2d& point,
                                            const Eigen::Vector2d& sensor) const noexcept;
  void correct(MovingTrack& object, const Eigen::Vector2d& sensor) noexcept;
  [[nodiscard]] bool is_known(const Eigen::Vector2d& center) const noexcept;

  PerceptionSettings settings_;
  std::vector<MovingTrack> objects_;
  std::vector<std::size_t> near_;        // those near the cluster
  std::vector<Eigen::Vector2d> points_;  // of one object
  MovingTrack departed_;
  double time_ = 0.0;       // of the scan [s]
  unsigned int scans_ = 0;  // may wrap around
};

}  // namespace fairway
