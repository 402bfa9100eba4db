// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/people_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/people/recorded_site.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Distance of the origin from the segment between two points.
double distance_to_segment(const Vector2d& from, const Vector2d& to) noexcept {
  const Vector2d along = to - from;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp(-from.dot(along) / length2, 0.0, 1.0) : 0.0;
  return (from + share * along).norm();
}

// What is common to the runs of all benchmarks.
class Run {
 public:
  Run(int number,
      const PeopleOptions& options,
      const Pose2& start,
      const Vector2d& goal,
      double window)
      : robot_(options.settings, options.kinematics, start, goal, window, options.clock),
        period_(options.settings.navigation.control_period),
        on_cycle_(options.on_cycle) {
    result_.number = number;
    result_.closest = kInfinity;
    result_.rows.push_back({.time = 0.0, .pose = start});
  }

  [[nodiscard]] PeopleRobot& robot() noexcept { return robot_; }
  [[nodiscard]] Vector2d place() const noexcept { return robot_.pose().position; }
  [[nodiscard]] PeopleRun& result() noexcept { return result_; }

  // One control cycle; @return where the robot was before it.
  Vector2d cycle(std::span<const SeenPerson> people) {
    const Vector2d before = place();
    const double time = static_cast<double>(result_.rows.size() - 1) * period_;
    robot_.cycle(time, people);
    if (on_cycle_) on_cycle_(time, robot_, people);
    result_.path += (place() - before).norm();
    result_.rows.push_back(
        {.time = static_cast<double>(result_.rows.size()) * period_, .pose = robot_.pose()});
    return before;
  }

  PeopleRun end(PeopleOutcome outcome, double time) {
    result_.outcome = outcome;
    result_.time = time;
    result_.cycle_seconds = robot_.cycle_seconds();
    if (result_.closest == kInfinity) result_.closest = 100.0;  // no person was there
    return std::move(result_);
  }

 private:
  PeopleRobot robot_;
  double period_;
  decltype(PeopleOptions::on_cycle) on_cycle_;
  PeopleRun result_;
};

std::vector<SeenPerson> seen_in(const std::vector<RecordedPlace>& places, double radius) {
  std::vector<SeenPerson> people;
  for (const RecordedPlace& place : places)
    people.push_back({.id = place.person, .position = place.position, .radius = radius});
  return people;
}

double least_distance(const Vector2d& robot, const std::vector<RecordedPlace>& places) {
  double least = kInfinity;
  for (const RecordedPlace& place : places)
    least = std::min(least, (place.position - robot).norm());
  return least;
}

// Whether a person who is in both frames was touched between them.
bool touches_between(const Vector2d& before,
                     const Vector2d& after,
                     const std::vector<RecordedPlace>& then,
                     const std::vector<RecordedPlace>& now,
                     double contact) {
  for (const RecordedPlace& place : then) {
    const auto next = std::find_if(now.begin(), now.end(), [&](const RecordedPlace& other) {
      return other.person == place.person;
    });
    if (next != now.end() &&
        distance_to_segment(place.position - before, next->position - after) < contact)
      return true;
  }
  return false;
}

int cycles_per_step(const Settings& settings, double step) {
  return static_cast<int>(std::lround(step / settings.navigation.control_period));
}

// A run among simulated people, step by step.
class CrowdRun {
 public:
  CrowdRun(CrowdBenchmark benchmark, const CrowdCase& one, const PeopleOptions& options)
      : benchmark_(benchmark),
        rules_(crowd_rules(benchmark)),
        case_(one),
        cycles_(cycles_per_step(options.settings, rules_.step)),
        crowd_(benchmark, one),
        run_(one.number, options, one.start, one.goal, options.settings.navigation.control_period) {
  }

  PeopleRun drive() {
    for (double time = 0.0;; time += rules_.step) {
      if (rules_.judges_before_move) {
        const double gap = least_gap();
        if (time >= rules_.time_limit) return run_.end(PeopleOutcome::Timeout, time);
        if (gap < 0.0) {
          run_.result().contact_between_steps = true;
          return run_.end(PeopleOutcome::Contact, time);
        }
        if ((run_.place() - case_.goal).norm() < kGoalRadius)
          return run_.end(PeopleOutcome::Success, time);
        note_gap(gap);
        count_danger(gap < rules_.danger_gap || intrudes());
        move();
        continue;
      }
      const double gap = move();
      if (time >= rules_.time_limit) return run_.end(PeopleOutcome::Timeout, time + rules_.step);
      if (gap < 0.0) return run_.end(PeopleOutcome::Contact, time + rules_.step);
      if ((run_.place() - case_.goal).norm() < kGoalRadius)
        return run_.end(PeopleOutcome::Success, time + rules_.step);
      note_gap(gap);
      count_danger(gap < rules_.danger_gap);
    }
  }

 private:
  static constexpr double kGoalRadius = 0.3;  // [m]

  void note_gap(double gap) { run_.result().closest = std::min(run_.result().closest, gap); }

  void count_danger(bool danger) {
    ++run_.result().steps;
    if (danger) ++run_.result().danger;
  }

  [[nodiscard]] double reach(const CrowdPerson& person) const {
    return person.radius + case_.robot_radius;
  }

  double least_gap() {
    double least = kInfinity;
    for (const CrowdPerson& person : crowd_.people())
      least = std::min(least, (person.position - run_.place()).norm() - reach(person));
    return least;
  }

  // CrowdNav++: whether the robot is where a visible person will be in the next five steps.
  bool intrudes() {
    constexpr int kAhead = 5;
    constexpr double kNear = 0.6;  // [m]
    if (benchmark_ != CrowdBenchmark::CrowdNavPlus) return false;
    for (const std::vector<Vector2d>& places : crowd_.look_ahead(kAhead)) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (is_visible(crowd_.people()[i], crowd_.people()[i].position) &&
            (places[i] - run_.place()).norm() < kNear)
          return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool is_visible(const CrowdPerson& person, const Vector2d& position) const {
    constexpr double kSight = 5.0;  // between the bodies [m]
    return benchmark_ != CrowdBenchmark::CrowdNavPlus ||
           (position - run_.place()).norm() - reach(person) <= kSight;
  }

  // All move by a step. @return the least gap in it by the rule of CrowdNav, which takes the
  // person's velocity of the step before.
  double move() {
    const std::vector<CrowdPerson> before = crowd_.people();
    const std::vector<Vector2d> velocities = crowd_.choose();
    const Vector2d start = run_.place();
    const double part = rules_.step / cycles_;
    for (int cycle = 0; cycle < cycles_; ++cycle) {
      std::vector<SeenPerson> seen;
      for (std::size_t i = 0; i < before.size(); ++i) {
        const Vector2d position = before[i].position + cycle * part * velocities[i];
        if (is_visible(before[i], position))
          seen.push_back({.id = id_of(i), .position = position, .radius = before[i].radius});
      }
      const Vector2d from = run_.cycle(seen);
      for (std::size_t i = 0; i < before.size(); ++i) {
        const Vector2d person = before[i].position + cycle * part * velocities[i];
        if (distance_to_segment(person - from, person + part * velocities[i] - run_.place()) <
            reach(before[i]))
          run_.result().contact_between_steps = true;
      }
    }
    double least = kInfinity;
    const Vector2d driven = run_.place() - start;
    for (const CrowdPerson& person : before) {
      const Vector2d apart = person.position - start;
      const Vector2d after = apart + rules_.step * person.velocity - driven;
      least = std::min(least, distance_to_segment(apart, after) - reach(person));
    }
    crowd_.move(velocities, run_.place(), case_.goal);
    note_replaced(before, velocities);
    return least;
  }

  // A person who appears elsewhere is another one.
  void note_replaced(const std::vector<CrowdPerson>& before,
                     const std::vector<Vector2d>& velocities) {
    constexpr double kJump = 1e-6;  // [m]
    lives_.resize(before.size(), 0);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vector2d moved = before[i].position + rules_.step * velocities[i];
      if ((crowd_.people()[i].position - moved).norm() > kJump) ++lives_[i];
    }
  }

  [[nodiscard]] int id_of(std::size_t person) const {
    constexpr int kLives = 10000;
    return static_cast<int>(person) * kLives + (person < lives_.size() ? lives_[person] : 0);
  }

  CrowdBenchmark benchmark_;
  CrowdRules rules_;
  const CrowdCase& case_;
  int cycles_;
  Crowd crowd_;
  Run run_;
  std::vector<int> lives_;
};

}  // namespace

PeopleRun run_recorded(const RecordedCase& task,
                       const PeopleRecording& recording,
                       const PeopleOptions& options) {
  constexpr double kContact = 0.5;     // between the centres [m]
  constexpr double kWindow = 0.3;      // over which velocities are estimated [s]
  constexpr double kGoalRadius = 1.0;  // [m]
  const Vector2d ahead = task.goal - task.start;
  Run run(task.number, options,
          {.position = task.start, .heading = std::atan2(ahead.y(), ahead.x())}, task.goal,
          kWindow);
  const double radius = std::max(0.0, kContact - options.settings.robot.radius);
  RecordedSite site(recording, task);
  run.robot().remember(&site.entrances());
  for (int k = -3; k < 0; ++k)
    run.robot().watch(k * PeopleRecording::kFrame,
                      seen_in(recording.at(task.start_frame + k), radius));
  const int limit = static_cast<int>(std::lround(task.time_limit / PeopleRecording::kFrame));
  for (int k = 0; k < limit; ++k) {
    const double time = k * PeopleRecording::kFrame;
    const std::vector<RecordedPlace>& people = recording.at(task.start_frame + k);
    if ((run.place() - task.goal).norm() < kGoalRadius)
      return run.end(PeopleOutcome::Success, time);
    const double least = least_distance(run.place(), people);
    run.result().closest = std::min(run.result().closest, least);
    if (least < kContact) {
      run.result().contact_between_steps = true;
      return run.end(PeopleOutcome::Contact, time);
    }
    ++run.result().steps;
    site.watch_until(task.start_frame + k);
    const Vector2d before = run.cycle(seen_in(people, radius));
    if (touches_between(before, run.place(), people, recording.at(task.start_frame + k + 1),
                        kContact))
      run.result().contact_between_steps = true;
  }
  return run.end(PeopleOutcome::Timeout, limit * PeopleRecording::kFrame);
}

PeopleRun run_crowd(CrowdBenchmark benchmark, const CrowdCase& one, const PeopleOptions& options) {
  return CrowdRun(benchmark, one, options).drive();
}

}  // namespace fairway
