// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include "fairway/fleet/fleet_coordinator.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/cycle_timing.hpp"
#include "fairway/navigation/dead_reckoning.hpp"
#include "fairway/navigation/goal_check.hpp"
#include "fairway/navigation/input_check.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/navigation/recovery_behaviour.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/safety/safe_stop.hpp"
#include "fairway/tracking/candidate_solver.hpp"
#include "fairway/tracking/corridor_follower.hpp"
#include "fairway/tracking/space_time/space_time_planner.hpp"
#include "fairway/tracking/zone_speeds.hpp"

namespace fairway {

/// Drives one robot along a corridor: Algorithm 3, one call per control cycle.
///
/// Deterministic; no clock, no allocation, no exception in `update`. Not thread-safe.
class Navigator {
 public:
  /// Uses the structured interior-point solver.
  /// @throws std::invalid_argument unless validate(settings) holds.
  explicit Navigator(const Settings& settings);

  /// Uses a solver of the caller's, which must outlive it. Robots of one thread can share one, and
  /// then share the memory of their plans in space and time.
  /// @throws std::invalid_argument unless validate(settings) holds.
  Navigator(const Settings& settings, ControlSolver& solver);

  /// Follows a plan from now on. With an unusable plan, or one that was made for a smaller robot,
  /// the robot brakes and stays stopped.
  void follow(Plan plan);

  /// Forgets the plan: the robot brakes to a standstill.
  void cancel();

  /// Sets the actual twist of the robot, where it differs from the last command. This is so after a
  /// pause, after a jump of the pose, or if the robot already moves in the first cycle.
  void reset(const Twist2& actual = {}) noexcept;

  /// Sets the command that was really sent in the last cycle, where a later check has changed it.
  /// The commands before it are kept: a base with a delay has still to execute them.
  void replace_last(const Twist2& sent) noexcept;

  /// Continues the motion of a navigator with other settings: what was sent, and the cycles.
  void continue_from(const Navigator& older) noexcept;

  /// Runs one control cycle. Never fails: when no command can be shown to be safe, it brakes along
  /// the stop that was verified last, and the status and limit say why.
  [[nodiscard]] NavigationStep update(const NavigationInput& input) noexcept;

  /// Makes the message to the other robots after an update at `time` and `pose`. It holds the
  /// motion of this cycle, the stop after it, and the intended path.
  [[nodiscard]] SharedMotion share(std::uint32_t robot,
                                   double time,
                                   const Pose2& pose) const noexcept;

  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
  [[nodiscard]] const CorridorFollower& corridor() const noexcept { return corridor_; }
  [[nodiscard]] const Plan& plan() const noexcept { return plan_; }
  [[nodiscard]] const ControlProblem& problem() const noexcept { return problem_; }

 private:
  Navigator(const Settings& settings, std::unique_ptr<ControlSolver> own, ControlSolver* other);

  [[nodiscard]] static std::shared_ptr<SpaceTimeWorkspace> shared_memory(ControlSolver& solver);
  void begin_cycle(double time) noexcept;
  void end_cycle(double time, const Twist2& command) noexcept;
  [[nodiscard]] Twist2 ramps_to(const Twist2& command) const noexcept;
  [[nodiscard]] NavigationStep cycle(const NavigationInput& input) noexcept;
  [[nodiscard]] LimitingFactor check_timing() const noexcept;
  [[nodiscard]] NavigationStep without_plan(const NavigationInput& input) noexcept;
  [[nodiscard]] NavigationStep arrive(const NavigationInput& input) noexcept;
  void note_remaining() noexcept;
  void coordinate(const NavigationInput& input) noexcept;
  void pose_problem(const NavigationInput& input) noexcept;
  [[nodiscard]] NavigationStep stay_on_hold() noexcept;
  void find_zone_speeds(const NavigationInput& input) noexcept;
  void limit_speed(const NavigationInput& input) noexcept;
  void name_limits(const NavigationInput& input, NavigationStep& step) const noexcept;
  void plan_encounters(const NavigationInput& input) noexcept;
  [[nodiscard]] NavigationStep drive(const NavigationInput& input) noexcept;
  [[nodiscard]] NavigationStep send(std::size_t candidate,
                                    std::span<const Twist2> commands) noexcept;
  [[nodiscard]] std::optional<Twist2> slower_command() noexcept;
  [[nodiscard]] NavigationStep recover(const NavigationInput& input, NavigationStep step) noexcept;
  [[nodiscard]] NavigationStep stop_or_evade(const NavigationInput& input) noexcept;
  [[nodiscard]] NavigationStep stop(NavigationStatus status, LimitingFactor limit) noexcept;
  [[nodiscard]] StopSituation situation(const NavigationInput& input) const noexcept;
  [[nodiscard]] std::span<const Twist2> commands_of(const MpcSolution& answer) noexcept;

  [[nodiscard]] Twist2 limited(const Twist2& wanted) const noexcept;

  static constexpr double kStoppedSpeed = 0.02;  // [m/s] and [rad/s]; slower is a standstill
  [[nodiscard]] static bool has_stopped(const Twist2& twist) noexcept {
    return std::abs(twist.linear) < kStoppedSpeed && std::abs(twist.angular) < kStoppedSpeed;
  }

  Settings settings_;
  double period_;       // from one command to the next, as it should be [s]
  double longest_;      // until the next command, as the proof covers it [s]
  double lag_;          // until the base follows a command, without its delay [s]
  BaseActuation base_;  // what it can do
  double dead_time_;    // until it answers to a command [s]
  Footprint body_;
  std::unique_ptr<ControlSolver> own_solver_;
  ControlSolver* solver_;
  Plan plan_;
  CorridorFollower corridor_;
  FleetCoordinator fleet_;
  SpaceTimePlanner encounters_;
  ReferencePath path_;           // the corridor's reference path, or the detour around other robots
  PathSpeedLimits zone_speeds_;  // along that path
  bool in_speed_zone_ = false;   // a zone limits the speed in this cycle, here or ahead
  ControlProblem problem_;
  MpcSolution solution_;  // of the last cycle; horizon 0 when there is none
  Candidates candidates_;
  std::array<Twist2, kMaxHorizon> commands_;  // of a candidate, per control period
  Twist2 sent_;                               // in the last cycle
  Twist2 sent_before_;                        // in the one before
  bool remembers_sent_ = false;               // the history has it
  CycleTimer timer_;
  CycleTiming timing_;     // of this cycle
  double step_;            // in which the base is to reach the command of this cycle [s]
  Twist2 current_;         // to which a slow base without delay has ramped now
  BaseResponse response_;  // of the base now
  Pose2 ahead_;            // where the robot will be when it answers to the command of this cycle
  SafeStop stop_;
  DeadReckoning reckoning_;
  GoalCheck goal_check_;
  double plan_time_ = -1.0;  // when the present plan was first driven on
  double remaining_ = std::numeric_limits<double>::infinity();  // in the last cycle [m]
  bool plan_is_too_small_ = false;
  bool new_path_ = false;  // since then
  RecoveryBehaviour recovery_;
};

}  // namespace fairway
