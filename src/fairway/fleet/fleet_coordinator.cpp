// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/fleet_coordinator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "fairway/fleet/roundabout.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kFurthestTime = 8.0;      // [s] ahead in which meetings are detected
constexpr double kMeetingClearance = 0.3;  // [m] between bodies that count as not meeting
constexpr double kLaneGap = 0.15;          // [m] between bodies on a roundabout
// Share of the radius: smaller differences between roundabouts are ignored.
constexpr double kNoticeable = 0.02;
constexpr double kPatience = 1.0;      // [s] of standstill until a roundabout is enlarged
constexpr double kGrowth = 1.25;       // factor by which it is enlarged
constexpr double kWidest = 8.0;        // [m]
constexpr std::size_t kMostMet = 8;    // number of robots considered in narrow places
constexpr double kLongestWait = 20.0;  // [s] of waiting for robots that do not move
constexpr double kTryingTime = 4.0;    // [s] of driving after that
// [m/s]; a faster robot is approaching, and the waiting time does not count.
constexpr double kApproaching = 0.1;
constexpr double kSearchPeriod = 0.5;  // [s] between unsuccessful searches for a retreat path
// Cosine of the angle between two paths; below it they are head-on.
constexpr double kHeadOn = -0.5;

// Motion at constant velocity along a line, to its end.
struct StraightMotion {
  Vector2d start;
  Vector2d velocity;
  double duration;  // [s]
};

StraightMotion straight_motion(const Vector2d& from, const Vector2d& to, double speed) noexcept {
  const Vector2d line = to - from;
  const double length = line.norm();
  if (length < 1e-6) return {.start = from, .velocity = Vector2d::Zero(), .duration = 0.0};
  return {.start = from, .velocity = speed / length * line, .duration = length / speed};
}

// Returns the time at which two robots are nearest to each other while both are on their lines [s].
double nearest_time(const StraightMotion& a, const StraightMotion& b) noexcept {
  const Vector2d between = b.start - a.start;
  const Vector2d relative = b.velocity - a.velocity;
  const double most = std::min({a.duration, b.duration, kFurthestTime});
  const double squared = relative.squaredNorm();
  return squared > 0.0 ? std::clamp(-between.dot(relative) / squared, 0.0, most) : 0.0;
}

bool path_is_free(const ReferencePath& path, double radius, const BitGrid& obstacles) noexcept {
  for (std::size_t i = 1; i < static_cast<std::size_t>(path.count); ++i) {
    if (!is_free(obstacles, path.points[i - 1], path.points[i], radius)) return false;
  }
  return true;
}

}  // namespace

Roundabout FleetCoordinator::meet(const ReferencePath& path,
                                  const FleetCoordinatorInput& input) noexcept {
  const double radius = input.radius;
  const StraightMotion own = straight_motion(path.points[0], path.points[1], input.speed_max);
  Vector2d sum = Vector2d::Zero();
  int others = 0;
  bool head_on = false;
  double widest = radius;
  for (const FleetMember& member : input.fleet) {
    const SharedMotion& motion = *member.motion;
    if (!motion.under_way || motion.way.count == 0) continue;
    const StraightMotion theirs =
        straight_motion(motion.position, motion.way.points[0], motion.speed_max);
    const double time = nearest_time(own, theirs);
    const Vector2d a = own.start + time * own.velocity;
    const Vector2d b = theirs.start + time * theirs.velocity;
    if (time <= 0.0 || (b - a).norm() > radius + motion.radius + kMeetingClearance) continue;
    sum += 0.5 * (a + b);
    ++others;
    widest = std::max(widest, motion.radius);
    head_on = head_on || own.velocity.dot(theirs.velocity) <
                             kHeadOn * own.velocity.norm() * theirs.velocity.norm();
  }
  if (others == 0 || (others == 1 && !head_on)) return {};
  // A regular polygon with a robot at each corner and clearance along each side.
  const double side = 2.0 * widest + kLaneGap;
  return {.center = sum / others,
          .radius = side / (2.0 * std::sin(std::numbers::pi / (others + 1)))};
}

// Adopts `other` if the two overlap and it is noticeably larger, so that both robots use the same.
void FleetCoordinator::adopt_if_larger(const Roundabout& other) noexcept {
  const double between = (other.center - roundabout_.center).norm();
  if (between > other.radius + roundabout_.radius) return;
  if (other.radius > (1.0 + kNoticeable) * roundabout_.radius) roundabout_ = other;
}

// Keeps the retreat path while it is valid. Otherwise searches another one, a part per cycle, and
// pauses where there is none.
void FleetCoordinator::update_retreat(const Vector2d& here,
                                      const PassingEnvironment& around,
                                      double dt) noexcept {
  shorten(retreat_, here, *around.obstacles, around.radius);
  if (is_still_valid(retreat_, here, around)) return search_.stop();
  const bool had_one = retreat_.exists();
  retreat_ = {};
  since_search_ += dt;
  if (!search_.running()) {
    if (!had_one && since_search_ < kSearchPeriod) return;
    since_search_ = 0.0;
    search_.begin(here, around);
  }
  std::optional<RetreatPath> found = search_.advance(around);
  if (!found) return;
  // The robots have moved since the search began.
  shorten(*found, here, *around.obstacles, around.radius);
  if (is_still_valid(*found, here, around)) retreat_ = *found;
}

// Returns the cost of retreating. It is the length of the robot's own retreat path, or of a
// follower's if that is longer. A follower has to retreat first.
double FleetCoordinator::retreat_cost(const Vector2d& here,
                                      const PassingEnvironment& around) noexcept {
  double cost = retreat_.length(here);
  Vector2d from = here;
  for (const Vector2d& point : retreat_.points) {
    const OrientedRectangle piece = segment_rectangle(from, point);
    from = point;
    for (const FleetMember& member : around.fleet) {
      const SharedMotion& other = *member.motion;
      if (around.must_yield_to(other) || !other.under_way) continue;
      const double apart = (piece.nearest(other.position) - other.position).norm();
      if (apart < around.radius + other.radius) cost = std::max(cost, other.retreat_length);
    }
  }
  return cost;
}

// Returns whether this robot has priority over `other` in a narrow place.
bool FleetCoordinator::has_priority_over(const SharedMotion& other,
                                         std::uint32_t robot) const noexcept {
  if (other.can_step_aside != can_step_aside_) return !can_step_aside_;
  if (!can_step_aside_) {
    return std::pair(-retreat_length_, robot) < std::pair(-other.retreat_length, other.robot);
  }
  return is_nearer(other, robot);
}

bool FleetCoordinator::is_nearer(const SharedMotion& other, std::uint32_t robot) const noexcept {
  return std::pair(distance_to_bottleneck_, robot) <
         std::pair(other.distance_to_bottleneck, other.robot);
}

// Decides whether the robot steps aside for others; it then waits at the end of the retreat path.
bool FleetCoordinator::must_step_aside(const ReferencePath& path,
                                       const FleetCoordinatorInput& input) noexcept {
  std::array<const SharedMotion*, kMostMet> met{};
  std::array<bool, kMostMet> merges{};
  std::size_t count = 0;
  bool goal_blocks = false;  // letting a robot pass would not help: its goal blocks the path
  distance_to_bottleneck_ = std::numeric_limits<double>::infinity();
  retreat_length_ = 0.0;
  can_step_aside_ = true;
  if (input.fleet.empty()) return false;
  const NarrowPlaces narrow(path, input.radius, *input.obstacles);
  for (const FleetMember& member : input.fleet) {
    if (!member.motion->under_way || count == kMostMet) continue;
    double length = narrow.length_to_meeting(*member.motion, input.radius);
    merges[count] = !std::isfinite(length);
    if (merges[count]) length = narrow.length_to_merging(*member.motion, input.radius);
    if (!std::isfinite(length)) continue;
    met[count] = member.motion;
    ++count;
    distance_to_bottleneck_ = std::min(distance_to_bottleneck_, length);
    goal_blocks =
        goal_blocks || (!merges[count - 1] && narrow.contain_goal_of(*member.motion, input.radius));
  }
  if (count == 0) {
    waited_ = std::min(0.0, waited_ + input.dt);
    return false;
  }
  const Vector2d& here = path.points[0];
  PassingEnvironment around{.obstacles = input.obstacles,
                            .fleet = input.fleet,
                            .passing = {met.data(), count},
                            .radius = input.radius};
  can_step_aside_ = !goal_blocks && passing_place(here, around).has_value();
  if (goal_blocks) {
    retreat_ = {};
    retreat_length_ = std::numeric_limits<double>::infinity();
  } else if (!can_step_aside_) {
    update_retreat(here, around, input.dt);
    retreat_length_ = retreat_cost(here, around);
  }
  bool first = true;
  bool approaching = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (merges[i] ? is_nearer(*met[i], input.robot) : has_priority_over(*met[i], input.robot)) {
      met[i] = nullptr;
    } else {
      first = false;
      approaching = approaching || met[i]->speed > kApproaching;
    }
  }
  if (first) {
    waited_ = std::min(0.0, waited_ + input.dt);
    return false;
  }
  if (!approaching || waited_ < 0.0) waited_ += input.dt;
  if (waited_ > kLongestWait) waited_ = -kTryingTime;
  if (waited_ < 0.0) return false;
  if (!can_step_aside_) return retreat_.exists();
  shorten(retreat_, here, *around.obstacles, around.radius);
  if (!is_still_valid(retreat_, here, around)) {
    const std::optional<Vector2d> place = passing_place(here, around);
    retreat_ = {};
    if (place) retreat_.points.push_back(*place);
  }
  return retreat_.exists();
}

void FleetCoordinator::follow_retreat(const Vector2d& here) noexcept {
  path_.count = 1;
  path_.points[0] = here;
  path_.arc[0] = 0.0;
  for (const Vector2d& point : retreat_.points) {
    const auto at = static_cast<std::size_t>(path_.count++);
    path_.points[at] = point;
    path_.arc[at] = path_.arc[at - 1] + (path_.points[at] - path_.points[at - 1]).norm();
  }
  path_.ends_at_goal = true;
}

const ReferencePath& FleetCoordinator::update(const ReferencePath& path,
                                              const FleetCoordinatorInput& input) noexcept {
  if (must_step_aside(path, input)) {
    roundabout_ = {};
    waits_ = true;
    follow_retreat(path.points[0]);
    return path_;
  }
  waits_ = false;
  if (can_step_aside_) retreat_ = {};
  if (roundabout_.exists() && !bend_around(path, roundabout_, path_)) roundabout_ = {};
  if (const Roundabout met = meet(path, input); met.exists()) {
    if (roundabout_.exists()) {
      adopt_if_larger(met);
    } else {
      roundabout_ = met;
    }
  }
  if (!roundabout_.exists()) return path;
  for (const FleetMember& member : input.fleet) {
    if (member.motion->roundabout.exists()) adopt_if_larger(member.motion->roundabout);
  }
  stopped_for_ = input.stopped ? stopped_for_ + input.dt : 0.0;
  if (stopped_for_ > kPatience) {
    stopped_for_ = 0.0;
    roundabout_.radius = std::min(kGrowth * roundabout_.radius, kWidest);
  }
  if (bend_around(path, roundabout_, path_) &&
      path_is_free(path_, input.radius, *input.obstacles)) {
    return path_;
  }
  roundabout_ = {};
  return path;
}

}  // namespace fairway
