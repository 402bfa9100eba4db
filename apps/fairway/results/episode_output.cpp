// SPDX-License-Identifier: Apache-2.0
#include "results/episode_output.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "fairway/geometry/body_outline.hpp"
#include "fairway/io/drawing/speed_picture.hpp"
#include "fairway/io/drawing/world_picture.hpp"
#include "fairway/planning/body_obstruction.hpp"
#include "fairway/planning/path_obstruction.hpp"
#include "fairway/simulation/recorded/metrics.hpp"
#include "fairway/zones/zone_map.hpp"
#include "results/plan_output.hpp"

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

Json zones_json(const ZoneBreaches& breaches) {
  return Json{{"intrusion", breaches.intrusion},
              {"excursion", breaches.excursion},
              {"excess", breaches.excess},
              {"against_lanes", breaches.against_lanes}};
}

std::string zones_text(const ZoneBreaches& breaches) {
  return fmt::format(
      "broke the zones: {:.4f} m into a keep-out, {:.4f} m out of the strips, {:.4f} m/s too fast, "
      "{:.4f} m against a one-way zone",
      breaches.intrusion, breaches.excursion, breaches.excess, breaches.against_lanes);
}

std::string distance_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.2f}", value) : "-";
}

// Whether the contact is a moving obstacle's doing: it came, and the robot did not move towards it.
bool was_run_into(const RobotResult& robot) {
  constexpr double kStandstill = 1e-3;  // [m/s]
  return robot.collided && robot.contact.with != Contact::With::StaticObstacle &&
         robot.contact.with != Contact::With::Nothing && robot.approach <= kStandstill &&
         robot.contact.other_approach > kStandstill;
}

const char* outcome(const RobotResult& robot) {
  if (was_run_into(robot)) return "run into";
  if (robot.collided) return "contact";
  return robot.reached ? "reached" : "not reached";
}

// The last cycle of a robot; none if it had none.
const TraceRow* last_row(const EpisodeResult& result, std::size_t robot) {
  const auto& rows = result.trace.rows;
  const auto found = std::find_if(rows.rbegin(), rows.rend(),
                                  [&](const TraceRow& row) { return row.robot == robot; });
  return found == rows.rend() ? nullptr : &*found;
}

// The name of what a robot touched; "the map" for a static obstacle.
std::string touched(const Scenario& scenario, const Contact& contact) {
  switch (contact.with) {
    case Contact::With::StaticObstacle:
      return "the map";
    case Contact::With::Body:
      if (contact.other < scenario.bodies.size()) return scenario.bodies[contact.other].name;
      return "a moving obstacle";
    case Contact::With::Robot:
      if (contact.other < scenario.robots.size()) return scenario.robots[contact.other].name;
      return "another robot";
    case Contact::With::Nothing:
      break;
  }
  return "an obstacle";
}

PreparedMap prepared_map(const Scenario& scenario) {
  BitGrid obstacles(scenario.map, unknown_cells(scenario.settings.map));
  if (!scenario.zones.empty()) {
    obstacles.set_zones(
        std::make_shared<const ZoneMap>(scenario.zones, scenario.settings.robot.radius));
  }
  return PreparedMap(std::move(obstacles));
}

// Why a robot is not at its goal.
std::string failure_reason(const Scenario& scenario,
                           const EpisodeResult& result,
                           std::size_t index) {
  const RobotResult& robot = result.robots[index];
  const TraceRow* const last = last_row(result, index);
  const Pose2 pose = last != nullptr ? last->pose : scenario.robots[index].start;
  const Eigen::Vector2d& position = pose.position;
  if (was_run_into(robot)) {
    return fmt::format(
        "was run into by {} at {:.2f} s, near ({:.2f}, {:.2f}), at standstill or moving away: "
        "the other came with {:.2f} m/s",
        touched(scenario, robot.contact), robot.time, position.x(), position.y(),
        std::max(0.0, robot.contact.other_approach));
  }
  if (robot.collided) {
    return fmt::format("touched {} at {:.2f} s, near ({:.2f}, {:.2f}), with {:.2f} m/s towards it",
                       touched(scenario, robot.contact), robot.time, position.x(), position.y(),
                       std::max(0.0, robot.approach));
  }
  if (robot.reached && !robot.zones.none()) return zones_text(robot.zones);
  if (!robot.plan.usable() && scenario.sensing.sensing == Sensing::Map) {
    const PreparedMap map = prepared_map(scenario);
    const auto& model = scenario.robots[index].model;
    return model ? explain_body(map, model->body, position, robot.plan)
                 : explain(map, position, robot.plan, scenario.settings.robot.radius);
  }
  if (!robot.plan.usable()) {
    return robot.explanation.text.empty() ? robot.plan.reason() : robot.explanation.text;
  }
  const double distance = (scenario.robots[index].goal.position - position).norm();
  std::string text = fmt::format(
      "did not reach its goal within {:.1f} s: {:.2f} m from it, at "
      "({:.2f}, {:.2f})",
      robot.time, distance, position.x(), position.y());
  if (!robot.explanation.text.empty()) return text + "; " + robot.explanation.text;
  if (last == nullptr) return text;
  text += fmt::format("; last status: {}", to_text(last->status));
  if (last->limit != LimitingFactor::None) text += fmt::format(" ({})", to_text(last->limit));
  return text;
}

// What closes every route of a robot that knows the map, where it is now.
std::optional<PathObstruction> obstruction_of(const Scenario& scenario,
                                              const EpisodeResult& result,
                                              std::size_t index) {
  const RobotResult& robot = result.robots[index];
  if (robot.collided || robot.plan.usable() || scenario.sensing.sensing != Sensing::Map) return {};
  const TraceRow* const last = last_row(result, index);
  const Pose2 pose = last != nullptr ? last->pose : scenario.robots[index].start;
  const PreparedMap map = prepared_map(scenario);
  const auto& model = scenario.robots[index].model;
  if (model) return find_body_obstruction(map, model->body, pose.position, robot.plan);
  return find_obstruction(map, pose.position, robot.plan, scenario.settings.robot.radius);
}

Json explanation_json(const StepExplanation& why) {
  Json json{{"kind", to_text(why.kind)}, {"text", why.text}};
  const bool has_place = why.position != Eigen::Vector2d::Zero();
  if (has_place) json["position"] = {why.position.x(), why.position.y()};
  if (has_place || why.needed > 0.0) json["found"] = why.found;
  if (why.needed > 0.0) json["needed"] = why.needed;
  return json;
}

}  // namespace

Json episode_json(const Scenario& scenario, const EpisodeResult& result) {
  Json json;
  json["success"] = result.success;
  json["time"] = result.time;
  Json robots = Json::array();
  for (std::size_t i = 0; i < result.robots.size(); ++i) {
    const RobotResult& robot = result.robots[i];
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
    if (!scenario.zones.empty()) robots.back()["zones"] = zones_json(robot.zones);
    if (robot.collided) {
      robots.back()["touched"] = touched(scenario, robot.contact);
      robots.back()["run_into"] = was_run_into(robot);
    }
    if (robot.reached && !robot.collided && robot.zones.none()) continue;
    robots.back()["reason"] = failure_reason(scenario, result, i);
    if (!robot.collided && !robot.reached && robot.explanation.kind != StepExplanation::Kind::None)
      robots.back()["explanation"] = explanation_json(robot.explanation);
    if (const auto found = obstruction_of(scenario, result, i))
      robots.back()["obstruction"] = obstruction_json(*found);
  }
  json["robots"] = std::move(robots);
  return json;
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

std::string failure_text(const Scenario& scenario, const EpisodeResult& result) {
  const auto failed = [&](auto&& has_failed) -> std::optional<std::string> {
    for (std::size_t i = 0; i < result.robots.size(); ++i) {
      if (!has_failed(result.robots[i])) continue;
      const std::string reason = failure_reason(scenario, result, i);
      const bool clause = result.robots[i].collided || result.robots[i].plan.usable();
      return result.robots[i].name + (clause ? " " : ": ") + reason;
    }
    return std::nullopt;
  };
  if (auto text = failed([](const RobotResult& robot) { return robot.collided; })) return *text;
  if (auto text = failed([](const RobotResult& robot) { return !robot.reached; })) return *text;
  if (auto text = failed([](const RobotResult& robot) { return !robot.zones.none(); }))
    return *text;
  return "the run was stopped early";
}

Expected<std::string> world_picture(const Scenario& scenario,
                                    const EpisodeResult& result,
                                    const std::string& file) {
  io::WorldDrawing drawing{
      .map = &scenario.map, .robots = {}, .bodies = {}, .zones = scenario.zones};
  for (std::size_t i = 0; i < result.robots.size(); ++i) {
    const Plan& plan = result.robots[i].plan;
    drawing.robots.push_back({.name = result.robots[i].name,
                              .radius = scenario.settings.robot.radius,
                              .start = scenario.robots[i].start,
                              .goal = scenario.robots[i].goal.position,
                              .path = plan.path,
                              .corridor = plan.corridor,
                              .track = {}});
    if (const auto& model = scenario.robots[i].model)
      drawing.robots.back().outlines = outlines_of(model->body);
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
