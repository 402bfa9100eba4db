// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "fairway/navigation/navigator.hpp"
#include "support/random_world.hpp"

namespace fairway::test {

/// What was true in a cycle.
struct Truth {
  double time = 0.0;
  Pose2 pose;
  std::vector<MovingObstacle> obstacles;
};

/// Turns what is true into what a robot with bad sensors is told: for some cycles at a time an
/// input is dropped (the last one comes again, with its stamp), late, not finite, jumps, or misses.
class Faults {
 public:
  explicit Faults(Random& random) : random_(random) {}

  /// @param share  Of cycles in which a fault begins.
  void begin_cycle(double share);

  /// The input as it is told; valid until the next call.
  [[nodiscard]] NavigationInput tell(const Truth& truth, const BitGrid& map);

  /// Whether obstacles were told where they are not, less than `duration` seconds before `time`.
  [[nodiscard]] bool told_wrong_tracks(double time, double duration) const {
    return time - wrong_tracks_ < duration;
  }

  [[nodiscard]] long count() const { return count_; }

 private:
  enum class Kind {
    None,
    DroppedPose,
    LatePose,
    BadPose,
    JumpingPose,
    BadTime,
    NoMap,
    OldMap,
    DroppedTracks,
    LateTracks,
    BadTracks,
    JumpingTracks,
  };

  [[nodiscard]] double bad_number();

  Random& random_;
  Kind kind_ = Kind::None;
  int left_ = 0;  // cycles
  Eigen::Vector2d jump_ = Eigen::Vector2d::Zero();
  std::vector<Truth> past_;  // the last cycles, oldest first
  Truth pose_told_;
  Truth tracks_told_;
  double wrong_tracks_ = -std::numeric_limits<double>::infinity();
  long count_ = 0;
};

}  // namespace fairway::test
