// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/footprint.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/safety/stop_motion.hpp"

namespace fairway {

/// The obstacles and margins against which a stop is checked.
struct CollisionEnvironment {
  const BitGrid* obstacles = nullptr;  ///< the newest static obstacles
  Footprint body;                      ///< the robot's true outline
  /// Clearance kept from static obstacles beyond the body [m]; where the family of motions needs
  /// more, that counts instead.
  double static_margin = 0.0;
  /// Whether the growth of a sweep (see check_stop) may use up the margin while the robot moves. It
  /// may not where the robot stops. Without this, a robot with no more clearance could not even
  /// turn to where it has more.
  bool margin_where_it_stands = false;
  /// Radius of a disc about the robot's centre that is kept free of static obstacles too [m]; 0:
  /// only the body counts. It keeps the robot from places where its body fits but cannot turn.
  double turning_radius = 0.0;
  MovingObstacles moving;      ///< assumed to keep their velocity until the robot has stopped
  double moving_age = 0.0;     ///< how long ago they were seen [s]
  bool predict_motion = true;  ///< false: they are assumed to keep their position
  double moving_margin = 0.0;  ///< distance kept from them beyond both radii [m]
  Fleet fleet{};               ///< other robots; each is held to the stop that it published
  double time = 0.0;           ///< now, on the fleet's clock [s]
  std::uint32_t robot = 0;     ///< the robot's own number in the fleet
};

/// Why a stop is not proven.
enum class StopVerdict : std::uint8_t {
  Free,
  HitsStatic,
  HitsMoving,
  EntersZone,   ///< a keep-out zone
  LeavesStrip,  ///< the union of the strips
  TooFast,      ///< for a zone with a speed limit
  WrongWay,     ///< against the direction of a one-way zone
};

/// Returns whether another manoeuvre after the same command cannot help: true for all but moving
/// obstacles.
[[nodiscard]] constexpr bool is_final(StopVerdict verdict) noexcept {
  return verdict != StopVerdict::Free && verdict != StopVerdict::HitsMoving;
}

/// How a stop ends.
struct StopOutcome {
  StopVerdict verdict = StopVerdict::Free;
  double time = 0.0;  ///< from now until it touches, or until the check ends [s]
};

/// Checks whether every base of the family stays free during the manoeuvre, until it has stopped.
/// If not, it says when the base touches. After the stop the check continues until `hold` seconds
/// from now.
///
/// First the disc that covers the robot is tested along the chords of short pieces, grown by their
/// sagittas. Static obstacles are tested exactly, moving ones by the nearest approach of two
/// straight motions. Where that disc touches and the body is no disc, the body itself is swept
/// along pieces in which it turns by no more than 0.02 rad. A rectangle is swept as the exact
/// rectangle that it covers while it moves straight, grown by the motion of its furthest corner in
/// half of the turn (3 mm for a corner at 0.3 m). Each piece is grown by the deviation of the
/// family of motions from the slow base.
///
/// The zones of the map hold for the whole manoeuvre. The body enters no keep-out and leaves no
/// strip for the contour; the centre leaves no strip for the centre. No base of the family is
/// faster than a zone allows that the covering disc touches, and the centre never moves against a
/// one-way zone.
[[nodiscard]] StopOutcome follow_stop(const Pose2& pose,
                                      const StopManoeuvre& manoeuvre,
                                      double hold,
                                      const CollisionEnvironment& surroundings) noexcept;

/// As above, for a base that ramps exactly linearly from each command to the next, every `dt` [s].
[[nodiscard]] StopOutcome follow_stop(const Pose2& pose,
                                      const Twist2& current,
                                      const Twist2& command,
                                      const StopSequence& stop,
                                      double dt,
                                      double hold,
                                      const CollisionEnvironment& surroundings) noexcept;

/// Returns the verdict of follow_stop without the look-ahead after standstill.
[[nodiscard]] StopVerdict check_stop(const Pose2& pose,
                                     const Twist2& current,
                                     const Twist2& command,
                                     const StopSequence& stop,
                                     double dt,
                                     const CollisionEnvironment& surroundings) noexcept;

/// Returns whether a message of the fleet came late: its robot may have committed to another stop
/// since.
[[nodiscard]] bool is_late(Fleet fleet) noexcept;

}  // namespace fairway
