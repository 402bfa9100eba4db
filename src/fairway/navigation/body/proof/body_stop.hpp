// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/map/body_clearance.hpp"
#include "fairway/navigation/body/proof/body_deviation.hpp"
#include "fairway/navigation/body/proof/body_separation.hpp"
#include "fairway/safety/stop_check.hpp"
#include "fairway/trajectory/drive_reference.hpp"

namespace fairway {

/// A sequence of inputs that brings a base to rest, one per control period.
struct BodyStop {
  static constexpr int kMostInputs = 256;

  BaseInput first;  ///< sent before `inputs`
  int count = 0;
  std::array<BaseInput, kMostInputs> inputs{};

  /// The input `periods` after `first` was sent, linear between those of whole periods; the last
  /// one stays.
  [[nodiscard]] BaseInput at(double periods) const noexcept;
};

/// Makes the stop along a drive: after `sent`, the rate falls to 0 as fast as the base allows. A
/// steered base therefore keeps the curvature of its drive. The last input is rest; `count` is 0
/// where that takes more than kMostInputs periods.
void make_stop(const BaseModel& base,
               const DriveReference& reference,
               const DriveProgress& progress,
               const BaseInput& sent,
               double period,
               BodyStop& stop) noexcept;

/// Makes the stop without a drive: all speeds fall in proportion, so the base keeps its curvature.
void make_braking_stop(const BaseModel& base,
                       const BaseInput& sent,
                       double period,
                       BodyStop& stop) noexcept;

/// What the check of a stop tests against.
struct StopSurroundings {
  const BodyClearance* clearance = nullptr;  ///< static obstacles and the body
  double margin = 0.0;                       ///< clearance kept from them [m]
  MovingSurroundings moving;
  bool may_turn = false;  ///< moving obstacles may also stop or turn back now
  bool goes_on = true;    ///< moving obstacles may keep their velocity
  /// Whether a zone's speed limit may be exceeded: by a robot that brakes as fast as it can.
  bool may_exceed_zone_speed = false;
};

/// Returns whether the body of every base of the family stays free over the manoeuvre and the stop
/// after it (docs/safety.md). Static obstacles and zones of the map are tested along the whole
/// motion, moving ones at half periods.
[[nodiscard]] StopVerdict check_stop(const BaseModel& base,
                                     const Pose2& pose,
                                     const BodyManoeuvre& manoeuvre,
                                     const BodyStop& stop,
                                     const StopSurroundings& surroundings) noexcept;

}  // namespace fairway
