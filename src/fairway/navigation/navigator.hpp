// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>

#include "fairway/mpc/control_solver.hpp"
#include "fairway/navigation/corridor_string.hpp"
#include "fairway/navigation/dead_reckoning.hpp"
#include "fairway/navigation/fleet_way.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/navigation/planner.hpp"
#include "fairway/navigation/recovery.hpp"
#include "fairway/navigation/safe_stop.hpp"
#include "fairway/navigation/starts.hpp"

namespace fairway {

/// What the navigator is told in a cycle. All times are on the caller's clock [s].
struct NavigationInput {
  double time = 0.0;             ///< now
  Pose2 pose;                    ///< of the robot, in the map's frame
  double pose_time = 0.0;        ///< when the pose was true
  MovingObstacles obstacles;     ///< what moves
  double obstacles_time = 0.0;   ///< when they were seen; irrelevant when there are none, unless
  bool obstacles_due = false;    ///< someone looks for them all the time: then "none" ages, too
  const BitGrid* map = nullptr;  ///< the newest static obstacles; must live through the call
  double map_time = 0.0;         ///< when they were seen; a fixed map is always as new as `time`
  Fleet fleet{};                 ///< what other robots told; they are not among the obstacles
  std::uint32_t robot = 0;       ///< its own number in the fleet
};

/// What the navigator answers.
struct NavigationStep {
  Twist2 command;  ///< to send until the next cycle; finite and within the limits
  NavigationStatus status = NavigationStatus::NoPlan;
  Limit limit = Limit::None;          ///< what limits the robot now
  bool wants_plan = false;            ///< ask a Planner for a new plan from here, then follow() it
  std::size_t rectangle = 0;          ///< the one the robot is in
  const MpcSolution* plan = nullptr;  ///< what it intends; valid until the next cycle; may be null
};

/// Drives one robot along a corridor: Algorithm 3, one call per control cycle.
///
/// Deterministic; no clock, no allocation, no exception in `update`. Not thread-safe.
class Navigator {
 public:
  /// Uses the structured interior-point solver.
  /// @throws std::invalid_argument unless validate(settings) holds.
  explicit Navigator(const Settings& settings);

  /// Uses a solver of the caller's, which must outlive it. Robots of one thread can share one.
  Navigator(const Settings& settings, ControlSolver& solver);

  /// Follows a plan from now on. An unusable plan leaves the robot without a way: it stands, and
  /// says so.
  void follow(Plan plan);

  /// Forgets the plan: the robot brakes to a stand.
  void cancel();

  /// Tells what the robot really does, where that differs from the last command: after a hold, a
  /// jump, or at the first cycle of a robot that moves already.
  void reset(const Twist2& actual = {}) noexcept;

  /// Runs one control cycle. Never fails: when no command can be shown to be safe, it brakes along
  /// the stop that was verified last, and the status and limit say why.
  [[nodiscard]] NavigationStep update(const NavigationInput& input) noexcept;

  /// What to tell the other robots after an update at `time` and `pose`: what it does in this cycle
  /// and would do after it, and what it intends.
  [[nodiscard]] SharedMotion share(std::uint32_t robot,
                                   double time,
                                   const Pose2& pose) const noexcept;

  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
  [[nodiscard]] const CorridorString& corridor() const noexcept { return corridor_; }
  [[nodiscard]] const Plan& plan() const noexcept { return plan_; }
  [[nodiscard]] const ControlProblem& problem() const noexcept { return problem_; }

 private:
  [[nodiscard]] NavigationStep cycle(const NavigationInput& input) noexcept;
  [[nodiscard]] Limit check(const NavigationInput& input) noexcept;
  [[nodiscard]] bool reached(const Pose2& pose) noexcept;
  [[nodiscard]] NavigationStep arrive(const NavigationInput& input) noexcept;
  void pose_problem(const NavigationInput& input) noexcept;
  void note_remaining() noexcept;
  [[nodiscard]] NavigationStep drive(const NavigationInput& input) noexcept;
  [[nodiscard]] NavigationStep recover(const NavigationInput& input, NavigationStep step) noexcept;
  [[nodiscard]] StopSituation situation(const NavigationInput& input) const noexcept;
  [[nodiscard]] NavigationStep stop_or_evade(const NavigationInput& input) noexcept;
  [[nodiscard]] NavigationStep stop(NavigationStatus status, Limit limit) noexcept;
  [[nodiscard]] StopSurroundings surroundings(const NavigationInput& input) const noexcept;

  Settings settings_;
  Footprint body_;
  std::unique_ptr<ControlSolver> own_solver_;
  ControlSolver* solver_;
  Plan plan_;
  CorridorString corridor_;
  FleetWay fleet_way_;
  StringAhead way_;  // the corridor's string, led round other robots
  ControlProblem problem_;
  MpcSolution solution_;  // of the last cycle; horizon 0 when there is none
  std::array<MpcSolution, 2> answers_;
  Twist2 sent_;         // in the last cycle
  Twist2 sent_before_;  // in the one before
  SafeStop stop_;
  DeadReckoning reckoning_;
  double goal_distance_ = 0.0;
  bool at_goal_ = false;
  double plan_time_ = -1.0;  // when the present plan was first driven on
  double remaining_ = std::numeric_limits<double>::infinity();  // in the last cycle [m]
  bool new_way_ = false;                                        // since then
  Recovery recovery_;
};

}  // namespace fairway
