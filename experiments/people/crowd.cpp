// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/crowd.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/simulation/people/orca.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kSocialGap = 0.25;       // kept from other places and goals by a new one [m]
constexpr double kGoalInterval = 5.0;     // between random changes of goals [s]
constexpr double kGoalChangeShare = 0.5;  // of people whose goal changes then, in CrowdNav++

}  // namespace

Crowd::Crowd(CrowdBenchmark benchmark, const CrowdCase& given)
    : benchmark_(benchmark),
      rules_(crowd_rules(benchmark)),
      robot_radius_(given.robot_radius),
      people_(given.people),
      assumed_(given.people.size()),
      random_(given.seed) {
  if (benchmark != CrowdBenchmark::CrowdNav)
    static_cast<void>(draw_case(benchmark, given.number, given.seed, &random_, &range_));
}

Vector2d Crowd::decide(std::size_t person) {
  const CrowdPerson& self = people_[person];
  if (!assumed_[person]) {
    Assumed assumed{.range = range_, .radii = {}};
    for (const CrowdPerson& other : people_)
      assumed.radii.push_back(other.radius);
    assumed_[person] = std::move(assumed);
  }
  const bool renewed = benchmark_ == CrowdBenchmark::CrowdNavPlus;
  const Vector2d to_goal = self.goal - self.position;
  const double distance = to_goal.norm();
  const OrcaAgent agent{.position = self.position,
                        .velocity = self.velocity,
                        .preferred = distance > 1.0 ? Vector2d(to_goal / distance) : to_goal,
                        .radius = self.radius + rules_.added_radius,
                        .speed_max = self.speed_max};
  std::vector<OrcaNeighbour> others;
  for (std::size_t i = 0; i < people_.size(); ++i) {
    if (i == person) continue;
    const double radius = renewed ? assumed_[person]->radii[i] : people_[i].radius;
    others.push_back({.position = people_[i].position,
                      .velocity = people_[i].velocity,
                      .radius = radius + rules_.added_radius});
  }
  return orca_velocity(agent, others,
                       {.neighbour_distance = renewed ? assumed_[person]->range : 10.0,
                        .neighbours_max = rules_.neighbours,
                        .horizon = 5.0,
                        .step = rules_.step});
}

std::vector<Vector2d> Crowd::choose() {
  std::vector<Vector2d> velocities;
  for (std::size_t i = 0; i < people_.size(); ++i)
    velocities.push_back(decide(i));
  return velocities;
}

std::vector<std::vector<Vector2d>> Crowd::look_ahead(int steps) {
  const std::vector<CrowdPerson> now = people_;
  std::vector<std::vector<Vector2d>> places;
  for (int k = 0; k < steps; ++k) {
    const std::vector<Vector2d> velocities = choose();
    std::vector<Vector2d>& after = places.emplace_back();
    for (std::size_t i = 0; i < people_.size(); ++i) {
      people_[i].velocity = velocities[i];
      people_[i].position += rules_.step * velocities[i];
      after.push_back(people_[i].position);
    }
  }
  people_ = now;
  return places;
}

void Crowd::move(const std::vector<Vector2d>& velocities,
                 const Vector2d& robot,
                 const Vector2d& robot_goal) {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    people_[i].velocity = velocities[i];
    people_[i].position += rules_.step * velocities[i];
  }
  time_ += rules_.step;
  ++steps_;
  if (benchmark_ != CrowdBenchmark::CrowdNav) change_goals(robot, robot_goal);
}

bool Crowd::is_clear(const Vector2d& place,
                     double radius,
                     const Vector2d& robot,
                     const Vector2d& robot_goal,
                     std::optional<std::size_t> except) const {
  const double from_robot = radius + robot_radius_ + kSocialGap;
  if ((place - robot).norm() < from_robot || (place - robot_goal).norm() < from_robot) return false;
  for (std::size_t i = 0; i < people_.size(); ++i) {
    if (i == except) continue;
    const double least = radius + people_[i].radius + kSocialGap;
    if ((place - people_[i].position).norm() < least || (place - people_[i].goal).norm() < least)
      return false;
  }
  return true;
}

void Crowd::change_goals(const Vector2d& robot, const Vector2d& robot_goal) {
  const auto new_goal = [&](std::size_t i) {
    CrowdPerson& person = people_[i];
    Vector2d goal;
    do {
      goal = draw_on_circle(random_, rules_.circle, person.speed_max);
    } while (!is_clear(goal, person.radius, robot, robot_goal, i));
    person.goal = goal;
  };
  const bool appears = benchmark_ == CrowdBenchmark::CrowdNavPlus;
  // The sum of steps of 0.1 s never is a multiple of five seconds, so this is for CrowdNav++ only.
  if (appears && std::fmod(time_, kGoalInterval) == 0.0) {
    for (std::size_t i = 0; i < people_.size(); ++i) {
      if (random_.unit() <= kGoalChangeShare) new_goal(i);
    }
  }
  for (std::size_t i = 0; i < people_.size(); ++i) {
    if (!((people_[i].goal - people_[i].position).norm() < people_[i].radius)) continue;
    if (!appears) {
      static_cast<void>(random_.unit());
      new_goal(i);
      continue;
    }
    CrowdPerson person = draw_character(random_, range_);
    do {
      person.position = draw_appearance(random_, rules_.circle);
    } while (!is_clear(person.position, person.radius, robot, robot_goal, std::nullopt));
    person.goal = -person.position;
    people_[i] = person;
    assumed_[i].reset();
  }
}

}  // namespace fairway
