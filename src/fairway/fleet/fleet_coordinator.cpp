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

constexpr double kFurthestTime = 8.0;      // [s] ahead that meetings are looked for
constexpr double kMeetingClearance = 0.3;  // [m] between bodies that do not meet
constexpr double kLane = 0.15;             // [m] between bodies on a roundabout
constexpr double kNoticeable = 0.02;       // of a radius
constexpr double kPatience = 1.0;          // [s] of standing, before a roundabout is made wider
constexpr double kGrowth = 1.25;           // then
constexpr double kWidest = 8.0;            // [m]
constexpr std::size_t kMostMet = 8;        // robots in narrow places that are minded
constexpr double kLongestWait = 20.0;      // [s]
constexpr double kTrying = 4.0;            // [s] of going on after that
constexpr double kComing = 0.1;            // [m/s] of somebody who need not be waited for in vain
constexpr double kSearchPeriod = 0.5;      // [s] between searches for a way back in vain
constexpr double kHeadOn = -0.5;           // cosine between two ways; below it they are head-on

// An even motion along a straight way, to its end.
struct StraightWay {
  Vector2d start;
  Vector2d velocity;
  double duration;  // [s]
};

StraightWay straight_way(const Vector2d& from, const Vector2d& to, double speed) noexcept {
  const Vector2d way = to - from;
  const double length = way.norm();
  if (length < 1e-6) return {.start = from, .velocity = Vector2d::Zero(), .duration = 0.0};
  return {.start = from, .velocity = speed / length * way, .duration = length / speed};
}

// When two ways come nearest while both robots are on theirs [s].
double nearest_time(const StraightWay& a, const StraightWay& b) noexcept {
  const Vector2d between = b.start - a.start;
  const Vector2d relative = b.velocity - a.velocity;
  const double most = std::min({a.duration, b.duration, kFurthestTime});
  const double squared = relative.squaredNorm();
  return squared > 0.0 ? std::clamp(-between.dot(relative) / squared, 0.0, most) : 0.0;
}

bool way_is_free(const ReferencePath& path, double radius, const BitGrid& obstacles) noexcept {
  for (std::size_t i = 1; i < static_cast<std::size_t>(path.count); ++i) {
    if (!is_free(obstacles, path.points[i - 1], path.points[i], radius)) return false;
  }
  return true;
}

}  // namespace

Roundabout FleetCoordinator::meet(const ReferencePath& path,
                                  const FleetCoordinatorInput& input) noexcept {
  const double radius = input.radius;
  const StraightWay own = straight_way(path.points[0], path.points[1], input.speed_max);
  Vector2d sum = Vector2d::Zero();
  int others = 0;
  bool head_on = false;
  double widest = radius;
  for (const FleetMember& member : input.fleet) {
    const SharedMotion& motion = *member.motion;
    if (!motion.under_way || motion.way.count == 0) continue;
    const StraightWay way = straight_way(motion.position, motion.way.points[0], motion.speed_max);
    const double time = nearest_time(own, way);
    const Vector2d a = own.start + time * own.velocity;
    const Vector2d b = way.start + time * way.velocity;
    if (time <= 0.0 || (b - a).norm() > radius + motion.radius + kMeetingClearance) continue;
    sum += 0.5 * (a + b);
    ++others;
    widest = std::max(widest, motion.radius);
    head_on = head_on ||
              own.velocity.dot(way.velocity) < kHeadOn * own.velocity.norm() * way.velocity.norm();
  }
  if (others == 0 || (others == 1 && !head_on)) return {};
  // A regular polygon with a robot at each corner and room along each side.
  const double side = 2.0 * widest + kLane;
  return {.center = sum / others,
          .radius = side / (2.0 * std::sin(std::numbers::pi / (others + 1)))};
}

// The larger of two that overlap; of unequal ones both robots so come to the same.
void FleetCoordinator::give_way_to(const Roundabout& other) noexcept {
  const double between = (other.center - roundabout_.center).norm();
  if (between > other.radius + roundabout_.radius) return;
  if (other.radius > (1.0 + kNoticeable) * roundabout_.radius) roundabout_ = other;
}

// Keeps the way back while it leads aside, and else looks for one, but not too often in vain.
void FleetCoordinator::look_back(const Vector2d& here,
                                 const PassingEnvironment& around,
                                 double dt) noexcept {
  shorten(back_, here, *around.obstacles, around.radius);
  if (leads_aside(back_, here, around)) return;
  const bool had_one = back_.exists();
  back_ = {};
  since_search_ += dt;
  if (!had_one && since_search_ < kSearchPeriod) return;
  since_search_ = 0.0;
  back_ = find_retreat_path(here, around);
}

// What going back costs: the own way, or that of who follows and has to go back first.
double FleetCoordinator::cost_of_back(const Vector2d& here,
                                      const PassingEnvironment& around) noexcept {
  double cost = back_.length(here);
  Vector2d from = here;
  for (std::size_t i = 0; i < static_cast<std::size_t>(back_.count); ++i) {
    const OrientedRectangle piece = segment_rectangle(from, back_.points[i]);
    from = back_.points[i];
    for (const FleetMember& member : around.fleet) {
      const SharedMotion& other = *member.motion;
      if (around.must_yield_to(other) || !other.under_way) continue;
      const double apart = (piece.nearest(other.position) - other.position).norm();
      if (apart < around.radius + other.radius) cost = std::max(cost, other.retreat_length);
    }
  }
  return cost;
}

// Whether this robot goes first where it meets `other` in a narrow place.
bool FleetCoordinator::goes_before(const SharedMotion& other, std::uint32_t robot) const noexcept {
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

// Whether to wait for somebody, at the end of `back_`, or go there.
bool FleetCoordinator::steps_aside(const ReferencePath& path,
                                   const FleetCoordinatorInput& input) noexcept {
  std::array<const SharedMotion*, kMostMet> met{};
  std::array<bool, kMostMet> merges{};
  std::size_t count = 0;
  bool shut_in = false;  // letting somebody pass would not help: its goal is in the way
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
    shut_in = shut_in || (!merges[count - 1] && narrow.hold_goal_of(*member.motion, input.radius));
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
  can_step_aside_ = !shut_in && passing_place(here, around).has_value();
  if (shut_in) {
    back_ = {};
    retreat_length_ = std::numeric_limits<double>::infinity();
  } else if (!can_step_aside_) {
    look_back(here, around, input.dt);
    retreat_length_ = cost_of_back(here, around);
  }
  bool first = true;
  bool coming = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (merges[i] ? is_nearer(*met[i], input.robot) : goes_before(*met[i], input.robot)) {
      met[i] = nullptr;
    } else {
      first = false;
      coming = coming || met[i]->speed > kComing;
    }
  }
  if (first) {
    waited_ = std::min(0.0, waited_ + input.dt);
    return false;
  }
  if (!coming || waited_ < 0.0) waited_ += input.dt;
  if (waited_ > kLongestWait) waited_ = -kTrying;
  if (waited_ < 0.0) return false;
  if (!can_step_aside_) return back_.exists();
  shorten(back_, here, *around.obstacles, around.radius);
  if (!leads_aside(back_, here, around)) {
    const std::optional<Vector2d> place = passing_place(here, around);
    back_ = {};
    if (place) back_ = {.count = 1, .points = {*place}};
  }
  return back_.exists();
}

void FleetCoordinator::lead_back(const Vector2d& here) noexcept {
  path_.count = 1;
  path_.points[0] = here;
  path_.arc[0] = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(back_.count); ++i) {
    const auto at = static_cast<std::size_t>(path_.count++);
    path_.points[at] = back_.points[i];
    path_.arc[at] = path_.arc[at - 1] + (path_.points[at] - path_.points[at - 1]).norm();
  }
  path_.ends_at_goal = true;
}

const ReferencePath& FleetCoordinator::update(const ReferencePath& path,
                                              const FleetCoordinatorInput& input) noexcept {
  if (steps_aside(path, input)) {
    roundabout_ = {};
    waits_ = true;
    lead_back(path.points[0]);
    return path_;
  }
  waits_ = false;
  if (can_step_aside_) back_ = {};
  if (roundabout_.exists() && !lead_round(path, roundabout_, path_)) roundabout_ = {};
  if (const Roundabout met = meet(path, input); met.exists()) {
    if (roundabout_.exists()) {
      give_way_to(met);
    } else {
      roundabout_ = met;
    }
  }
  if (!roundabout_.exists()) return path;
  for (const FleetMember& member : input.fleet) {
    if (member.motion->roundabout.exists()) give_way_to(member.motion->roundabout);
  }
  standing_ = input.standing ? standing_ + input.dt : 0.0;
  if (standing_ > kPatience) {
    standing_ = 0.0;
    roundabout_.radius = std::min(kGrowth * roundabout_.radius, kWidest);
  }
  if (lead_round(path, roundabout_, path_) && way_is_free(path_, input.radius, *input.obstacles)) {
    return path_;
  }
  roundabout_ = {};
  return path;
}

}  // namespace fairway
