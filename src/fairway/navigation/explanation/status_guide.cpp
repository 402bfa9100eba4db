// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/explanation/status_guide.hpp"

namespace fairway {

StatusGuide guide_of(NavigationStatus value) noexcept {
  switch (value) {
    case NavigationStatus::Ok:
      return {.meaning = "The robot drives on its plan, or turns to the heading of its goal.",
              .causes = "Normal operation.",
              .remedy = "If it is slower than you expect, read the limiting factor."};
    case NavigationStatus::Degraded:
      return {.meaning =
                  "The robot drives, but the best answer of the solver was not usable: a soft "
                  "constraint is violated by more than 1 mm, the second answer was sent, or the "
                  "robot evades a moving obstacle.",
              .causes =
                  "A moving obstacle comes closer than its margin; the robot was pushed to the side"
                  " of its corridor; a sharp turn at high speed.",
              .remedy =
                  "Nothing, if it lasts a few cycles. If it is frequent: lower `robot.linear_max`, "
                  "raise `prediction.obstacle_margin`, or check that the limits in the settings are"
                  " those of the base."};
    case NavigationStatus::Stopping:
      return {
          .meaning =
              "The robot executes the stop that was verified last, because no new command could"
              " be proven safe.",
          .causes =
              "An obstacle appeared closer than the braking distance; the robot was pushed out of "
              "its corridor. The limiting factor says which.",
          .remedy =
              "Nothing, if it lasts a few cycles. If it is frequent, read the limiting factor: "
              "the robot sees obstacles too late, or the place is too narrow."};
    case NavigationStatus::Blocked:
      return {.meaning =
                  "The robot is at standstill and no recovery is possible in this cycle, or the "
                  "plan ends before the goal.",
              .causes =
                  "An obstacle closes the path; another robot waits at the same place; the goal "
                  "cannot be reached with what is known now.",
              .remedy =
                  "Remove the obstacle or wait: the navigator plans again every "
                  "`planning.retry_period`. Set `navigation.patience` to drop the goal after a "
                  "time."};
    case NavigationStatus::Recovering:
      return {.meaning =
                  "The robot turns towards its path, backs out, or turns to where its body has more"
                  " clearance.",
              .causes =
                  "It was at standstill for `navigation.stall_timeout`, or made no progress for "
                  "five times as long.",
              .remedy =
                  "Nothing. If it happens often at one place, that place is too narrow for the "
                  "margins: see docs/how_to/tuning.md."};
    case NavigationStatus::Stale:
      return {
          .meaning =
              "An input is older than its timeout, or its time lies in the future: the robot "
              "stops. It drives on when the input is new again.",
          .causes = "A sensor, the localisation or the network stopped; times of different clocks.",
          .remedy =
              "The limiting factor names the input. Compare its time with the clock of the "
              "cycle."};
    case NavigationStatus::BadInput:
      return {.meaning = "An input is not finite or cannot be right: the robot stops.",
              .causes =
                  "Headings in degrees; a division by zero in localisation; a tracker that has not "
                  "converged; a pose that jumps. The limiting factor names the input.",
              .remedy = "Correct the program or sensor that gives the input."};
    case NavigationStatus::Infeasible:
      return {
          .meaning = "The solver has no usable answer: the robot stops.",
          .causes = "The numbers of the control problem are not finite or contradict each other.",
          .remedy =
              "Report it with a recording (`--log`); this should not occur with valid settings."};
    case NavigationStatus::NoPlan:
      return {.meaning =
                  "The robot has no goal, or there is no path or no corridor to the goal: it is "
                  "stopped.",
              .causes =
                  "No goal was set; the goal lies inside an obstacle; every passage is too narrow; "
                  "the plan was made for a smaller robot.",
              .remedy =
                  "Read `navigator.plan().reason()` or the message of the tool; see statuses of a "
                  "path. The navigator plans again every `planning.retry_period`."};
    case NavigationStatus::GoalReached:
      return {.meaning =
                  "The robot is at the goal: within `navigation.goal_tolerance`, at standstill, and"
                  " turned to the goal's heading if it has one.",
              .causes = "",
              .remedy = ""};
    case NavigationStatus::Planning:
      return {.meaning =
                  "The first plan to a goal is being made in the background: the robot is stopped.",
              .causes =
                  "A new goal with `planning.background: true`; at the old goal right after a new "
                  "one was set.",
              .remedy = "Wait for some cycles."};
    case NavigationStatus::GaveUp:
      return {.meaning =
                  "The robot made no progress for `navigation.patience`; the goal was dropped and "
                  "the robot is stopped.",
              .causes =
                  "An obstacle closes the path; another robot waits at the same place; the goal "
                  "cannot be reached with what is known now.",
              .remedy = "Remove the obstacle; then set another goal, or the same one again."};
    case NavigationStatus::Holding:
      return {.meaning = "The robot brakes along its corridor, or is stopped; the goal is kept.",
              .causes = "`hold` was called.",
              .remedy = "Call `resume`: the robot drives on."};
  }
  return {};
}

StatusGuide guide_of(LimitingFactor value) noexcept {
  switch (value) {
    case LimitingFactor::None:
      return {.meaning = "Nothing holds the robot back.",
              .causes = "Normal operation on a free stretch; the robot is at its goal.",
              .remedy = ""};
    case LimitingFactor::Speed:
      return {.meaning = "`robot.linear_min`, `robot.linear_max` or `robot.angular_max` is active.",
              .causes = "Normal operation: the robot drives as fast as it may.",
              .remedy = "Raise the limit if the base can do more."};
    case LimitingFactor::Acceleration:
      return {.meaning =
                  "`robot.linear_acceleration_max` or `robot.angular_acceleration_max` is active.",
              .causes = "Starting, braking and turning.",
              .remedy = "Raise the limit if the base can do more."};
    case LimitingFactor::Corridor:
      return {.meaning = "A side of the rectangle holds the robot back.",
              .causes = "Corners and narrow places.",
              .remedy =
                  "Normal. For fewer of them lower `path.margin`, or raise `path.comfort_weight` so"
                  " that paths keep more clearance."};
    case LimitingFactor::MovingObstacle:
      return {
          .meaning = "The barrier of a moving obstacle, or of another robot, holds the robot back.",
          .causes = "A person or a cart crosses the path.",
          .remedy =
              "Normal. Lower `prediction.obstacle_margin` or `prediction.obstacle_growth` to "
              "pass closer."};
    case LimitingFactor::StopNotProven:
      return {
          .meaning =
              "No new command could be shown to leave a free stop. The robot follows the stop "
              "that was proven last.",
          .causes =
              "An obstacle appeared closer than the braking distance; the clearance is smaller "
              "than `safety.stop_margin`; a body larger than the disc that plans were made for.",
          .remedy =
              "If it occurs at standstill: check `robot.radius`, `robot.length` and "
              "`robot.width`, and the clearance at that place. If it occurs at speed: the robot"
              " sees obstacles too late for `robot.linear_max`."};
    case LimitingFactor::OutsideCorridor:
      return {
          .meaning =
              "The robot is in no rectangle of its corridor. The navigator requests a new plan.",
          .causes = "The robot was pushed or slipped; the pose was corrected by localisation.",
          .remedy = "Normal, if it lasts one or two cycles."};
    case LimitingFactor::StalePose:
      return {
          .meaning =
              "The pose is older than `safety.pose_timeout`, or its time is not finite or lies "
              "in the future.",
          .causes = "Odometry or localisation stopped; the pose carries the time of another clock.",
          .remedy = "Check the source; raise the timeout only if the base can bridge the gap."};
    case LimitingFactor::StaleMap:
      return {.meaning =
                  "There is no map, or the changing map is older than `safety.map_timeout`. With a "
                  "lidar this is the age of the last scan.",
              .causes = "The lidar or the map server stopped; no map was set.",
              .remedy =
                  "Check the lidar or the map server; raise the timeout only if the surroundings "
                  "change slowly. A fixed map needs no `map_time`."};
    case LimitingFactor::StaleTracks:
      return {.meaning =
                  "The moving obstacles, or a message of another robot, are older than "
                  "`safety.tracks_timeout`.",
              .causes = "The tracker or the radio stopped.",
              .remedy =
                  "Check the tracker or the radio. Leave `obstacles_due` false if your tracker "
                  "publishes only while it sees something."};
    case LimitingFactor::InvalidPose:
      return {.meaning = "The pose or the time is not finite, or the heading is beyond 64 rad.",
              .causes = "Headings in degrees; a division by zero in localisation.",
              .remedy = "Give metres and radians."};
    case LimitingFactor::InvalidTracks:
      return {
          .meaning =
              "A moving obstacle or a message of another robot is not finite, or has a negative"
              " radius.",
          .causes = "A tracker that has not converged.",
          .remedy = "Remove such obstacles from the list before the cycle, or repair the tracker."};
    case LimitingFactor::PoseJump:
      return {.meaning =
                  "The pose is further than `safety.pose_jump` (and half of the distance driven "
                  "since) from where the commands lead. It is accepted after it agreed with itself "
                  "for 0.5 s while the robot is stopped.",
              .causes = "Localisation jumps; the robot was carried; wheels slip.",
              .remedy =
                  "Call `reset` after the robot was moved by other means. Raise `safety.pose_jump` "
                  "if your localisation corrects by larger steps."};
    case LimitingFactor::SolverFailed:
      return {
          .meaning = "The solver has no usable answer.",
          .causes = "The numbers of the control problem are not finite or contradict each other.",
          .remedy =
              "Report it with a recording (`--log`); this should not occur with valid settings."};
    case LimitingFactor::NoPath:
      return {
          .meaning =
              "There is no plan: no goal, no path, no corridor, or the plan ends before the "
              "goal.",
          .causes =
              "No goal was set; the goal lies inside an obstacle; every passage is too narrow.",
          .remedy =
              "Read the sentence beside the status, which names the narrowest gap of the best "
              "route. Open that passage, or lower `path.margin` if the body is smaller than the "
              "settings say."};
    case LimitingFactor::InvalidGoal:
      return {.meaning = "The goal is not finite, or its heading is beyond 2 pi.",
              .causes = "Headings in degrees.",
              .remedy = "Give metres and radians."};
    case LimitingFactor::InvalidTime:
      return {.meaning =
                  "The time of a cycle is not later than the one before, or more than 100 "
                  "control periods later: the robot stops.",
              .causes =
                  "Times in milliseconds; a clock that stops, jumps or runs "
                  "backwards.",
              .remedy = "Give the seconds of one monotonic clock, the same for all inputs."};
    case LimitingFactor::SmallerPlan:
      return {
          .meaning =
              "The plan's corridor is free for a disc that is clearly smaller than "
              "`robot.radius`.",
          .causes = "A plan that was made with other settings was given to `Navigator::follow`.",
          .remedy = "Make the plan with the settings of the navigator."};
    case LimitingFactor::InvalidScan:
      return {.meaning =
                  "The last scan was refused, since a number of it is not finite or absurd; the "
                  "robot stops as without a scan.",
              .causes =
                  "A driver that fills `angle_min`, `angle_increment` or `range_max` wrongly; a "
                  "transform of the sensor that is not finite.",
              .remedy = "Repair the driver, or the description of the robot."};
    case LimitingFactor::LateCycle:
      return {.meaning =
                  "The cycle came later than `safety.longest_hold` control periods after the one "
                  "before, longer than the stop was proven for: the robot brakes.",
              .causes = "A computer that is too busy; a control loop without real-time priority.",
              .remedy =
                  "Call `update` in time. Raise `safety.longest_hold` if late cycles cannot "
                  "be avoided: the robot then keeps more distance. The base needs a "
                  "watchdog: see docs/safety.md."};
    case LimitingFactor::KeepOutZone:
      return {.meaning =
                  "The stop after every new command would enter a keep-out zone. The robot follows "
                  "the stop that was proven last.",
              .causes = "A zone was set in front of the robot or over it; the robot was pushed.",
              .remedy =
                  "Normal, if it lasts a few cycles. A robot inside a keep-out zone stays there: "
                  "remove the zone, or move the robot by other means."};
    case LimitingFactor::Strip:
      return {
          .meaning =
              "The stop after every new command would leave the strips, or the robot is outside "
              "of them.",
          .causes =
              "New strips do not contain the robot; strips that do not overlap where one is to "
              "follow the other; the robot was pushed.",
          .remedy = "Set strips that contain the robot and overlap along its path."};
    case LimitingFactor::SpeedZone:
      return {.meaning = "The speed limit of a zone holds the robot back, here or ahead.",
              .causes = "Normal operation.",
              .remedy = "Nothing; the limit is met before the body enters the zone."};
    case LimitingFactor::OneWayZone:
      return {.meaning = "Every new command would go against the direction of a one-way zone.",
              .causes = "The zone was set around a robot that drives against it.",
              .remedy = "Normal, if it lasts a few cycles: the robot plans another path."};
    case LimitingFactor::Hold:
      return {.meaning = "The robot is on hold.",
              .causes = "`hold` was called.",
              .remedy = "Call `resume`."};
  }
  return {};
}

}  // namespace fairway
