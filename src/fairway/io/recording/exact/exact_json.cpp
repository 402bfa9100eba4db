// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/exact/exact_json.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fairway::io::exact {

namespace {

template <typename Enumeration>
Json enumerated(Enumeration value) {
  return Json{{"number", static_cast<int>(value)}, {"text", to_text(value)}};
}

template <typename Enumeration>
Enumeration to_enumerated(const Json& json, Enumeration last) {
  const int number = json.at("number").get<int>();
  if (number < 0 || number > static_cast<int>(last)) {
    throw std::invalid_argument("expected a value from 0 to " +
                                std::to_string(static_cast<int>(last)) + ", found " +
                                std::to_string(number));
  }
  return static_cast<Enumeration>(number);
}

// Display values are rounded to 0.1 mm as in all displayed messages: they compress to a quarter.
double shortened(double value) { return std::round(value * 1e4) / 1e4; }

Twist2 shortened(const Twist2& twist) {
  return {.linear = shortened(twist.linear), .angular = shortened(twist.angular)};
}

Pose2 shortened(const Pose2& pose) {
  return {.position = {shortened(pose.position.x()), shortened(pose.position.y())},
          .heading = shortened(pose.heading)};
}

template <typename Item>
Json shortened_list(std::span<const Item> items) {
  Json json = Json::array();
  for (const Item& item : items)
    json.push_back(to_json(shortened(item)));
  return json;
}

template <typename Range>
Json list(const Range& items) {
  Json json = Json::array();
  for (const auto& item : items)
    json.push_back(to_json(item));
  return json;
}

}  // namespace

Json to_json(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return "NaN";
  return value > 0.0 ? "Infinity" : "-Infinity";
}

double to_number(const Json& json) {
  if (!json.is_string()) return json.get<double>();
  const auto& text = json.get_ref<const std::string&>();
  if (text == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (text == "Infinity") return std::numeric_limits<double>::infinity();
  if (text == "-Infinity") return -std::numeric_limits<double>::infinity();
  throw std::invalid_argument("expected a number");
}

Json to_json(const Eigen::Vector2d& point) {
  return Json::array({to_json(point.x()), to_json(point.y())});
}

Eigen::Vector2d to_point(const Json& json) {
  return {to_number(json.at(0)), to_number(json.at(1))};
}

Json to_json(const Pose2& pose) {
  return {{"x", to_json(pose.position.x())},
          {"y", to_json(pose.position.y())},
          {"heading", to_json(pose.heading)}};
}

Pose2 to_pose(const Json& json) {
  return {.position = {to_number(json.at("x")), to_number(json.at("y"))},
          .heading = to_number(json.at("heading"))};
}

Json to_json(const Twist2& twist) {
  return {{"linear", to_json(twist.linear)}, {"angular", to_json(twist.angular)}};
}

Twist2 to_twist(const Json& json) {
  return {.linear = to_number(json.at("linear")), .angular = to_number(json.at("angular"))};
}

Json to_json(const MovingObstacle& obstacle) {
  return {{"position", to_json(obstacle.position)},
          {"velocity", to_json(obstacle.velocity)},
          {"radius", to_json(obstacle.radius)}};
}

MovingObstacle to_obstacle(const Json& json) {
  return {.position = to_point(json.at("position")),
          .velocity = to_point(json.at("velocity")),
          .radius = to_number(json.at("radius"))};
}

Json to_json(const OrientedRectangle& rectangle) {
  return {{"seed", to_json(rectangle.seed)},
          {"orientation", to_json(rectangle.orientation)},
          {"min", to_json(rectangle.min)},
          {"max", to_json(rectangle.max)}};
}

OrientedRectangle to_rectangle(const Json& json) {
  return {.seed = to_point(json.at("seed")),
          .orientation = to_number(json.at("orientation")),
          .min = to_point(json.at("min")),
          .max = to_point(json.at("max"))};
}

Json to_json(const Goal& goal) {
  Json json{{"position", to_json(goal.position)}};
  if (goal.heading) json["heading"] = to_json(*goal.heading);
  return json;
}

Goal to_goal(const Json& json) {
  Goal goal{.position = to_point(json.at("position")), .heading = std::nullopt};
  if (json.contains("heading")) goal.heading = to_number(json.at("heading"));
  return goal;
}

Json to_json(const Plan& plan) {
  return {{"path_status", enumerated(plan.path_status)},
          {"corridor_status", enumerated(plan.corridor_status)},
          {"path", list(plan.path.waypoints)},
          {"space", enumerated(plan.corridor.space)},
          {"robot_radius", to_json(plan.corridor.robot_radius)},
          {"inward_offset", to_json(plan.corridor.inward_offset)},
          {"rectangles", list(plan.corridor.rectangles)},
          {"goal", to_json(plan.goal)},
          {"margin", to_json(plan.margin)},
          {"stuck_at", to_json(plan.stuck_at)}};
}

Plan to_plan(const Json& json, bool of_body) {
  Plan plan;
  plan.path_status = to_enumerated(json.at("path_status"), PathStatus::InvalidInput);
  plan.corridor_status = to_enumerated(json.at("corridor_status"), CorridorStatus::InvalidInput);
  for (const Json& point : json.at("path"))
    plan.path.waypoints.push_back(to_point(point));
  plan.corridor.space = to_enumerated(json.at("space"), CorridorSpace::Configuration);
  plan.corridor.robot_radius = to_number(json.at("robot_radius"));
  plan.corridor.inward_offset = to_number(json.at("inward_offset"));
  for (const Json& rectangle : json.at("rectangles"))
    plan.corridor.rectangles.push_back(to_rectangle(rectangle));
  plan.goal = to_goal(json.at("goal"));
  plan.margin = to_number(json.at("margin"));
  plan.stuck_at = to_number(json.at("stuck_at"));
  if (of_body && plan.corridor.rectangles.empty()) {
    // It is only shown: a robot with a model makes its plans again.
    const auto is_place = [](const Eigen::Vector2d& point) { return is_plausible(point); };
    const auto& points = plan.path.waypoints;
    if (!std::all_of(points.begin(), points.end(), is_place) || !is_place(plan.goal.position))
      throw std::invalid_argument("expected a path of plausible points");
    return plan;
  }
  if (const auto valid = validate(plan); !valid) throw std::invalid_argument(valid.error().message);
  return plan;
}

Json to_json(const MpcSolution& solution) {
  const auto n = static_cast<std::size_t>(solution.horizon);
  return {{"status", enumerated(solution.status)},
          {"iterations", solution.iterations},
          {"cost", to_json(solution.cost)},
          {"max_violation", to_json(solution.max_violation)},
          {"limiting", enumerated(solution.limiting.kind)},
          {"limiting_step", solution.limiting.step},
          {"limiting_index", solution.limiting.index},
          {"commands", shortened_list(std::span<const Twist2>(solution.commands).first(n))},
          {"poses", shortened_list(std::span<const Pose2>(solution.poses).first(n + 1))}};
}

MpcSolution to_solution(const Json& json) {
  MpcSolution solution;
  const Json& commands = json.at("commands");
  const Json& poses = json.at("poses");
  if (commands.size() > kMaxHorizon || poses.size() != commands.size() + 1) {
    throw std::invalid_argument("expected a plan of at most " + std::to_string(kMaxHorizon) +
                                " steps");
  }
  solution.status = to_enumerated(json.at("status"), SolveStatus::InvalidProblem);
  solution.horizon = static_cast<int>(commands.size());
  solution.iterations = json.at("iterations").get<int>();
  solution.cost = to_number(json.at("cost"));
  solution.max_violation = to_number(json.at("max_violation"));
  solution.limiting = {.kind = to_enumerated(json.at("limiting"), ConstraintKind::Barrier),
                       .step = json.at("limiting_step").get<int>(),
                       .index = json.at("limiting_index").get<int>()};
  for (std::size_t k = 0; k < commands.size(); ++k)
    solution.commands[k] = to_twist(commands[k]);
  for (std::size_t k = 0; k < poses.size(); ++k)
    solution.poses[k] = to_pose(poses[k]);
  return solution;
}

Json to_json(const LimitMark& mark) {
  return {{"shape", static_cast<int>(mark.shape)},
          {"a", to_json(mark.a)},
          {"b", to_json(mark.b)},
          {"radius", to_json(mark.radius)}};
}

LimitMark to_mark(const Json& json) {
  const int shape = json.at("shape").get<int>();
  if (shape < 0 || shape > static_cast<int>(LimitMark::Shape::Disc)) {
    throw std::invalid_argument("expected a shape from 0 to 2");
  }
  return {.shape = static_cast<LimitMark::Shape>(shape),
          .row = {},
          .a = to_point(json.at("a")),
          .b = to_point(json.at("b")),
          .radius = to_number(json.at("radius"))};
}

}  // namespace fairway::io::exact
