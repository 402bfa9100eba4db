// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/footprint.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/prediction/shared_motion.hpp"
#include "fairway/safety/stop_motion.hpp"

namespace fairway {

/// What a stop is checked against.
struct CollisionEnvironment {
  const BitGrid* obstacles = nullptr;  ///< the newest static obstacles
  Footprint body;                      ///< the true one
  /// Clearance kept from static obstacles beyond the body [m], or what the family of motions needs
  /// where that is more.
  double static_margin = 0.0;
  /// What a sweep of the body is grown by (see check_stop) may use up the margin while the robot
  /// moves, but not where it stops: without that, one without more clearance could not even turn
  /// to where it has some.
  bool margin_where_it_stands = false;
  /// Disc about the robot's centre that keeps free of static obstacles too, so that a robot does
  /// not go where it could not turn, though its body would fit [m]; 0: the body alone counts.
  double turning_radius = 0.0;
  MovingObstacles moving;      ///< assumed to keep their velocity until the robot has stopped
  double moving_age = 0.0;     ///< how long ago they were seen [s]
  bool predict_motion = true;  ///< false: they are assumed to stand still
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

/// Whether another manoeuvre after the same command cannot help: everything but moving obstacles.
[[nodiscard]] constexpr bool is_final(StopVerdict verdict) noexcept {
  return verdict != StopVerdict::Free && verdict != StopVerdict::HitsMoving;
}

/// How a stop ends.
struct StopOutcome {
  StopVerdict verdict = StopVerdict::Free;
  double time = 0.0;  ///< from now until it touches, or until the check ends [s]
};

/// Whether every base of the family keeps free while it executes the manoeuvre, until it has
/// stopped; and when it does not. Looks on until `hold` seconds from now while the robot stands.
///
/// First the disc that covers the robot is tested along the chords of short pieces, grown by their
/// sagittas: static obstacles exactly, moving ones by the nearest approach of two straight motions.
/// Where that disc touches and the body is no disc, the body itself is swept along pieces in which
/// it turns by no more than 0.02 rad, a rectangle as the exact rectangle that it covers while it
/// moves straight, grown by as much as its furthest corner moves in half of the turn (3 mm for a
/// corner at 0.3 m). What the family of motions deviates from the slow base is added to each.
///
/// The zones of the map hold for all of it: the body enters no keep-out and leaves no strip for the
/// contour, the centre none for the centre, no base of the family is faster than a zone allows that
/// the covering disc touches, and the centre never moves against a one-way zone.
[[nodiscard]] StopOutcome follow_stop(const Pose2& pose,
                                      const StopManoeuvre& manoeuvre,
                                      double hold,
                                      const CollisionEnvironment& surroundings) noexcept;

/// The same for a base that ramps exactly linearly from each command to the next, every `dt` [s].
[[nodiscard]] StopOutcome follow_stop(const Pose2& pose,
                                      const Twist2& current,
                                      const Twist2& command,
                                      const StopSequence& stop,
                                      double dt,
                                      double hold,
                                      const CollisionEnvironment& surroundings) noexcept;

/// The verdict of follow_stop, without looking on after standstill.
[[nodiscard]] StopVerdict check_stop(const Pose2& pose,
                                     const Twist2& current,
                                     const Twist2& command,
                                     const StopSequence& stop,
                                     double dt,
                                     const CollisionEnvironment& surroundings) noexcept;

/// Whether a message of the fleet came late, so that its robot may be committed otherwise by now.
[[nodiscard]] bool is_late(Fleet fleet) noexcept;

}  // namespace fairway
