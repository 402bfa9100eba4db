// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/people_robot.hpp"

#include <cmath>

namespace fairway {

namespace {

using Eigen::Vector2d;

// A free map around start and goal.
OccupancyGrid open_map(const Vector2d& start, const Vector2d& goal) {
  constexpr double kResolution = 0.2;  // [m]
  constexpr double kAround = 12.0;     // [m]
  const Vector2d low = start.cwiseMin(goal).array() - kAround;
  const Vector2d size = (start - goal).cwiseAbs().array() + 2.0 * kAround;
  GridFrame frame;
  frame.width = static_cast<int>(std::ceil(size.x() / kResolution));
  frame.height = static_cast<int>(std::ceil(size.y() / kResolution));
  frame.resolution = kResolution;
  frame.origin.position = low;
  return OccupancyGrid(frame, CellState::Free);
}

}  // namespace

PeopleRobot::PeopleRobot(const Settings& settings,
                         Kinematics kinematics,
                         const Pose2& start,
                         const Vector2d& goal,
                         double window,
                         std::function<double()> clock)
    : navigator_(settings, open_map(start.position, goal)),
      kinematics_(kinematics),
      period_(settings.navigation.control_period),
      base_{.pose = start, .twist = {}, .limits = limits_of(settings.robot)},
      clock_(std::move(clock)),
      window_(window) {
  navigator_.set_goal({.position = goal, .heading = {}});
}

void PeopleRobot::watch(double time, std::span<const SeenPerson> people) {
  constexpr double kRounding = 1e-6;  // [s]
  std::unordered_map<int, std::vector<Sighting>> now;
  obstacles_.clear();
  for (const SeenPerson& person : people) {
    std::vector<Sighting>& past = now[person.id];
    if (const auto before = seen_.find(person.id); before != seen_.end())
      past = std::move(before->second);
    while (!past.empty() && past.front().time < time - window_ - kRounding)
      past.erase(past.begin());
    Vector2d velocity = Vector2d::Zero();
    if (!past.empty() && time > past.front().time)
      velocity = (person.position - past.front().position) / (time - past.front().time);
    past.push_back({.time = time, .position = person.position});
    obstacles_.push_back(
        {.position = person.position, .velocity = velocity, .radius = person.radius});
  }
  seen_ = std::move(now);
}

void PeopleRobot::cycle(double time, std::span<const SeenPerson> people) {
  watch(time, people);
  const double before = clock_();
  step_ = navigator_.update(
      {.time = time, .pose = base_.pose, .obstacles = obstacles_, .entrances = entrances_});
  seconds_.push_back(clock_() - before);
  if (kinematics_ == Kinematics::Ours) {
    base_.advance(step_.command, period_);
    return;
  }
  base_.twist = step_.command;
  base_.advance(step_.command, period_);
}

}  // namespace fairway
