// SPDX-License-Identifier: Apache-2.0
#include "results/episode_output.hpp"

#include <cmath>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "fairway/io/drawing/speed_picture.hpp"
#include "fairway/io/drawing/world_picture.hpp"
#include "fairway/simulation/recorded/metrics.hpp"

namespace fairway::app {

namespace {

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json microseconds_json(const std::vector<double>& seconds) {
  const Quantiles q = quantiles(seconds);
  return Json{{"median", 1e6 * q.median}, {"p99", 1e6 * q.p99}, {"max", 1e6 * q.max}};
}

Json status_json(const RobotResult& robot) {
  Json counts = Json::object();
  for (std::size_t i = 0; i < robot.status_counts.size(); ++i) {
    if (robot.status_counts[i] > 0) {
      counts[to_text(static_cast<NavigationStatus>(i))] = robot.status_counts[i];
    }
  }
  return counts;
}

std::string distance_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.2f}", value) : "-";
}

const char* outcome(const RobotResult& robot) {
  if (robot.collided) return "contact";
  return robot.reached ? "reached" : "not reached";
}

}  // namespace

std::string episode_json(const EpisodeResult& result) {
  Json json;
  json["success"] = result.success;
  json["time"] = result.time;
  Json robots = Json::array();
  for (const RobotResult& robot : result.robots) {
    robots.push_back(Json{{"name", robot.name},
                          {"reached", robot.reached},
                          {"collided", robot.collided},
                          {"approach", robot.approach},
                          {"time", robot.time},
                          {"length", robot.length},
                          {"min_clearance", number_json(robot.min_clearance)},
                          {"min_separation", number_json(robot.min_separation)},
                          {"cycles", robot.cycles},
                          {"status_counts", status_json(robot)},
                          {"cycle_us", microseconds_json(robot.cycle_seconds)},
                          {"solve_us", microseconds_json(robot.solve_seconds)},
                          {"plan_us", microseconds_json(robot.plan_seconds)}});
  }
  json["robots"] = std::move(robots);
  return json_text(json);
}

std::string episode_table(const EpisodeResult& result) {
  std::string text =
      fmt::format("{:<12} {:<10} {:>7} {:>9} {:>10} {:>11} {:>18}\n", "robot", "outcome", "time s",
                  "length m", "clear m", "separate m", "cycle us med/p99");
  for (const RobotResult& robot : result.robots) {
    const Quantiles cycle = quantiles(robot.cycle_seconds);
    text += fmt::format("{:<12} {:<10} {:>7.1f} {:>9.2f} {:>10} {:>11} {:>18}\n", robot.name,
                        outcome(robot), robot.time, robot.length,
                        distance_text(robot.min_clearance), distance_text(robot.min_separation),
                        fmt::format("{:.0f}/{:.0f}", 1e6 * cycle.median, 1e6 * cycle.p99));
  }
  return text;
}

std::string failure_text(const EpisodeResult& result) {
  for (const RobotResult& robot : result.robots) {
    if (robot.collided)
      return fmt::format("{} touched something at {:.2f} s", robot.name, robot.time);
  }
  for (const RobotResult& robot : result.robots) {
    if (robot.reached) continue;
    if (!robot.plan.usable()) return fmt::format("{}: {}", robot.name, robot.plan.reason());
    return fmt::format("{} did not reach its goal within {:.1f} s", robot.name, robot.time);
  }
  return "the run was stopped early";
}

Expected<std::string> world_picture(const Scenario& scenario,
                                    const EpisodeResult& result,
                                    const std::string& file) {
  io::WorldDrawing drawing{.map = &scenario.map, .robots = {}, .bodies = {}};
  for (std::size_t i = 0; i < result.robots.size(); ++i) {
    const Plan& plan = result.robots[i].plan;
    drawing.robots.push_back({.name = result.robots[i].name,
                              .radius = scenario.settings.robot.radius,
                              .start = scenario.robots[i].start,
                              .goal = scenario.robots[i].goal.position,
                              .path = plan.path,
                              .corridor = plan.corridor,
                              .track = {}});
  }
  for (const TraceRow& row : result.trace.rows)
    drawing.robots[row.robot].track.push_back(row.pose);
  const double dt = scenario.settings.navigation.control_period;
  for (const MovingBody& body : scenario.bodies) {
    io::BodyDrawing moving{.radius = body.radius, .track = {}};
    for (int k = 0; k * dt <= result.time; ++k) {
      if (body.is_there(k * dt)) moving.track.push_back(body.at(k * dt).position);
    }
    if (moving.track.empty()) continue;
    drawing.bodies.push_back(std::move(moving));
  }
  return io::draw_world(drawing, *io::picture_format(file));
}

Expected<std::string> speed_picture(const Scenario& scenario,
                                    const EpisodeResult& result,
                                    const std::string& file) {
  const RobotSettings& limits = scenario.settings.robot;
  io::SpeedDrawing drawing{.robots = {},
                           .min = {.linear = limits.linear_min, .angular = -limits.angular_max},
                           .max = {.linear = limits.linear_max, .angular = limits.angular_max}};
  for (const RobotResult& robot : result.robots)
    drawing.robots.push_back({.name = robot.name, .time = {}, .commands = {}, .executed = {}});
  for (const TraceRow& row : result.trace.rows) {
    io::SpeedSeries& series = drawing.robots[row.robot];
    series.time.push_back(row.time);
    series.commands.push_back(row.command);
    series.executed.push_back(row.twist);
  }
  return io::draw_speeds(drawing, *io::picture_format(file));
}

}  // namespace fairway::app
