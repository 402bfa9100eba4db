// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// An input that is sent now, when the stop after it begins, and what the base has reached.
struct BodyManoeuvre {
  BaseInput current;    ///< of a base that ramps evenly to each input, now
  BaseInput quick;      ///< of one that changes as hard as it can, now
  BaseInput input;      ///< sent now
  double period = 0.1;  ///< from each input of the stop to the next [s]
  double ramp = 0.0;    ///< in which the base ramps to `input` [s]; 0: a period
  double hold = 0.0;    ///< until the first input of the stop is sent [s]; 0: a period
  /// By how much later and earlier the base may follow at any time of the stop, where cycles are
  /// late or early [s].
  double later = 0.0;
  double earlier = 0.0;
  bool irregular = false;  ///< whether an input of the stop may come up to a period early
};

/// A short part of the motion of the slow base, which ramps evenly, and how far others of the
/// family of bases can be from it at its end (docs/safety.md).
struct BodyPiece {
  BaseInput from;
  BaseInput to;
  double duration = 0.0;     ///< [s]
  Eigen::Vector2d further;   ///< ahead in the direction of motion, in the body's frame [m]
  double apart = 0.0;        ///< along the path, in either direction [m]
  double aside = 0.0;        ///< across it [m]
  double turned = 0.0;       ///< of the heading [rad]
  double turned_late = 0.0;  ///< by which one that follows later is turned further, signed [rad]
  double bend = 0.0;         ///< curvature of a steered base [1/m]
  double bend_change = 0.0;  ///< by which it may differ from that [1/m]
};

/// Adds up what the family of bases deviates from the slow one: a quick base changes each speed as
/// hard as it can, and lateness may begin at any time, on one axis before the other.
class BodyDeviation {
 public:
  BodyDeviation(const BaseModel& base, const BodyManoeuvre& manoeuvre) noexcept;

  /// The next piece, in which the slow base ramps `from` one input `to` another.
  /// @param target  What the quick base is sent then.
  [[nodiscard]] BodyPiece next(const BaseInput& from,
                               const BaseInput& to,
                               const BaseInput& target,
                               double duration) noexcept;

 private:
  void spread(const PlanarTwist& slow, double duration, BodyPiece& piece) noexcept;

  BaseModel base_;
  BaseInput quick_;
  double later_;
  double both_;                                      // later and earlier
  Eigen::Vector2d along_ = Eigen::Vector2d::Zero();  // by which the quick base is ahead [m]
  double turned_ = 0.0;                              // by which it is turned further [rad]
  double aside_ = 0.0;                               // by which others may be beside it [m]
  PlanarTwist least_;                                // of the slow base so far, and of its input
  PlanarTwist greatest_;
};

/// The shortest time in which the base can change its input [s].
[[nodiscard]] double change_time(const BaseModel& base,
                                 const BaseInput& from,
                                 const BaseInput& to) noexcept;

/// The input of a base that changes as hard as it can, from `now` on towards `sent`.
[[nodiscard]] BaseInput quick_input(const BaseModel& base,
                                    const BaseInput& now,
                                    const BaseInput& sent,
                                    double time) noexcept;

}  // namespace fairway
