// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/prediction/shared_motion.hpp"

namespace fairway::bridge {

/// The number of a robot that is known by its name: the same in every process.
[[nodiscard]] std::uint32_t robot_number(std::string_view name) noexcept;

/// What the other robots of a fleet have told of themselves.
///
/// One that falls silent is kept with what it told last, and ages: the navigator gives it the room
/// that it can have moved into since, and stops when it is older than `safety.tracks_timeout`.
/// It leaves the board only when it says so, or is too far away to matter.
class FleetBoard {
 public:
  /// Robots matter up to here, and further when they were silent: by what they can have driven [m].
  static constexpr double kRange = 15.0;

  /// Takes in what a robot tells, in the frame of this one; old news is ignored.
  void hear(const std::string& name, const SharedMotion& motion);

  /// A robot leaves the place, and says so.
  void forget(const std::string& name) { told_.erase(name); }

  /// Those that matter to a robot at `position` at `time` [s]; valid until the next call of any
  /// function.
  [[nodiscard]] Fleet around(const Eigen::Vector2d& position, double time);

 private:
  std::map<std::string, SharedMotion> told_;  // by name
  std::vector<FleetMember> around_;
};

}  // namespace fairway::bridge
