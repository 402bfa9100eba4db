// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "fairway/navigation/navigator.hpp"
#include "support/random/random_world.hpp"

namespace fairway::test {

/// The true state in a cycle.
struct Truth {
  double time = 0.0;
  Pose2 pose;
  std::vector<MovingObstacle> obstacles;
};

/// Turns the true state into the measurements of a robot with bad sensors. For some cycles at a
/// time an input is dropped (the last one repeats, with its stamp), late, not finite, displaced, or
/// missing.
class Faults {
 public:
  explicit Faults(Random& random) : random_(random) {}

  /// @param share  Share of cycles in which a fault begins.
  void begin_cycle(double share);

  /// The measured input; valid until the next call.
  [[nodiscard]] NavigationInput tell(const Truth& truth, const BitGrid& map);

  /// Whether wrong obstacle positions were measured less than `duration` seconds before `time`.
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
  std::vector<Truth> past_;  // the last states, oldest first
  Truth pose_told_;
  Truth tracks_told_;
  double wrong_tracks_ = -std::numeric_limits<double>::infinity();
  long count_ = 0;
};

}  // namespace fairway::test
