// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/safety/base_response.hpp"
#include "fairway/safety/braking_profile.hpp"

namespace fairway {

/// A command that is sent now, the commands after it, and their times.
struct StopManoeuvre {
  Twist2 current;  ///< of a slow base without delay and lag, now
  Twist2 command;  ///< sent now
  const StopSequence& stop;
  double period = 0.1;  ///< from each command of `stop` to the next [s]
  double ramp = 0.0;    ///< time in which the base ramps to `command` [s]; 0: a period
  double hold = 0.0;    ///< until the first command of `stop` is sent [s]; 0: a period
  /// By how much later and earlier the base may follow at any time of the stop, where cycles are
  /// late or early [s]. A base that follows late is further along the path.
  double later = 0.0;
  double earlier = 0.0;
  /// Whether cycles come earlier and later than a period: the base may then receive each command of
  /// `stop` up to a period early.
  bool irregular = false;
  /// Actuation of the base; null for one that ramps exactly linearly.
  const BaseActuation* actuation = nullptr;
  const BaseResponse* response = nullptr;  ///< of the base now; null where it is at `current`
  const CommandHistory* history =
      nullptr;        ///< commands that the delay still holds back; may be null
  double time = 0.0;  ///< now, in the times of the history [s]
};

/// A short piece of the motion, in which the slow base moves with a constant twist.
struct StopPiece {
  Twist2 mean;            ///< of the slow base
  double duration = 0.0;  ///< [s]
  double fastest = 0.0;   ///< greatest linear speed of any base of the family, without sign [m/s]
  /// How far any base of the family can be from the slow one, up to the end of the piece.
  double ahead = 0.0;   ///< along the path, in the direction of motion [m]
  double apart = 0.0;   ///< along the path, in either direction [m]
  double aside = 0.0;   ///< across it [m]
  double turned = 0.0;  ///< of its heading [rad]
  /// Between this motion and one that follows earlier or later there are others, whose heading and
  /// path are between theirs; so far apart are the two.
  double turned_between = 0.0;  ///< [rad]
  double aside_between = 0.0;   ///< [m]
};

/// Iterates over the family of motions of a manoeuvre, piece by piece, until every base of the
/// family has stopped.
class MotionFamily {
 public:
  explicit MotionFamily(const StopManoeuvre& manoeuvre) noexcept;

  /// Computes the next piece. @return false at the end.
  [[nodiscard]] bool next(StopPiece& piece) noexcept;

  /// Returns whether the last piece ended a control period, or the time for which the command is
  /// held.
  [[nodiscard]] bool at_command() const noexcept { return piece_ == 0; }

 private:
  [[nodiscard]] bool begin_segment() noexcept;
  [[nodiscard]] bool begin_tail() noexcept;
  void follow_late(double Twist2::*member,
                   const AxisActuation& axis,
                   Twist2& slow,
                   Twist2& quick) noexcept;
  [[nodiscard]] Twist2 ramped_at(double time) const noexcept;
  [[nodiscard]] Twist2 sent_at(double time) const noexcept;
  [[nodiscard]] double next_change(double time) const noexcept;
  [[nodiscard]] Twist2 stop_command(int k) const noexcept;
  [[nodiscard]] double fastest_in_piece(const BaseResponse& before) const noexcept;
  void deviate(const Twist2& quick, const Twist2& slow, double h, StopPiece& piece) noexcept;
  void spread(const Twist2& slow, double h, StopPiece& piece) noexcept;

  StopManoeuvre m_;
  BaseResponse response_;
  bool exact_ = true;   // neither delay nor lag
  int segment_ = -1;    // -1: the ramp to the command; 0: the hold; then the commands of the stop
  int piece_ = 0;       // within the segment
  int pieces_ = 0;      // of the segment
  double h_ = 0.0;      // of a piece of it [s]
  double start_ = 0.0;  // of the segment [s]
  double end_ = 0.0;    // of the segment [s]
  Twist2 from_;
  Twist2 to_;
  double along_ = 0.0;   // by which the quick base is ahead of the slow one [m]
  double turned_ = 0.0;  // by which it is turned further [rad]
  double aside_ = 0.0;   // by which it may be beside it [m]
  Twist2 least_;         // of the twists of the slow base so far, and of the command
  Twist2 greatest_;
  double between_ = 0.0;  // sum of what is `aside_between` [m]
};

}  // namespace fairway
