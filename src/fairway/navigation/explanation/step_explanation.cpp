// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/explanation/step_explanation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/map/free_space.hpp"
#include "fairway/navigation/explanation/status_guide.hpp"
#include "fairway/planning/obstruction_text.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;
using Kind = StepExplanation::Kind;

// A moving obstacle or robot, and how near it is.
struct NearBody {
  Kind kind = Kind::None;
  std::uint32_t robot = 0;
  Vector2d position = Vector2d::Zero();                        // now
  double radius = 0.0;                                         // [m]
  double clearance = std::numeric_limits<double>::infinity();  // between the bodies, now [m]
};

std::string meters(double length) { return joined_text({fixed_text(length, 2), " m"}); }
std::string seconds(double time) { return joined_text({fixed_text(time, 2), " s"}); }

// Calls `consider` for each moving obstacle and robot, where it is now.
template <typename Consider>
void for_each_body(const NavigationInput& input, double radius, Consider&& consider) {
  const double age = input.time - input.obstacles_time;
  const auto at = [&](Kind kind, std::uint32_t robot, const Vector2d& position, double own) {
    const double apart = (position - input.pose.position).norm() - own - radius;
    consider(NearBody{.kind = kind,
                      .robot = robot,
                      .position = position,
                      .radius = own,
                      .clearance = std::max(0.0, apart)});
  };
  for (const MovingObstacle& obstacle : input.obstacles)
    at(Kind::MovingObstacle, 0, predicted_position(obstacle, age), obstacle.radius);
  for (const FleetMember& member : input.fleet)
    at(Kind::Robot, member.motion->robot, member.motion->position, member.motion->radius);
}

NearBody nearest_body(const NavigationInput& input, const Vector2d& to, double radius) {
  NearBody nearest;
  double least = std::numeric_limits<double>::infinity();
  for_each_body(input, radius, [&](const NearBody& body) {
    const double gap = (body.position - to).norm() - body.radius;
    if (!(gap < least)) return;
    least = gap;
    nearest = body;
  });
  return nearest;
}

// The body whose barrier holds back the solver's answer. The problem has its prediction, from the
// time at which the robot answers to a command.
NearBody limiting_body(const Navigator& navigator,
                       const NavigationStep& step,
                       const NavigationInput& input) {
  const double radius = navigator.settings().robot.radius;
  const ControlProblem& problem = navigator.problem();
  const bool known = step.plan != nullptr && step.plan->horizon > 0 &&
                     step.plan->limiting.kind == ConstraintKind::Barrier &&
                     step.plan->limiting.index < problem.num_obstacles;
  if (!known) return nearest_body(input, input.pose.position, radius);
  const auto index = static_cast<std::size_t>(step.plan->limiting.index);
  const Vector2d& predicted = problem.obstacles[index].position[0];
  NearBody nearest;
  double least = std::numeric_limits<double>::infinity();
  for_each_body(input, radius, [&](const NearBody& body) {
    const double apart = (body.position - predicted).norm();
    if (!(apart < least)) return;
    least = apart;
    nearest = body;
  });
  return nearest;
}

// The first body on the path ahead of a robot at standstill, with the margin.
NearBody body_on_path(const Navigator& navigator, const NavigationInput& input) {
  constexpr double kReach = 2.0;  // [m]
  constexpr double kStep = 0.1;   // [m]
  const ReferencePath& path = navigator.corridor().reference_path();
  const Settings& settings = navigator.settings();
  NearBody first;
  if (navigator.corridor().empty() || path.count < 2) return first;
  const double margin = settings.robot.radius + settings.prediction.obstacle_margin;
  for (double s = 0.0; s <= std::min(kReach, path.length()) && first.kind == Kind::None;
       s += kStep) {
    const Vector2d place = path.at(s);
    for_each_body(input, settings.robot.radius, [&](const NearBody& body) {
      const bool in_the_way = (body.position - place).norm() < body.radius + margin;
      const bool behind = s == 0.0 && (body.position - place).dot(path.at(kStep) - place) < 0.0;
      if (in_the_way && !behind && body.clearance < first.clearance) first = body;
    });
  }
  return first;
}

std::string name_of(const NearBody& body) {
  const std::string what = body.kind == Kind::Robot
                               ? joined_text({"robot ", std::to_string(body.robot)})
                               : std::string("a moving obstacle");
  return joined_text({what, " at ", place_text(body.position)});
}

StepExplanation of_body(const NearBody& body, const char* what_it_does) {
  return {.kind = body.kind,
          .text = joined_text(
              {what_it_does, name_of(body), ", which is ", meters(body.clearance), " away"}),
          .position = body.position,
          .found = body.clearance};
}

// The way in which the robot stops from `speed` in the slowest case that the proof covers [m].
double stop_length(double speed, const Settings& settings) {
  const RobotSettings& robot = settings.robot;
  const double braking =
      robot.linear_braking_max > 0.0 ? robot.linear_braking_max : robot.linear_acceleration_max;
  const double reaction = robot.linear_delay + robot.linear_lag +
                          settings.safety.longest_hold * settings.navigation.control_period;
  return std::abs(speed) * reaction + 0.5 * speed * speed / braking;
}

StepExplanation explain_stop(const NavigationInput& input, double speed, const Settings& settings) {
  constexpr double kReach = 10.0;  // [m]
  const double needed = stop_length(speed, settings);
  const NearBody body = nearest_body(input, input.pose.position, settings.robot.radius);
  const double still =
      input.map == nullptr
          ? kReach
          : std::max(0.0, distance_to_blocked(*input.map, input.pose.position, kReach) -
                              settings.robot.radius);
  const bool moving = body.kind != Kind::None && body.clearance < still;
  const double found = moving ? body.clearance : still;
  return {
      .kind = Kind::Stop,
      .text = joined_text({"no new command leaves a stop that is free: from ",
                           fixed_text(std::abs(speed), 2), " m/s it takes up to ", meters(needed),
                           ", and ", moving ? name_of(body) : std::string("the nearest obstacle"),
                           " is ", meters(found), " away"}),
      .position = moving ? body.position : Vector2d(Vector2d::Zero()),
      .found = found,
      .needed = needed};
}

StepExplanation explain_age(const char* input, double age, double most, const char* setting) {
  return {.kind = Kind::Input,
          .text = joined_text(
              {"the ", input, " ", seconds(age), " old, and ", setting, " is ", seconds(most)}),
          .found = age,
          .needed = most};
}

// Whether it limits every drive.
bool is_usual(LimitingFactor limit) noexcept {
  return limit == LimitingFactor::None || limit == LimitingFactor::Speed ||
         limit == LimitingFactor::Acceleration || limit == LimitingFactor::Corridor;
}

// The oldest of the moving obstacles and of the messages of other robots.
double age_of_tracks(const NavigationInput& input) {
  double age =
      input.obstacles_due || !input.obstacles.empty() ? input.time - input.obstacles_time : 0.0;
  for (const FleetMember& member : input.fleet)
    age = std::max(age, input.time - member.motion->time);
  return age;
}

}  // namespace

StepExplanation explain_step(const Navigator& navigator,
                             const NavigationStep& step,
                             const NavigationInput& input,
                             double speed) {
  const LimitingFactor limit = step.limit;
  const Settings& settings = navigator.settings();
  if (limit == LimitingFactor::StalePose) {
    return explain_age("pose is", input.time - input.pose_time, settings.safety.pose_timeout,
                       "safety.pose_timeout");
  }
  if (limit == LimitingFactor::StaleMap && input.map != nullptr) {
    return explain_age("map is", input.time - input.map_time, settings.safety.map_timeout,
                       "safety.map_timeout");
  }
  if (limit == LimitingFactor::StaleTracks) {
    return explain_age("moving obstacles or messages of robots are", age_of_tracks(input),
                       settings.safety.tracks_timeout, "safety.tracks_timeout");
  }
  const bool moving = limit == LimitingFactor::MovingObstacle;
  const bool stop = limit == LimitingFactor::StopNotProven;
  if (!moving && !stop && !is_usual(limit))
    return {.kind = Kind::Other, .text = guide_of(limit).meaning};
  if (step.status == NavigationStatus::GoalReached) return {};
  constexpr double kStill = 0.02;  // [m/s]
  if (std::abs(speed) < kStill && std::abs(step.command.linear) < kStill) {
    const NearBody waits_for = body_on_path(navigator, input);
    if (waits_for.kind != Kind::None) return of_body(waits_for, "the robot waits for ");
  }
  if (moving) {
    const NearBody body = limiting_body(navigator, step, input);
    if (body.kind != Kind::None) return of_body(body, "the robot keeps its distance from ");
  }
  if (stop) return explain_stop(input, speed, settings);
  if (moving) return {.kind = Kind::Other, .text = guide_of(limit).meaning};
  if (step.status == NavigationStatus::Ok) return {};
  return {.kind = Kind::Other, .text = guide_of(step.status).meaning};
}

}  // namespace fairway
