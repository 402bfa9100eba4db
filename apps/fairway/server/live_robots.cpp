// SPDX-License-Identifier: Apache-2.0
// Changes of the robots and people of a live world on request.
#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "server/editing/placement_check.hpp"
#include "server/live_world.hpp"

namespace fairway::app {

namespace {

constexpr double kWalkingSpeed = 1.4;  // [m/s]
constexpr double kPersonRadius = 0.3;  // [m]
constexpr std::size_t kMostBodies = 100;
constexpr std::size_t kMostRobots = 50;

// Returns a name such as "robot 3", with the first number that is unused.
template <typename Named>
std::string new_name(const std::string& kind, const std::vector<Named>& others) {
  for (std::size_t number = 1;; ++number) {
    std::string name = kind;
    name.append(" ").append(std::to_string(number));
    const auto taken = [&](const Named& other) { return other.name == name; };
    if (std::none_of(others.begin(), others.end(), taken)) return name;
  }
}

}  // namespace

bool LiveWorld::has_robot(std::size_t robot) const {
  return robot < scenario_.robots.size() && !removed_[robot];
}

void LiveWorld::set_goal(EpisodeControl& control,
                         std::size_t robot,
                         const std::optional<Goal>& goal) {
  if (!has_robot(robot)) return;
  RobotTask& task = scenario_.robots[robot];
  task.idle = !goal;
  if (goal) {
    task.goal = *goal;
    control.set_goal(robot, *goal);
  } else {
    task.goal = {.position = task.start.position, .heading = {}};
    control.cancel_goal(robot);
  }
}

void LiveWorld::apply(EpisodeControl& control, const GoalCommand& command) {
  if (!has_robot(command.robot)) return refuse("There is no such robot.");
  const Eigen::Vector2d& at = command.goal.position;
  if (std::string reason = off_map_reason(control.world(), at); !reason.empty())
    return refuse(std::move(reason), at);
  if (control.world().encounters()[command.robot].collided) {
    return refuse(fmt::format("{} has collided and cannot drive. Reset it first.",
                              scenario_.robots[command.robot].name),
                  at);
  }
  const RobotTask& task = scenario_.robots[command.robot];
  const std::optional<Goal> before = task.idle ? std::nullopt : std::optional(task.goal);
  const auto use = [this, robot = command.robot](const std::optional<Goal>& goal) {
    return [this, robot, goal](EpisodeControl& to) { set_goal(to, robot, goal); };
  };
  set_goal(control, command.robot, command.goal);
  edited({.label = "set goal", .undo = use(before), .redo = use(command.goal)});
}

void LiveWorld::apply(EpisodeControl& control, const CancelCommand& command) {
  if (!has_robot(command.robot)) return refuse("There is no such robot.");
  const RobotTask& task = scenario_.robots[command.robot];
  if (task.idle) return;
  const auto use = [this, robot = command.robot](const std::optional<Goal>& goal) {
    return [this, robot, goal](EpisodeControl& to) { set_goal(to, robot, goal); };
  };
  const Goal before = task.goal;
  set_goal(control, command.robot, {});
  edited({.label = "cancel goal", .undo = use(before), .redo = use({})});
}

void LiveWorld::place(EpisodeControl& control,
                      std::size_t robot,
                      const Pose2& pose,
                      const Pose2& start) {
  if (!has_robot(robot)) return;
  scenario_.robots[robot].start = start;
  control.place_robot(robot, pose);
}

void LiveWorld::apply(EpisodeControl& control, const PoseCommand& command) {
  if (!has_robot(command.robot)) return refuse("There is no such robot.");
  if (std::string reason = robot_refusal(control.world(), command.pose, command.robot);
      !reason.empty()) {
    return refuse(std::move(reason), command.pose.position);
  }
  const Pose2 pose = control.world().robots()[command.robot].pose;
  const Pose2 start = scenario_.robots[command.robot].start;
  const auto use = [this, robot = command.robot](const Pose2& to_pose, const Pose2& to_start) {
    return [this, robot, to_pose, to_start](EpisodeControl& to) {
      place(to, robot, to_pose, to_start);
    };
  };
  place(control, command.robot, command.pose, command.pose);
  edited({.label = "set pose", .undo = use(pose, start), .redo = use(command.pose, command.pose)});
}

void LiveWorld::apply(EpisodeControl& control, const ResetRobotCommand& command) {
  if (!has_robot(command.robot)) return refuse("There is no such robot.");
  const Pose2 start = scenario_.robots[command.robot].start;
  if (std::string reason = robot_refusal(control.world(), start, command.robot); !reason.empty()) {
    return refuse("The robot cannot go back to its start. " + reason + " Use Set pose instead.",
                  start.position);
  }
  control.place_robot(command.robot, start);
}

void LiveWorld::set_present(EpisodeControl& control, std::size_t robot, bool present) {
  removed_[robot] = !present;
  control.set_present(robot, present);
}

void LiveWorld::apply(EpisodeControl& control, const AddRobotCommand& command) {
  const auto present = std::count(removed_.begin(), removed_.end(), false);
  if (static_cast<std::size_t>(present) >= kMostRobots || removed_.size() >= 2 * kMostRobots)
    return refuse(fmt::format("Robot limit reached ({}).", kMostRobots), command.pose.position);
  if (std::string reason = robot_refusal(control.world(), command.pose, {}); !reason.empty())
    return refuse(std::move(reason), command.pose.position);
  const RobotTask task{.name = new_name("robot", scenario_.robots),
                       .start = command.pose,
                       .goal = {.position = command.pose.position, .heading = {}},
                       .idle = true};
  const std::size_t robot = scenario_.robots.size();
  scenario_.robots.push_back(task);
  removed_.push_back(false);
  control.add_robot(task);
  const auto show = [this, robot](bool is_present) {
    return [this, robot, is_present](EpisodeControl& to) { set_present(to, robot, is_present); };
  };
  edited({.label = "add robot", .undo = show(false), .redo = show(true)});
}

void LiveWorld::apply(EpisodeControl& control, const RemoveRobotCommand& command) {
  if (!has_robot(command.robot)) return refuse("There is no such robot.");
  if (std::count(removed_.begin(), removed_.end(), false) == 1)
    return refuse("The last robot cannot be removed.");
  set_present(control, command.robot, false);
  const auto show = [this, robot = command.robot](bool is_present) {
    return [this, robot, is_present](EpisodeControl& to) { set_present(to, robot, is_present); };
  };
  edited({.label = "remove robot", .undo = show(true), .redo = show(false)});
}

// Replaces the person `index`, adds one there, or removes it.
void LiveWorld::set_body(EpisodeControl& control,
                         std::size_t index,
                         const std::optional<MovingBody>& body) {
  const auto at = scenario_.bodies.begin() + static_cast<std::ptrdiff_t>(index);
  if (!body) {
    if (index >= control.world().num_bodies()) return;
    control.remove_body(index);
    scenario_.bodies.erase(at);
    return;
  }
  if (index > control.world().num_bodies()) return;
  control.set_body(index, *body);
  // A saved scenario has the person at its new place.
  MovingBody saved = *body;
  if (!saved.loop && !saved.key_frames.empty()) {
    saved.key_frames = {{.time = 0.0, .position = body->key_frames.back().position}};
  }
  if (index == scenario_.bodies.size()) {
    scenario_.bodies.push_back(saved);
  } else {
    scenario_.bodies.at(index) = saved;
  }
}

void LiveWorld::apply(EpisodeControl& control, const WalkCommand& command) {
  const World& world = control.world();
  const bool is_new = !command.body;
  const std::size_t index = command.body.value_or(world.num_bodies());
  if (index > world.num_bodies() || (!is_new && index == world.num_bodies())) return;
  const double radius = is_new ? kPersonRadius : world.body(index).radius;
  if (std::string reason = person_refusal(world, command.target, radius, !is_new);
      !reason.empty()) {
    return refuse(std::move(reason), command.target);
  }
  if (is_new && index >= kMostBodies)
    return refuse(fmt::format("Limit of people reached ({}).", kMostBodies), command.target);
  MovingBody body;
  if (is_new) {
    body.name = new_name("person", scenario_.bodies);
    body.radius = kPersonRadius;
    body.key_frames = {{.time = 0.0, .position = command.target}};
  } else {
    body = world.body(index);
    const Eigen::Vector2d here = body.at(world.time()).position;
    const double needs = (command.target - here).norm() / kWalkingSpeed;
    body.loop = false;
    body.passing = false;
    body.key_frames = {{.time = world.time(), .position = here}};
    if (needs > 0.01) {
      body.key_frames.push_back({.time = world.time() + needs, .position = command.target});
    }
  }
  set_body(control, index, body);
  if (!is_new) return;
  const auto use = [this, index](const std::optional<MovingBody>& now) {
    return [this, index, now](EpisodeControl& to) { set_body(to, index, now); };
  };
  edited({.label = "add person", .undo = use({}), .redo = use(body)});
}

void LiveWorld::apply(EpisodeControl& control, const RemoveBodyCommand& command) {
  if (command.body >= control.world().num_bodies()) return;
  const MovingBody before = control.world().body(command.body);
  set_body(control, command.body, {});
  // The person is restored as the last one, because indices of others must not change twice.
  edited({.label = "remove person",
          .undo = [this,
                   before](EpisodeControl& to) { set_body(to, to.world().num_bodies(), before); },
          .redo =
              [this](EpisodeControl& to) {
                if (to.world().num_bodies() > 0) set_body(to, to.world().num_bodies() - 1, {});
              }});
}

}  // namespace fairway::app
