// SPDX-License-Identifier: Apache-2.0
#include "experiments/bodies/body_drive.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/navigation/body/body_navigator.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/trajectory/trajectory_tracker.hpp"

namespace fairway {

namespace {

constexpr double kPeriod = 0.02;  // control period and spacing of the rows [s]

// How a drive ended, from its rows: distance from the goal, limits, time.
std::string judge(const BodyTask& task, const BodyDrive& drive) {
  if (drive.collided) return "the body touched an obstacle";
  const DriveRow& last = drive.rows.back();
  if (drive.end_distance > task.tolerances.position || drive.end_turn > task.tolerances.heading)
    return fmt::format("the drive ended {:.3f} m and {:.3f} rad from the goal", drive.end_distance,
                       drive.end_turn);
  if (std::abs(last.twist.linear) > task.tolerances.linear ||
      std::abs(last.twist.lateral) > task.tolerances.linear ||
      std::abs(last.twist.angular) > task.tolerances.angular)
    return "the base was not at rest at the end";
  if (drive.time > task.time_limit)
    return fmt::format("the drive took {:.2f} s, the limit is {:.2f} s", drive.time,
                       task.time_limit);
  return "arrived";
}

// Distance between body and obstacles over all rows and the motions between them, proven: at most
// BodyClearance::kMotionTolerance too small.
double least_clearance(const BodyClearance& clearance, const std::vector<DriveRow>& rows) {
  constexpr double kFurthest = 2.0;     // [m]
  constexpr double kResolution = 1e-4;  // [m]
  double least = kFurthest;
  for (const DriveRow& row : rows) {
    if (clearance.is_free(row.pose, row.twist, kPeriod, least)) continue;
    double low = 0.0;
    while (least - low > kResolution) {
      const double middle = 0.5 * (low + least);
      (clearance.is_free(row.pose, row.twist, kPeriod, middle) ? low : least) = middle;
    }
    least = low;
  }
  return least;
}

double parking_cost(const BodyDrive& drive) {
  double sum = 100.0 * drive.time + 5.0 * drive.cusps;
  for (std::size_t k = 0; k + 1 < drive.rows.size(); ++k) {
    const BaseInput& now = drive.rows[k].input;
    const BaseInput& next = drive.rows[k + 1].input;
    const double acceleration = (next.linear - now.linear) / kPeriod;
    const double steering = now.linear * (next.turn - now.turn) / kPeriod;
    sum +=
        10.0 * kPeriod * (acceleration * acceleration + steering * steering + now.turn * now.turn);
  }
  return sum;
}

void measure(const BodyTask& task, const BodyClearance& clearance, BodyDrive& drive) {
  double gear = 0.0;
  for (const DriveRow& row : drive.rows) {
    drive.length += kPeriod * std::hypot(row.twist.linear, row.twist.lateral);
    if (!clearance.is_free(row.pose, row.twist, kPeriod, 0.0)) drive.collided = true;
    constexpr double kMoving = 1e-3;  // [m/s]
    if (std::abs(row.input.linear) < kMoving) continue;
    if (gear * row.input.linear < 0.0) ++drive.cusps;
    gear = row.input.linear;
  }
  const DriveRow& last = drive.rows.back();
  drive.time = last.time;
  drive.end_distance = (last.pose.position - task.goal.position).norm();
  drive.end_turn = std::abs(shortest_turn(last.pose.heading, task.goal.heading));
  drive.min_clearance = drive.collided ? 0.0 : least_clearance(clearance, drive.rows);
  drive.cost = parking_cost(drive);
  drive.reason = judge(task, drive);
  drive.success = drive.reason == "arrived";
}

// Drives a plant to the goal with a BodyNavigator, which plans again where it has to.
void drive_plant(const BodyTask& task,
                 BodyPlant& plant,
                 const std::function<double()>& clock,
                 BodyDrive& drive) {
  constexpr double kResponse = 0.04;  // of motors and servos [s]
  constexpr double kStill = 5e-3;     // [m/s], [rad/s]
  RobotModel robot{.body = task.body, .base = task.base};
  robot.base.response_time = kResponse;
  Settings settings;
  settings.navigation.control_period = kPeriod;
  settings.navigation.goal_tolerance = std::max(0.001, 0.8 * task.tolerances.position);
  settings.navigation.heading_tolerance = std::clamp(0.8 * task.tolerances.heading, 0.001, 3.0);
  const PreparedMap map(task.map);
  BodyNavigator navigator(settings, robot, map);
  navigator.lend_clock(clock);
  navigator.set_goal({.position = task.goal.position, .heading = wrap_to_pi(task.goal.heading)});
  static_cast<void>(navigator.plan_now({.time = 0.0, .pose = task.start}));
  drive.plan_seconds = navigator.planning_seconds();
  if (!navigator.plan().usable()) {
    drive.reason = navigator.plan().reason();
    return;
  }
  const bool steered = is_steered(task.base);
  Pose2 pose = plant.pose();
  BaseInput input;
  for (std::size_t k = 0;; ++k) {
    const double time = static_cast<double>(k) * kPeriod;
    const double before = clock();
    const NavigationStep step = navigator.update({.time = time, .pose = pose});
    drive.cycle_seconds.push_back(clock() - before - navigator.planning_seconds());
    input = {.linear = step.command.linear,
             .lateral = step.lateral,
             .turn = steered ? step.steering : step.command.angular};
    plant.advance(input, kPeriod);
    const Pose2 next = plant.pose();
    const PlanarTwist twist = (1.0 / kPeriod) * twist_between(pose, next);
    drive.rows.push_back({.time = time, .pose = pose, .input = input, .twist = twist});
    pose = next;
    if (plant.touched()) drive.collided = true;
    const bool rests = step.status == NavigationStatus::GoalReached &&
                       std::hypot(twist.linear, twist.lateral) < kStill &&
                       std::abs(twist.angular) < kStill;
    if (drive.collided || rests || time > task.time_limit) break;
  }
  const double end = static_cast<double>(drive.rows.size()) * kPeriod;
  drive.rows.push_back({.time = end, .pose = pose, .input = input, .twist = {}});
}

}  // namespace

BodyDrive drive_task(const BodyTask& task,
                     const DriveSettings& settings,
                     const std::function<double()>& clock,
                     const BodyPlantMaker& plant) {
  BodyDrive drive;
  drive.task = task.name;
  const BitGrid obstacles(task.map);
  const double begin = clock();
  const DistanceField distances(obstacles);
  const BodyClearance clearance(obstacles, distances, task.body);
  if (plant) {
    drive_plant(task, *plant(task), clock, drive);
    if (!drive.rows.empty()) measure(task, clearance, drive);
    return drive;
  }
  const DrivePlan plan = plan_drive(clearance, task.base, task.start, task.goal, kPeriod, settings);
  drive.plan_seconds = clock() - begin;
  if (plan.rows.empty()) {
    drive.reason = plan.path.reason();
    return drive;
  }
  TrajectoryTracker tracker(task.base, plan.rows, kPeriod);
  Pose2 pose = task.start;
  for (std::size_t k = 0; !tracker.finished(); ++k) {
    const double before = clock();
    const BaseInput input = tracker.update(pose);
    drive.cycle_seconds.push_back(clock() - before);
    const PlanarTwist twist = twist_of(task.base, input);
    drive.rows.push_back(
        {.time = static_cast<double>(k) * kPeriod, .pose = pose, .input = input, .twist = twist});
    pose = moved(pose, twist, kPeriod);
  }
  measure(task, clearance, drive);
  return drive;
}

std::string drive_csv(const BodyTask& task, const BodyDrive& drive) {
  const bool omni = task.base.kind == BaseKind::Omni;
  std::string text = omni ? "time,robot,x,y,heading,linear,angular,lateral\n"
                          : "time,robot,x,y,heading,linear,angular\n";
  for (const DriveRow& row : drive.rows) {
    text += fmt::format("{:.2f},robot,{:.9f},{:.9f},{:.9f},{:.9f},{:.9f}", row.time,
                        row.pose.position.x(), row.pose.position.y(), wrap_to_pi(row.pose.heading),
                        row.twist.linear, row.twist.angular);
    text += omni ? fmt::format(",{:.9f}\n", row.twist.lateral) : "\n";
  }
  return text;
}

}  // namespace fairway
