// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/navigation/body/control/drive_space.hpp"
#include "fairway/navigation/body/drive/drive_follower.hpp"
#include "fairway/navigation/body/guide/guide.hpp"
#include "fairway/planning/background_worker.hpp"
#include "fairway/planning/plan.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/trajectory/drive_planner.hpp"

namespace fairway {

/// A path that drives are planned along.
struct GuideRequest {
  std::shared_ptr<const Guide> guide;  ///< null: none
  double arc = 0.0;                    ///< of the robot on it [m]
  std::optional<double> bound{};       ///< greatest distance from it [m]
};

/// Request for a drive.
struct BodyPlanRequest {
  Pose2 start;
  Goal goal;
  bool stays_inside = false;             ///< a goal outside the map is replaced by one inside
  std::vector<MovingObstacle> standing;  ///< obstacles to drive round as if they were of the map
  double kept = 0.1;                     ///< distance kept from these [m]
  /// Whether to plan as if they were not there where they leave no path: they may go away.
  bool or_without = true;
  /// Whether a short drive out of the predicted motion of `coming` is asked for, not one to the
  /// goal.
  bool evades = false;
  std::vector<MovingObstacle> coming{};
  PredictionSettings prediction{};
  double age = 0.0;                   ///< of `coming` [s]
  std::vector<SharedMotion> fleet{};  ///< motions of other robots
  std::vector<double> unseen{};       ///< FleetMember::unseen of each [s]
  double time = 0.0;                  ///< now, on the fleet's clock [s]
  std::uint32_t robot = 0;            ///< number of the robot in the fleet
  /// What a robot in motion does until the drive begins, and the motion to rest from there on; see
  /// plan_drive. Both without steps for a robot at rest.
  DriveLead lead{};
  GuideRequest along{};
  double more_margin = 0.0;  ///< beyond what is tried first otherwise, for maps that flicker [m]
};

/// A drive to a goal, or the reason why there is none.
struct BodyPlan {
  Goal goal;
  Pose2 goal_pose;  ///< the goal with the heading that was selected
  DrivePlan drive;
  bool evasive = false;  ///< the drive leads out of the way of an obstacle
  bool moving = false;   ///< the drive begins in motion
  BaseInput begin{};     ///< with which it begins
  /// Along a path: the place of each row on it, and whether the drive leads to its end.
  std::vector<double> arcs{};
  bool complete = true;
  DriveSpace space{};  ///< free space along the drive
  std::string why{};   ///< why the drive does not lead to the end of the path
};

/// Settings of drives for a body: the cells of the search grow with the body.
[[nodiscard]] DriveSettings drive_settings_for(const BodyShape& body) noexcept;

/// Returns the headings for a goal that has none, the best one first. The best is that in which a
/// shortest path arrives; those around it follow. Only headings in which the body is free are
/// returned.
[[nodiscard]] std::vector<double> goal_headings(const BodyClearance& clearance,
                                                const BaseModel& base,
                                                const Pose2& start,
                                                const Eigen::Vector2d& goal);

/// Plans a drive on a map, around obstacles at standstill if possible.
[[nodiscard]] BodyPlan plan_body_drive(const PreparedMap& map,
                                       const RobotModel& robot,
                                       const BodyPlanRequest& request,
                                       double period,
                                       const DriveSettings& settings);

/// Plans a drive along a part of a path. Without a bound the robot may drive around what excludes
/// the path; within a bound it may not.
[[nodiscard]] BodyPlan plan_body_guide(const PreparedMap& map,
                                       const RobotModel& robot,
                                       const BodyPlanRequest& request,
                                       double period,
                                       const DriveSettings& settings);

/// Plans an evasion as requested; the drive has no rows where there is none.
[[nodiscard]] BodyPlan plan_body_evasion(const PreparedMap& map,
                                         const RobotModel& robot,
                                         const BodyPlanRequest& request,
                                         double period);

/// The plan in the form that pages, pictures and results show: the path of the reference point.
[[nodiscard]] Plan shown_plan(const BodyPlan& plan);

/// Makes the drives of one robot, in the control cycle or in a thread.
class BodyPlanning {
 public:
  BodyPlanning(const RobotModel& robot, double row_period, bool background);

  /// Whether the next plans are made in a thread.
  void set_background(bool background) noexcept { background_ = background; }

  [[nodiscard]] bool busy() const noexcept { return !worker_.idle(); }

  /// Makes a plan, or starts the thread that makes it; a thread works on a copy of the map. @pre
  /// not busy.
  void start(const PreparedMap& map, BodyPlanRequest request);

  /// The same on a map that is not prepared yet: the plan's job prepares it.
  void start(const BitGrid& bits, BodyPlanRequest request);

  /// Returns the plan once it is made.
  [[nodiscard]] std::optional<BodyPlan> take();

  void wait() const noexcept { worker_.wait(); }
  void lend_clock(std::function<double()> clock) { clock_ = std::move(clock); }

  /// Duration of the last plan [s].
  [[nodiscard]] double seconds() const noexcept { return seconds_; }

 private:
  void make(const PreparedMap& map);
  void make_on_bits();

  RobotModel robot_;
  double row_period_;
  bool background_;
  // The worker's while it runs.
  BodyPlanRequest request_;
  PreparedMap copy_;
  BitGrid bits_;
  std::optional<BodyPlan> made_;
  std::function<double()> clock_;
  double seconds_ = 0.0;
  BackgroundWorker worker_;  // last member: its job ends before the others are destroyed
};

}  // namespace fairway
