// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

namespace fairway {

/// How the robot of a benchmark moves.
enum class Kinematics : std::uint8_t {
  Ours,   ///< a unicycle whose speeds ramp within the limits of the settings
  Jumps,  ///< a unicycle whose speeds jump to the command, by at most the limits (DS-RNN)
};

/// A person at one time, as a robot with perfect sight sees it.
struct SeenPerson {
  int id = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double radius = 0.25;                                ///< [m]
};

/// A row of a run: the pose at its time.
struct PeopleRow {
  double time = 0.0;  ///< since the start of the case [s]
  Pose2 pose;
};

/// A robot in an open place, driven by the library's navigator.
///
/// It estimates the velocity of a person from its present and past positions: the mean over the
/// last `window` seconds. A person who is seen for the first time is taken to stand.
class PeopleRobot {
 public:
  /// @param window  Time over which velocities are estimated, at least a control period [s].
  /// @param clock   Seconds of CPU time, for the duration of the cycles.
  /// @throws std::invalid_argument unless validate(settings) holds.
  PeopleRobot(const Settings& settings,
              Kinematics kinematics,
              const Pose2& start,
              const Eigen::Vector2d& goal,
              double window,
              std::function<double()> clock);

  /// Gives the robot what it remembers of the site; null for nothing. It must outlive the robot.
  void remember(const EntranceMap* entrances) noexcept { entrances_ = entrances; }

  /// Notes where people are without moving; for frames before the start.
  void watch(double time, std::span<const SeenPerson> people);

  /// Runs one control cycle at `time` and moves for a control period.
  void cycle(double time, std::span<const SeenPerson> people);

  [[nodiscard]] const Pose2& pose() const noexcept { return base_.pose; }
  [[nodiscard]] const std::vector<double>& cycle_seconds() const noexcept { return seconds_; }
  [[nodiscard]] const NavigationStep& step() const noexcept { return step_; }

 private:
  struct Sighting {
    double time = 0.0;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
  };

  MapNavigator navigator_;
  Kinematics kinematics_;
  double period_;
  UnicycleRobot base_;
  std::function<double()> clock_;
  double window_;
  std::unordered_map<int, std::vector<Sighting>> seen_;  // in the window, oldest first
  std::vector<MovingObstacle> obstacles_;
  const EntranceMap* entrances_ = nullptr;
  NavigationStep step_;
  std::vector<double> seconds_;
};

}  // namespace fairway
