// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "fairway/navigation/body/body_navigator.hpp"
#include "fairway/navigation/body/body_planning.hpp"
#include "fairway/navigation/body/body_surroundings.hpp"
#include "fairway/navigation/body/drive/drive_follower.hpp"
#include "fairway/navigation/cycle_timing.hpp"

namespace fairway {

inline constexpr double kDriveRowPeriod = 0.02;  ///< of a planned drive [s]

/// State of a BodyNavigator: the map, the goal, the drive, and when to plan another.
struct BodyNavigator::State {
  State(const Settings& settings, const RobotModel& robot, const PreparedMap* shared_map);

  void set_goal(const Goal& goal);
  void follow(const PosePath& path);
  void set_zones(const Zones& zones);
  void set_settings(const Settings& settings);
  void cancel() noexcept;
  void reset(const BaseInput& actual) noexcept;
  [[nodiscard]] NavigationStep update(const Measurements& m);
  void plan_if_needed(const Measurements& m, bool at_once);
  void note_place(const Measurements& m) noexcept;

  Settings settings;
  RobotModel robot;
  BodySurroundings around;
  DriveFollower follower;
  BodyControl control;
  BodyPlanning planning;
  Plan plan;
  [[nodiscard]] bool has_drive() const noexcept { return has_drive_; }
  [[nodiscard]] bool drives() const noexcept { return has_drive_ && goal_ && !reached_; }
  std::optional<PathPlace> place;  // on the path that is followed
  std::string why;                 // why there is no drive
  bool follows_new_plan = false;
  bool planned = false;

 private:
  [[nodiscard]] LimitingFactor check(const Measurements& m) noexcept;
  [[nodiscard]] LimitingFactor check_cycle(const Measurements& m) noexcept;
  [[nodiscard]] bool jumped(const Measurements& m) noexcept;
  [[nodiscard]] bool is_blocked() const noexcept;
  [[nodiscard]] bool at_goal(const Pose2& pose) const noexcept;
  [[nodiscard]] double retry_period() const noexcept;
  [[nodiscard]] bool needs_plan(const Measurements& m, bool at_once) const noexcept;
  void take_plan(const Measurements& m);
  [[nodiscard]] bool can_begin(const BodyPlan& made, const Measurements& m) const noexcept;
  [[nodiscard]] double ahead_of_plan() const noexcept;
  [[nodiscard]] bool keeps_driving(const Measurements& m) const noexcept;
  void meet_zone_speeds();
  [[nodiscard]] LimitingFactor zone_here(const Pose2& pose) const noexcept;
  [[nodiscard]] Measurements merged(const Measurements& m);
  [[nodiscard]] NavigationStep drive(const Measurements& m);
  [[nodiscard]] MovingSurroundings moving_around(const Measurements& m) const noexcept;
  [[nodiscard]] BodyPlanRequest request_for(const Measurements& m) const;
  [[nodiscard]] bool must_evade(const Measurements& m) const noexcept;
  void end_evasion(const Measurements& m) noexcept;
  void watch(const NavigationStep& step, double time) noexcept;
  [[nodiscard]] NavigationStep step_of(const BaseInput& input,
                                       NavigationStatus status,
                                       LimitingFactor limit) const noexcept;

  // Along a path.
  [[nodiscard]] bool extends_drive() const noexcept;
  GuideRequest along_;
  std::vector<double> arcs_;  // of the rows of the drive
  bool complete_ = true;      // the drive leads to the end of the path

  std::optional<Goal> goal_;
  bool goal_valid_ = true;
  bool has_drive_ = false;       // one for the present goal is followed
  bool wants_plan_ = false;      // the drive cannot be finished
  bool in_known_space_ = false;  // the next plan leads only through what was seen
  bool goal_is_new_ = false;
  bool reached_ = false;
  bool tried_moving_ = false;  // no drive that begins in motion was found since the last one
  int failures_ = 0;           // plans that failed, one after the other
  int goal_number_ = 0;
  int asked_number_ = 0;
  double plan_time_ = -std::numeric_limits<double>::infinity();
  bool evades_ = false;      // the next plan leads out of the way of an obstacle
  bool is_evading_ = false;  // the present drive does
  bool no_refuge_ = false;   // the last plan of that kind found none
  double evasion_time_ = -std::numeric_limits<double>::infinity();
  std::optional<double> waits_since_;   // for a moving obstacle, at standstill
  bool avoids_moving_ = false;          // the next plan drives round moving obstacles
  std::vector<MovingObstacle> moving_;  // of trackers and the own lidar
  struct Known {
    double time = 0.0;
    Pose2 pose;
    int strange = 0;  // poses in a row that do not follow from the ones before
  };
  std::optional<Known> known_;
  CycleTimer timer_;
};

}  // namespace fairway
