// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/fleet/retreat_search.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// Input of a FleetCoordinator in one cycle.
struct FleetCoordinatorInput {
  double speed_max = 0.0;   ///< greatest speed of the robot [m/s]
  double radius = 0.0;      ///< radius of the disc that covers the robot [m]
  bool stopped = false;     ///< whether the robot is at standstill
  double dt = 0.0;          ///< control period [s]
  std::uint32_t robot = 0;  ///< number of the robot in the fleet
  Fleet fleet;
  const BitGrid* obstacles = nullptr;
};

/// Coordinates a robot with other robots: roundabouts where paths meet, and priority in narrow
/// places.
///
/// Roundabouts: two paths meet if both robots, driving straight at full speed, would come too
/// close. If two robots meet nearly head-on, or three or more meet, each drives around the mean of
/// the meeting points, on a circle with enough clearance for all of them and with the centre on its
/// left. If roundabouts overlap, each robot adopts the largest that it receives, so that all use
/// the same. A robot that stops on a roundabout enlarges it. A robot leaves a roundabout when its
/// own path no longer crosses it.
///
/// Narrow places: if two robots meet head-on where they cannot pass each other, one of them steps
/// aside and waits. It is the one that can. If both can, it is the one further from the narrow
/// place, or at equal distance the one with the greater number. If neither can, the one with the
/// shorter retreat path to a passing place retreats there, or at equal length the one with the
/// greater number; a robot that is followed by another one uses the follower's retreat path if that
/// is longer. If two robots enter a narrow place in the same direction at the same time, the nearer
/// one goes first. A robot that has waited for long for robots that do not move tries to continue.
class FleetCoordinator {
 public:
  void reset() noexcept { *this = FleetCoordinator(); }

  /// Signals that the path to the goal has changed. A robot that waits for others continues to
  /// wait.
  void path_changed() noexcept { roundabout_ = {}; }

  /// Returns the path to follow: `path`, a roundabout or a retreat path.
  /// @param path  The robot's own path, from its position.
  /// @return The path to follow; valid until the next call.
  const ReferencePath& update(const ReferencePath& path,
                              const FleetCoordinatorInput& input) noexcept;

  [[nodiscard]] const Roundabout& roundabout() const noexcept { return roundabout_; }
  /// Returns whether the robot waits aside for others, or drives to the place where it will wait.
  [[nodiscard]] bool waits() const noexcept { return waits_; }
  [[nodiscard]] double distance_to_bottleneck() const noexcept { return distance_to_bottleneck_; }
  [[nodiscard]] bool can_step_aside() const noexcept { return can_step_aside_; }
  /// Length of the retreat path [m]; see SharedMotion::retreat_length.
  [[nodiscard]] double retreat_length() const noexcept { return retreat_length_; }

 private:
  [[nodiscard]] static Roundabout meet(const ReferencePath& path,
                                       const FleetCoordinatorInput& input) noexcept;
  void adopt_if_larger(const Roundabout& other) noexcept;
  [[nodiscard]] bool must_step_aside(const ReferencePath& path,
                                     const FleetCoordinatorInput& input) noexcept;
  [[nodiscard]] bool is_nearer(const SharedMotion& other, std::uint32_t robot) const noexcept;
  [[nodiscard]] bool has_priority_over(const SharedMotion& other,
                                       std::uint32_t robot) const noexcept;
  void update_retreat(const Eigen::Vector2d& here,
                      const PassingEnvironment& around,
                      double dt) noexcept;
  [[nodiscard]] double retreat_cost(const Eigen::Vector2d& here,
                                    const PassingEnvironment& around) noexcept;
  void follow_retreat(const Eigen::Vector2d& here) noexcept;

  Roundabout roundabout_;
  ReferencePath path_;
  double stopped_for_ = 0.0;   // time at standstill on the roundabout [s]
  RetreatPath retreat_;        // path to the place where it waits, or would wait
  bool waits_ = false;         // whether it follows that path, or waits at its end
  RetreatSearch search_;       // for such a path, a part per cycle
  double since_search_ = 1e9;  // time since the last search began [s]
  double retreat_length_ = 0.0;
  double distance_to_bottleneck_ = std::numeric_limits<double>::infinity();
  bool can_step_aside_ = true;
  double waited_ = 0.0;  // waiting time [s]; negative while it tries to continue
};

}  // namespace fairway
