// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "command_check.hpp"
#include "contacts.hpp"
#include "draw.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/robot_driver.hpp"
#include "guard.hpp"
#include "near_pass.hpp"
#include "pose_error.hpp"

// One run of the safety campaign.
namespace fairway::campaign {

struct Outcome {
  ContactKind contact = ContactKind::None;
  bool reached = false;
  double time = 0.0;
  double clearance = 0.0;   // least, to the map [m]
  double separation = 0.0;  // least, to moving bodies [m]
  int cycles = 0;
  int bad_commands = 0;  // not finite, or outside the limits
  int too_near = 0;      // cycles in which a bound of docs/safety.md was broken
  int reduced = 0;       // commands that the guard has reduced
  PoseError pose{};
};

/// Called after every cycle; for a look at a single run.
using Watch = std::function<void(const World&, const DrivenCycle&, bool good)>;

/// Drives a run to its end: arrival, contact or time limit.
[[nodiscard]] inline Outcome drive(const Run& run,
                                   std::uint64_t seed,
                                   std::unique_ptr<Physics> physics,
                                   bool guarded,
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
  CommandCheck check(settings, scenario.robots.front().model);
  Sight sight(scenario);
  Outcome outcome;
  std::vector<Twist2> commands(1);
  double interval = 0.0;  // from the last cycle to this one [s]
  NearPass near(scenario);
  std::optional<Guard> guard;
  if (guarded) guard.emplace(scenario, world, seed);
  const double period = settings.navigation.control_period;
  const double watchdog = settings.safety.longest_hold * period;
  const auto send = [&](const NavigationStep& step) {
    commands.front() = step.command;
    const BodyRobot* const robot = world.model_of(0);
    if (robot == nullptr) return;
    const bool steered = is_steered(robot->model.base);
    world.send(0, {.linear = step.command.linear,
                   .lateral = step.lateral,
                   .turn = steered ? step.steering : step.command.angular});
  };
  const auto advance_to = [&](double end) {
    while (world.time() < end - 1e-9) {
      const double next = std::min(end, driver->next_measurement());
      if (next > world.time()) world.advance(commands, next - world.time());
      if (next < end) driver->measure(world);
    }
  };
  while (world.time() < scenario.time_limit && !world.encounters().front().collided) {
    driver->measure(world);
    sight.look(world);
    // By lidar the bound is that of what was seen, which is not known here. A monitor behind the
    // navigator changes what was proven.
    const bool exact = scenario.sensing.pose == PoseSource::Exact;
    const bool promised = scenario.sensing.sensing == Sensing::Map && exact && !guarded;
    if (near.look(world) && promised) ++outcome.too_near;
    DrivenCycle cycle = driver->drive(world);
    NavigationStep& step = cycle.step;
    ++outcome.cycles;
    if (scenario.sensing.sensing == Sensing::Map) outcome.pose.look(world, cycle, interval);
    const bool good = check.good(step, interval);
    if (!good) ++outcome.bad_commands;
    if (watch) watch(world, cycle, good);
    if (step.status == NavigationStatus::GoalReached) {
      outcome.reached = true;
      break;
    }
    if (guard) {
      const Twist2 allowed = guard->check(world, step.command);
      const bool same =
          allowed.linear == step.command.linear && allowed.angular == step.command.angular;
      step.command = allowed;
      if (!same) driver->replace_last(allowed);
      check.replace_last(allowed);
    }
    send(step);
    interval = period * (1.0 + noise.uniform(-run.jitter, run.jitter));
    const int most_lost = run.late_share > 0.0 ? 3 : 1;  // in a row
    for (int lost = 0; lost < most_lost && noise.uniform(0.0, 1.0) < run.lost_share; ++lost)
      interval += period;
    if (run.late_share > 0.0 && noise.uniform(0.0, 1.0) < run.late_share) interval += 1.0;
    const double end = world.time() + interval;
    if (interval > watchdog + 1e-9) {
      // The base brakes by itself where no command comes in time, as docs/safety.md asks for.
      advance_to(world.time() + watchdog);
      send({.steering = step.steering});
    }
    advance_to(end);
  }
  outcome.reduced = guard ? guard->reduced : 0;
  outcome.time = world.time();
  outcome.contact = classify(world, settings, sight);
  outcome.clearance = world.encounters().front().min_clearance;
  outcome.separation = world.encounters().front().min_separation;
  return outcome;
}

}  // namespace fairway::campaign
