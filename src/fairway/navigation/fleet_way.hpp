// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/passing_place.hpp"
#include "fairway/prediction/shared_motion.hpp"

namespace fairway {

/// What a FleetWay is told in a cycle.
struct FleetWayInput {
  double speed_max = 0.0;   ///< of the robot [m/s]
  double radius = 0.0;      ///< of the disc that covers it [m]
  bool standing = false;    ///< whether it stands
  double dt = 0.0;          ///< length of a cycle [s]
  std::uint32_t robot = 0;  ///< its number in the fleet
  Fleet fleet;
  const BitGrid* obstacles = nullptr;
};

/// The way of a robot among robots: where straight ways would meet, all go round the same point on
/// the same side.
///
/// Two ways meet where both robots, driving straight on at full speed, would come nearer than their
/// bodies and some room. Two that meet nearly head-on, or three and more, go round the mean of
/// where they meet, on a circle that has room for all of them. Of roundabouts that overlap each
/// robot takes the largest that it knows, so that all come to the same. Who stands on the way round
/// makes it wider. A roundabout is left when the straight way on no longer leads through it.
///
/// Where two ways meet head-on in a place too narrow to pass, one robot steps aside and waits: the
/// one that can, of two that can the one that is further from that place, of two as near the one
/// with the greater number. Who has waited for long tries to go on.
class FleetWay {
 public:
  void reset() noexcept { *this = FleetWay(); }

  /// @param string  The way of the robot alone, from where it is.
  /// @return The string to follow; lives until the next call.
  const StringAhead& update(const StringAhead& string, const FleetWayInput& input) noexcept;

  [[nodiscard]] const Roundabout& roundabout() const noexcept { return roundabout_; }
  [[nodiscard]] bool waits() const noexcept { return place_.has_value(); }
  [[nodiscard]] double to_narrow() const noexcept { return to_narrow_; }
  [[nodiscard]] bool can_step_aside() const noexcept { return can_step_aside_; }

 private:
  [[nodiscard]] static Roundabout meet(const StringAhead& string,
                                       const FleetWayInput& input) noexcept;
  void give_way_to(const Roundabout& other) noexcept;
  [[nodiscard]] bool steps_aside(const StringAhead& string, const FleetWayInput& input) noexcept;

  Roundabout roundabout_;
  StringAhead string_;
  double standing_ = 0.0;                 // on the way round [s]
  std::optional<Eigen::Vector2d> place_;  // to wait at
  double to_narrow_ = std::numeric_limits<double>::infinity();
  bool can_step_aside_ = true;
  double waited_ = 0.0;  // [s]; negative: not again yet
};

}  // namespace fairway
