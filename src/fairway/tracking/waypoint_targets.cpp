// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/waypoint_targets.hpp"

#include <cmath>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// Returns the heading from a to b, unwrapped to within pi of `reference`; `reference` if they
// coincide.
double unwrapped_heading(const Vector2d& a, const Vector2d& b, double reference) noexcept {
  const Vector2d d = b - a;
  if (d.norm() < 1e-9) return reference;
  return reference + shortest_turn(reference, std::atan2(d.y(), d.x()));
}

double goal_heading(const Goal& goal, const Vector2d& from, double reference) noexcept {
  if (goal.heading) return reference + shortest_turn(reference, *goal.heading);
  return unwrapped_heading(from, goal.position, reference);
}

void set_all(const StepTarget& target, ControlProblem& problem) noexcept {
  for (int k = 1; k <= problem.horizon; ++k)
    problem.targets[static_cast<std::size_t>(k)] = target;
}

}  // namespace

void set_dual_targets(const CorridorFollower& corridor,
                      const Goal& goal,
                      const Pose2& pose,
                      const MpcSettings& settings,
                      ControlProblem& problem) noexcept {
  const auto seed = [&](std::size_t i) {
    return i < corridor.size() ? corridor.corridor().rectangles[i].seed : goal.position;
  };
  const Vector2d first = seed(corridor.current() + 1);
  const Vector2d second = seed(corridor.current() + 2);
  const bool first_is_goal = corridor.current() + 1 >= corridor.size();
  // Headings follow the path at the targets.
  const double first_heading = first_is_goal ? goal_heading(goal, pose.position, pose.heading)
                                             : unwrapped_heading(first, second, pose.heading);
  const double second_heading = goal_heading(goal, first, first_heading);
  const StepTarget current{
      .position = first,
      .heading = first_heading,
      .weight = {settings.weight_position, settings.weight_position, settings.weight_heading}};
  const StepTarget next{.position = second,
                        .heading = second_heading,
                        .weight = {settings.weight_next_position, settings.weight_next_position,
                                   settings.weight_next_heading}};
  const DualTarget dual = dual_target(current, next);
  set_all(dual.target, problem);
  problem.cost_offset = dual.offset * problem.horizon;
}

void set_centroid_target(const CorridorFollower& corridor,
                         const Goal& goal,
                         const Pose2& pose,
                         const MpcSettings& settings,
                         ControlProblem& problem) noexcept {
  const bool last = corridor.current() + 1 >= corridor.size();
  const Vector2d target = last ? goal.position : corridor.patch(corridor.current()).centroid();
  const double heading = last ? goal_heading(goal, pose.position, pose.heading)
                              : unwrapped_heading(pose.position, target, pose.heading);
  set_all({.position = target,
           .heading = heading,
           .weight = {settings.weight_position, settings.weight_position, settings.weight_heading}},
          problem);
}

}  // namespace fairway
