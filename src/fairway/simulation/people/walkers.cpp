// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/people/walkers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/simulation/people/social_force.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kStep = 0.1;       // [s]
constexpr double kMoreSpeed = 1.3;  // a person may hurry to avoid others
constexpr double kSpace = 0.1;      // added to the radii that people assume [m]

const Vector2d& place_of(const MovingBody& body) noexcept {
  return body.key_frames.back().position;
}

// Whether two people walk in the same group.
bool together(const MovingBody& a, const MovingBody& b) noexcept {
  return a.walk && b.walk && !a.walk->group.empty() && a.walk->group == b.walk->group;
}

// The velocity by which a person returns to the others of the group. It vanishes within the
// distance at which people of a group walk, and fades near the goal, so that all arrive.
Vector2d pull_of_group(const std::vector<MovingBody>& bodies, std::size_t index) noexcept {
  constexpr double kApart = 0.9;     // [m]
  constexpr double kRate = 0.6;      // [1/s]
  constexpr double kNearGoal = 2.0;  // [m]
  const MovingBody& person = bodies[index];
  Vector2d middle = Vector2d::Zero();
  double others = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i == index || !together(person, bodies[i])) continue;
    middle += place_of(bodies[i]);
    others += 1.0;
  }
  if (others == 0.0) return Vector2d::Zero();
  const Vector2d way = middle / others - place_of(person);
  const double apart = way.norm();
  if (apart <= kApart) return Vector2d::Zero();
  const double left = (person.walk->to - place_of(person)).norm() / kNearGoal;
  return kRate * std::min(1.0, left) * (1.0 - kApart / apart) * way;
}

Vector2d preferred_velocity(const std::vector<MovingBody>& bodies, std::size_t index) noexcept {
  const WalkPlan& plan = *bodies[index].walk;
  const Vector2d to_goal = plan.to - place_of(bodies[index]);
  const double distance = to_goal.norm();
  const Vector2d alone =
      distance > plan.speed ? Vector2d(to_goal * (plan.speed / distance)) : to_goal;
  if (plan.group.empty()) return alone;
  const Vector2d wanted = alone + pull_of_group(bodies, index);
  const double speed = wanted.norm();
  return speed > plan.speed ? Vector2d(wanted * (plan.speed / speed)) : wanted;
}

bool has_arrived(const MovingBody& body) noexcept {
  const double near = body.walk->group.empty() ? body.radius : std::max(body.radius, 0.5);
  return (place_of(body) - body.walk->to).norm() < near;
}

// A group turns back when all of it have arrived.
void turn_back_if_arrived(std::vector<MovingBody>& bodies, std::size_t index) {
  if (!bodies[index].walk->returns) return;
  std::vector<MovingBody*> group = {&bodies[index]};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i != index && together(bodies[index], bodies[i])) group.push_back(&bodies[i]);
  }
  for (const MovingBody* body : group) {
    if (!has_arrived(*body)) return;
  }
  for (MovingBody* body : group)
    std::swap(body->walk->from, body->walk->to);
}

// What a person sees: other people and bodies that are there, then robots.
std::vector<OrcaNeighbour> seen_by(const std::vector<MovingBody>& bodies,
                                   std::size_t index,
                                   std::span<const OrcaNeighbour> robots,
                                   double time) {
  std::vector<OrcaNeighbour> seen;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i == index || !bodies[i].is_there(time)) continue;
    const double space = together(bodies[index], bodies[i]) ? 0.0 : kSpace;
    if (bodies[i].walk) {
      seen.push_back({.position = place_of(bodies[i]),
                      .velocity = bodies[i].walk->velocity,
                      .radius = bodies[i].radius + space});
    } else {
      const MovingObstacle now = bodies[i].at(time);
      seen.push_back(
          {.position = now.position, .velocity = now.velocity, .radius = now.radius + space});
    }
  }
  for (OrcaNeighbour robot : robots) {
    robot.radius += kSpace;
    seen.push_back(robot);
  }
  return seen;
}

}  // namespace

std::vector<MovingBody> walking_bodies(std::span<const Walker> people, WalkingModel model) {
  std::vector<MovingBody> bodies;
  for (const Walker& walker : people) {
    double speed = walker.speed;
    for (const Walker& other : people) {
      if (!walker.group.empty() && other.group == walker.group)
        speed = std::min(speed, other.speed);
    }
    bodies.push_back({.name = walker.name,
                      .radius = walker.radius,
                      .key_frames = {{.time = 0.0, .position = walker.start}},
                      .walk = WalkPlan{.model = model,
                                       .from = walker.start,
                                       .to = walker.goal,
                                       .speed = speed,
                                       .returns = walker.returns,
                                       .group = walker.group}});
  }
  return bodies;
}

void walk_on(std::vector<MovingBody>& bodies, std::span<const OrcaNeighbour> robots, double time) {
  constexpr double kRounding = 1e-9;  // of sums of steps [s]
  std::vector<std::pair<std::size_t, Vector2d>> chosen;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const MovingBody& person = bodies[i];
    if (!person.walk || person.key_frames.back().time > time - kRounding) continue;
    const OrcaAgent agent{.position = place_of(person),
                          .velocity = person.walk->velocity,
                          .preferred = preferred_velocity(bodies, i),
                          .radius = person.radius + kSpace,
                          .speed_max = kMoreSpeed * person.walk->speed};
    const std::vector<OrcaNeighbour> others = seen_by(bodies, i, robots, time);
    chosen.emplace_back(i, person.walk->model == WalkingModel::Orca
                               ? orca_velocity(agent, others, {.horizon = 3.0, .step = kStep})
                               : social_force_velocity(agent, others, {.step = kStep}));
  }
  for (const auto& [i, velocity] : chosen) {
    bodies[i].walk->velocity = velocity;
    const MovingBody::KeyFrame last = bodies[i].key_frames.back();
    bodies[i].key_frames.push_back(
        {.time = last.time + kStep, .position = last.position + kStep * velocity});
  }
  for (const std::pair<std::size_t, Vector2d>& choice : chosen)
    turn_back_if_arrived(bodies, choice.first);
}

std::vector<MovingBody> walk(std::span<const Walker> people, WalkingModel model, double duration) {
  std::vector<MovingBody> bodies = walking_bodies(people, model);
  const int steps = static_cast<int>(std::ceil(duration / kStep));
  for (int k = 0; k < steps; ++k)
    walk_on(bodies, {}, (k + 1) * kStep);
  for (MovingBody& body : bodies)
    body.walk.reset();
  return bodies;
}

}  // namespace fairway
