// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "fairway/geometry/angle.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/robot_driver.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/world.hpp"
#include "safety_campaign_draw.hpp"

// One run of the safety campaign, and what its contact was, if there was one.
namespace fairway::campaign {

/// The classes of contacts, by this rule, which is tried from the top:
/// - `Static`: the robot touched the map.
/// - `Unpredictable`: what it touched changed its velocity within the time that the robot needs to
///   stop from its greatest speed, plus one second: it was not visible in time what it would do. By
///   lidar also: its middle was out of the lidar's view at some time within that.
/// - `RunInto`: the robot went towards it with at most 0.02 m/s: it came to the robot.
/// - `DroveInto`: all others.
enum class ContactKind : std::uint8_t { None, Static, Unpredictable, RunInto, DroveInto };

[[nodiscard]] constexpr const char* to_text(ContactKind contact) noexcept {
  switch (contact) {
    case ContactKind::None:
      return "none";
    case ContactKind::Static:
      return "static";
    case ContactKind::Unpredictable:
      return "not visible in time";
    case ContactKind::RunInto:
      return "was run into";
    case ContactKind::DroveInto:
      return "drove into it";
  }
  return "unknown";
}

struct Outcome {
  ContactKind contact = ContactKind::None;
  bool reached = false;
  double time = 0.0;
  double clearance = 0.0;   // least, to the map [m]
  double separation = 0.0;  // least, to moving bodies [m]
  int cycles = 0;
  int bad_commands = 0;      // not finite, or outside the limits
  double driven = 0.0;       // [m]
  double pose_error = 0.0;   // greatest, of the position [m]
  double pose_square = 0.0;  // sum over the cycles of its square [m^2]
};

/// The time that a robot needs until standstill, from its greatest speed [s].
[[nodiscard]] inline double stopping_time(const Settings& settings) {
  return settings.robot.linear_max / linear_actuation(settings.robot).braking +
         dead_time(settings.robot) +
         (1.0 + settings.safety.longest_hold) * settings.navigation.control_period;
}

/// Notes when the middle of each body was out of the lidar's view last: behind walls and others,
/// beside the field of view or too far away. Without a lidar everything is in view.
class Sight {
 public:
  explicit Sight(const Scenario& scenario)
      : lidar_(scenario.sensing.lidar),
        reach_(std::min(lidar_.max_range, scenario.settings.perception.reach)),
        looks_(scenario.sensing.sensing == Sensing::Lidar) {}

  void look(const World& world) {
    if (!looks_) return;
    hidden_at_.resize(world.num_bodies(), kNever);
    bodies_.clear();
    for (std::size_t i = 0; i < world.num_bodies(); ++i)
      bodies_.push_back(world.body(i).at(world.time()));
    const Pose2& robot = world.robots().front().pose;
    const Vector2d from = transform(robot, lidar_.mount);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Vector2d way = bodies_[i].position - from;
      const double angle = std::atan2(way.y(), way.x());
      const bool turned_to =
          std::abs(shortest_turn(robot.heading, angle)) < 0.5 * lidar_.field_of_view;
      const double front = way.norm() - bodies_[i].radius - 1e-3;
      const bool seen = turned_to && front < reach_ &&
                        cast_ray(world.obstacles(), bodies_, from, angle, reach_) >= front;
      if (!seen) hidden_at_[i] = world.time();
    }
  }

  [[nodiscard]] double hidden_at(std::size_t body) const {
    return body < hidden_at_.size() ? hidden_at_[body] : kNever;
  }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  LidarModel lidar_;
  double reach_;
  bool looks_;
  std::vector<double> hidden_at_;
  std::vector<MovingObstacle> bodies_;
};

[[nodiscard]] inline ContactKind classify(const World& world,
                                          const Settings& settings,
                                          const Sight& sight) {
  const Encounter& met = world.encounters().front();
  if (!met.collided) return ContactKind::None;
  if (met.min_clearance < 0.0) return ContactKind::Static;
  constexpr double kReaction = 1.0;  // [s]
  const double since = met.collision_time - stopping_time(settings) - kReaction;
  double nearest = std::numeric_limits<double>::infinity();
  bool changed = false;
  for (std::size_t i = 0; i < world.num_bodies(); ++i) {
    const MovingBody& body = world.body(i);
    const MovingObstacle now = body.at(met.collision_time);
    const double gap = (now.position - world.robots().front().pose.position).norm() - now.radius;
    if (!(gap < nearest)) continue;
    nearest = gap;
    changed = sight.hidden_at(i) > since;
    for (const MovingBody::KeyFrame& frame : body.key_frames) {
      if (frame.time > std::max(0.0, since) && frame.time <= met.collision_time) changed = true;
    }
  }
  if (changed) return ContactKind::Unpredictable;
  constexpr double kStill = 0.02;  // [m/s]
  return met.approach <= kStill ? ContactKind::RunInto : ContactKind::DroveInto;
}

/// Notes the commands that are not finite or outside the limits.
class CommandCheck {
 public:
  explicit CommandCheck(const Settings& settings) : settings_(settings) {}

  /// @param elapsed  Since the command before [s].
  [[nodiscard]] bool good(const Twist2& command, double elapsed) {
    constexpr double kRounding = 1e-9;
    const RobotSettings& robot = settings_.robot;
    const double period = std::max(settings_.navigation.control_period, elapsed);
    const double linear =
        std::max(linear_actuation(robot).acceleration, linear_actuation(robot).braking);
    const double angular =
        std::max(angular_actuation(robot).acceleration, angular_actuation(robot).braking);
    const bool within = is_finite(command) && command.linear <= robot.linear_max + kRounding &&
                        command.linear >= std::min(0.0, robot.linear_min) - kRounding &&
                        std::abs(command.angular) <= robot.angular_max + kRounding &&
                        std::abs(command.linear - last_.linear) <= linear * period + kRounding &&
                        std::abs(command.angular - last_.angular) <= angular * period + kRounding;
    last_ = command;
    return within;
  }

 private:
  Settings settings_;
  Twist2 last_;
};

/// Called after every cycle; for a look at a single run.
using Watch = std::function<void(const World&, const DrivenCycle&, bool good)>;

/// Drives a run to its end: arrival, contact or time limit.
[[nodiscard]] inline Outcome drive(const Run& run,
                                   std::uint64_t seed,
                                   std::unique_ptr<Physics> physics,
                                   const Watch& watch = {}) {
  const Scenario& scenario = run.scenario;
  const Settings& settings = scenario.settings;
  World world(scenario, std::move(physics));
  const PreparedMap map(world.obstacles());
  Planner planner;
  RealTimeSolver solver(settings.mpc);
  FleetRadio radio(scenario.radio, 1, scenario.seed);
  RobotResult result;
  const std::function<double()> no_clock;
  const std::unique_ptr<RobotDriver> driver = make_driver({.scenario = scenario,
                                                           .settings = settings,
                                                           .map = map,
                                                           .planner = planner,
                                                           .solver = solver,
                                                           .radio = radio,
                                                           .observer = nullptr,
                                                           .clock = no_clock},
                                                          world, 0, result);
  driver->head_for(scenario.robots.front().goal, world);
  Noise noise(seed);
  CommandCheck check(settings);
  Sight sight(scenario);
  Outcome outcome;
  std::vector<Twist2> commands(1);
  double interval = 0.0;  // from the last cycle to this one [s]
  while (world.time() < scenario.time_limit && !world.encounters().front().collided) {
    driver->measure(world);
    sight.look(world);
    const DrivenCycle cycle = driver->drive(world);
    const NavigationStep& step = cycle.step;
    ++outcome.cycles;
    // Without a map the pose is in a frame of its own.
    if (scenario.sensing.sensing == Sensing::Map) {
      const Vector2d truth = world.robots().front().pose.position;
      const double error = (cycle.input.pose.position - truth).norm();
      outcome.pose_error = std::max(outcome.pose_error, error);
      outcome.pose_square += error * error;
      outcome.driven += std::abs(world.robots().front().twist.linear) * interval;
    }
    const bool good = check.good(step.command, interval);
    if (!good) ++outcome.bad_commands;
    if (watch) watch(world, cycle, good);
    if (step.status == NavigationStatus::GoalReached) {
      outcome.reached = true;
      break;
    }
    commands.front() = step.command;
    if (const BodyRobot* robot = world.model_of(0); robot != nullptr) {
      const bool steered = is_steered(robot->model.base);
      world.send(0, {.linear = step.command.linear,
                     .lateral = step.lateral,
                     .turn = steered ? step.steering : step.command.angular});
    }
    interval = settings.navigation.control_period * (1.0 + noise.uniform(-run.jitter, run.jitter));
    if (noise.uniform(0.0, 1.0) < run.lost_share) interval += settings.navigation.control_period;
    for (const double end = world.time() + interval; world.time() < end - 1e-9;) {
      const double next = std::min(end, driver->next_measurement());
      if (next > world.time()) world.advance(commands, next - world.time());
      if (next < end) driver->measure(world);
    }
  }
  outcome.time = world.time();
  outcome.contact = classify(world, settings, sight);
  outcome.clearance = world.encounters().front().min_clearance;
  outcome.separation = world.encounters().front().min_separation;
  return outcome;
}

}  // namespace fairway::campaign
