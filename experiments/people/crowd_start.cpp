// SPDX-License-Identifier: Apache-2.0
// How the starts of the cases are drawn.
#include <cmath>
#include <numbers>

#include "experiments/people/crowd.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kStartGap = 0.25;  // between two people at the start, beyond both radii [m]

// Whether `place` is at least `gap` and both radii from the place and goal of each person.
bool is_apart(const Vector2d& place,
              double radius,
              double gap,
              const std::vector<CrowdPerson>& people) {
  for (const CrowdPerson& other : people) {
    const double least = radius + other.radius + gap;
    if ((place - other.position).norm() < least || (place - other.goal).norm() < least)
      return false;
  }
  return true;
}

bool is_near_robot(const Vector2d& place, double least, const CrowdCase& made) {
  return (place - made.start.position).norm() < least || (place - made.goal).norm() < least;
}

void draw_crowdnav(UniformRandom& random, CrowdCase& made) {
  constexpr double kApart = 0.2;
  made.start = {.position = {0.0, -4.0}, .heading = 0.5 * std::numbers::pi};
  made.goal = {0.0, 4.0};
  for (int i = 0; i < 5; ++i) {
    CrowdPerson person;
    do {
      person.position = draw_on_circle(random, 4.0, 1.0);
    } while (is_near_robot(person.position, 0.6 + kApart, made) ||
             !is_apart(person.position, person.radius, kApart, made.people));
    person.goal = -person.position;
    made.people.push_back(person);
  }
}

void draw_dsrnn(UniformRandom& random, CrowdCase& made) {
  constexpr double kFromRobot = 3.0;  // [m]
  const double angle = random.between(0.0, kTurn);
  made.start.position = 6.0 * Vector2d(std::cos(angle), std::sin(angle));
  do {
    made.goal.x() = random.between(-6.0, 6.0);
    made.goal.y() = random.between(-6.0, 6.0);
  } while ((made.goal - made.start.position).norm() < 6.0);
  made.start.heading = random.between(0.0, kTurn);
  for (int i = 0; i < 5; ++i) {
    CrowdPerson person;
    person.speed_max = random.between(0.5, 1.5);
    person.radius = random.between(0.3, 0.5);
    do {
      person.position = draw_on_circle(random, 6.0, person.speed_max);
    } while (is_near_robot(person.position, kFromRobot, made) ||
             !is_apart(person.position, person.radius, kStartGap, made.people));
    person.goal = -person.position;
    made.people.push_back(person);
  }
}

void draw_crowdnavpp(UniformRandom& random, CrowdCase& made, double& range) {
  constexpr int kPeople = 20;
  const double circle = crowd_rules(CrowdBenchmark::CrowdNavPlus).circle;
  do {
    made.start.position.x() = random.between(-6.0, 6.0);
    made.start.position.y() = random.between(-6.0, 6.0);
    made.goal.x() = random.between(-6.0, 6.0);
    made.goal.y() = random.between(-6.0, 6.0);
  } while ((made.goal - made.start.position).norm() < 8.0);
  made.start.heading = 0.5 * std::numbers::pi;
  for (int i = 0; i < kPeople; ++i) {
    CrowdPerson person = draw_character(random, range);
    do {
      person.position = draw_appearance(random, circle);
    } while (is_near_robot(person.position, person.radius + made.robot_radius + kStartGap, made) ||
             !is_apart(person.position, person.radius, kStartGap, made.people));
    person.goal = -person.position;
    made.people.push_back(person);
  }
}

}  // namespace

CrowdRules crowd_rules(CrowdBenchmark benchmark) noexcept {
  switch (benchmark) {
    case CrowdBenchmark::CrowdNav:
      return {};
    case CrowdBenchmark::DsRnn:
      return {.step = 0.1,
              .time_limit = 49.0,
              .circle = 6.0,
              .neighbours = 4,
              .added_radius = 0.16,
              .danger_gap = 0.25,
              .judges_before_move = true};
    case CrowdBenchmark::CrowdNavPlus:
      return {.step = 0.25,
              .time_limit = 49.0,
              .circle = 6.0 * std::numbers::sqrt2,
              .neighbours = 19,
              .added_radius = 0.16,
              .danger_gap = 0.0,
              .judges_before_move = true};
  }
  return {};
}

std::uint32_t crowd_seed(CrowdBenchmark benchmark, int number) noexcept {
  const int first = benchmark == CrowdBenchmark::CrowdNavPlus ? 1425 : 1000;
  return static_cast<std::uint32_t>(first + number);
}

Vector2d draw_on_circle(UniformRandom& random, double circle, double spread) {
  const double angle = kTurn * random.unit();
  const double x = (random.unit() - 0.5) * spread;
  const double y = (random.unit() - 0.5) * spread;
  return {circle * std::cos(angle) + x, circle * std::sin(angle) + y};
}

Vector2d draw_appearance(UniformRandom& random, double circle) {
  const double angle = kTurn * random.unit();
  const double x = 2.0 * random.unit();
  const double y = 2.0 * random.unit();
  return {circle * std::cos(angle) + x, circle * std::sin(angle) + y};
}

CrowdPerson draw_character(UniformRandom& random, double& range) {
  range = random.between(5.0, 10.0);
  CrowdPerson person;
  person.speed_max = random.between(0.5, 1.5);
  person.radius = random.between(0.3, 0.5);
  return person;
}

CrowdCase draw_case(CrowdBenchmark benchmark,
                    int number,
                    std::uint32_t seed,
                    UniformRandom* random,
                    double* range) {
  CrowdCase made;
  made.number = number;
  made.seed = seed;
  UniformRandom own(seed);
  double seen = 10.0;
  switch (benchmark) {
    case CrowdBenchmark::CrowdNav:
      draw_crowdnav(own, made);
      break;
    case CrowdBenchmark::DsRnn:
      draw_dsrnn(own, made);
      break;
    case CrowdBenchmark::CrowdNavPlus:
      draw_crowdnavpp(own, made, seen);
      break;
  }
  if (random != nullptr) *random = own;
  if (range != nullptr) *range = seen;
  return made;
}

}  // namespace fairway
