// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/map/body_clearance.hpp"
#include "fairway/navigation/body/body_separation.hpp"
#include "fairway/safety/stop_check.hpp"
#include "fairway/trajectory/drive_reference.hpp"

namespace fairway {

/// A sequence of inputs that brings a base to rest, one per control period.
struct BodyStop {
  static constexpr int kMostInputs = 256;

  int count = 0;
  int next = 0;  ///< the first one that has not been sent yet
  std::array<BaseInput, kMostInputs> inputs{};

  [[nodiscard]] bool at_rest() const noexcept { return next >= count; }
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

/// Returns whether the body stays free from `sent` over `input` through the stop. The inputs are
/// linear between control periods. Static obstacles are tested along the whole motion, moving ones
/// at its periods and their middles. Zones of the map count.
///
/// @param held  Time by which the stop begins later than a period from now: `input` stays [s].
[[nodiscard]] StopVerdict check_stop(const BaseModel& base,
                                     const Pose2& pose,
                                     const BaseInput& sent,
                                     const BaseInput& input,
                                     const BodyStop& stop,
                                     double period,
                                     const StopSurroundings& surroundings,
                                     double held = 0.0) noexcept;

}  // namespace fairway
