// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway::bridge {

/// Derives a robot's number from its name: the same in every process.
[[nodiscard]] std::uint32_t robot_number(std::string_view name) noexcept;

/// The motions that the other robots of a fleet have published.
///
/// The last motion of a silent robot stays and ages. The navigator extends its obstacle by the
/// distance that it can have driven since, and stops when the message is older than
/// `safety.tracks_timeout`. A robot is removed only when it announces its departure, or is too far
/// away to matter.
class FleetBoard {
 public:
  /// Robots within this distance matter; silent ones also further, by what they can have driven
  /// [m].
  static constexpr double kRange = 15.0;

  /// Messages may be stamped so far in the future, since clocks differ [s].
  static constexpr double kMostAhead = 0.5;

  /// Takes in what a robot publishes, in the frame of this one, at `now` [s].
  /// @return whether the message was plausible and not from the future. One that was not is
  ///     forgotten; the next good one counts. Older ones than the newest are ignored.
  bool receive(const std::string& name, const SharedMotion& motion, double now);

  /// Removes a robot that announced its departure.
  void forget(const std::string& name) { told_.erase(name); }

  /// The robots that matter at `position` and `time` [s]; valid until the next call of any
  /// function.
  [[nodiscard]] Fleet around(const Eigen::Vector2d& position, double time);

 private:
  std::map<std::string, SharedMotion> told_;  // by name
  std::vector<FleetMember> around_;
};

}  // namespace fairway::bridge
