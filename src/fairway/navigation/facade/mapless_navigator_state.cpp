// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/mapless_navigator_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "fairway/map/free_space.hpp"
#include "fairway/navigation/facade/obstacle_merge.hpp"
#include "fairway/tracking/corridor_check.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Moves a setting into its range.
constexpr auto limit_to_range = [](auto& value, const SettingInfo& info) {
  if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, double>)
    value = std::clamp(value, info.min, info.max);
};

// A cell of the map may become occupied although the obstacle lies at its far side. The margins are
// larger by that amount, so that the robot then still has its required clearance.
Settings with_margins(const Settings& settings) {
  Settings wider = settings;
  wider.path.margin += settings.perception.resolution;
  wider.safety.stop_margin += 0.5 * settings.perception.resolution;
  // Settings at the end of their range are allowed without a map, too: then there is no more.
  visit_path(wider.path, limit_to_range);
  visit_safety(wider.safety, limit_to_range);
  return wider;
}

// Returns the distance that the robot can cover within a horizon [m].
double reach_of_horizon(const Settings& settings) noexcept {
  return settings.mpc.horizon * settings.mpc.step_length * settings.robot.linear_max;
}

// Returns the part of a full turn that a scan does not cover [rad]; a small part counts as none.
double blind_angle(const LidarScan& scan) noexcept {
  constexpr double kSmall = 0.1;  // [rad]
  const double covered = std::abs(scan.angle_step) * static_cast<double>(scan.ranges.size());
  const double left = 2.0 * std::numbers::pi - covered;
  return left > kSmall ? left : 0.0;
}

}  // namespace

MaplessNavigator::State::State(const Settings& given,
                               ControlSolver* given_solver,
                               const Vector2d& position)
    : settings(given),
      solver(given_solver),
      wider(with_margins(given)),
      perception(given.perception, is_plausible(position) ? position : Vector2d(Vector2d::Zero())),
      navigator(solver != nullptr ? Navigator(wider, *solver) : Navigator(wider)),
      planning(std::make_unique<LocalPlanning>(wider, perception.grid().occupied())) {}

void MaplessNavigator::State::set_task(NavigationTask given) {
  task.begin(std::move(given));
  ++task_number_;
  plan_is_current = false;
  asked_for_plan_ = true;
  search_narrow_ = false;
  path_length_ = kInfinity;
  plan_time_ = -kInfinity;
  lost_.reset();
  tried_.clear();
  search_opening_ = false;
  if (!task.can_be_done()) navigator.cancel();
}

void MaplessNavigator::State::set_zones(const Zones& given) {
  if (const Expected<void> valid = validate(given); !valid)
    throw std::invalid_argument(valid.error().message);
  zones = given;
  perception.set_zones(given.empty() ? nullptr
                                     : std::make_shared<const ZoneMap>(given, wider.robot.radius));
  asked_for_plan_ = true;
  plan_time_ = -kInfinity;  // at once
}

// The thread of a plan that is being made ends on its own: nothing waits for it here.
void MaplessNavigator::State::continue_from(State& older) {
  navigator.continue_from(older.navigator);
  sent = older.sent;
  hold = older.hold;
  // What was seen stays, unless it would be seen in another way now.
  if (settings.perception == older.settings.perception) {
    perception = std::move(older.perception);
    scans_ = older.scans_;
    blind_angle_ = older.blind_angle_;
    scan_refused_ = older.scan_refused_;
  } else {
    perception.keep_correction(older.perception);
  }
  set_zones(older.zones);
  ending_ = std::move(older.ending_);
  ending_.push_back(std::move(older.planning));
  if (older.task.task()) set_task(*older.task.task());
}

bool MaplessNavigator::State::observe(const LidarScan& scan, const Vector2d& position) {
  scan_refused_ = !is_plausible(scan, position);
  if (scan_refused_) return false;
  perception.observe(scan, position, wider.robot.radius);
  ++scans_;
  blind_angle_ = blind_angle(scan);
  rolled_ = rolled_ || perception.grid().rolled();
  planning->note_change(perception.grid().changed());
  return true;
}

// Returns whether to plan now. If the robot is about to meet a new obstacle, it plans at once; in
// other cases at most once per kRetryAfter.
bool MaplessNavigator::State::needs_plan(double time, const Vector2d& position) const noexcept {
  constexpr double kRetryAfter = 0.25;  // [s]; without a path, or to extend the corridor
  constexpr double kSoon = 1.0;         // [m], beyond the braking distance
  if (!task.can_be_done() || planning->busy()) return false;
  const CorridorFollower& corridor = navigator.corridor();
  if (lost_.active()) return search_opening_ || time - plan_time_ >= kRetryAfter;
  const bool driven_on = navigator.plan().usable() && corridor.reference_path().count > 0;
  // A cell that flickers at a side must not cause a new plan.
  const double flicker = 0.5 * wider.perception.resolution;
  const auto is_free_for = [&](double length) {
    return corridor_is_free(perception.grid().occupied(), corridor, wider.robot.radius, flicker,
                            length);
  };
  if (search_narrow_ || (driven_on && !is_free_for(braking_distance(wider.robot) + kSoon)))
    return true;
  if (time - plan_time_ < kRetryAfter) return false;
  if (!driven_on || asked_for_plan_ || (tight_start_ && has_clearance(position))) return true;
  if (!leads_to_goal_ && corridor.remaining() < reach_of_horizon(wider)) return true;
  return !is_free_for(kInfinity) || !path_is_free();
}

// Whether the disc that covers the robot fits there.
bool MaplessNavigator::State::has_clearance(const Vector2d& position) const noexcept {
  const double radius = wider.robot.radius;
  return distance_to_blocked(perception.grid().occupied(), position, radius) > radius;
}

// Returns whether the path beyond the corridor is still free, so that a dead end is detected early.
bool MaplessNavigator::State::path_is_free() const noexcept {
  const Plan& now = navigator.plan();
  if (now.whole) return true;
  const double clearance = std::max(0.0, wider.robot.radius - 0.5 * wider.perception.resolution);
  const std::vector<Vector2d>& points = now.path.waypoints;
  double covered = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    covered += (points[i] - points[i - 1]).norm();
    if (covered < LocalPlanning::corridor_length(wider)) continue;
    if (!is_free(perception.grid().occupied(), points[i - 1], points[i], clearance)) return false;
  }
  return true;
}

void MaplessNavigator::State::start_plan(double time, const Pose2& pose) {
  constexpr double kNarrow = 0.05;  // share of the margin kept in the narrowest places
  planned = true;
  plan_time_ = time;
  tight_start_ = !has_clearance(pose.position);
  asked_number_ = task_number_;
  const double desired = wider.path.margin;
  const bool narrow = std::exchange(search_narrow_, false);
  planning->start(perception.grid().occupied(),
                  {.position = pose.position,
                   .goal = task.task()->goal,
                   .along = task.task()->along,
                   .margin = narrow ? kNarrow * desired : std::min(desired, 2.0 * last_margin_),
                   .narrow = narrow,
                   .find_opening = std::exchange(search_opening_, false),
                   .tried = tried_});
}

void MaplessNavigator::State::take_plan() {
  constexpr double kDetour = 1.0;  // [m]; a path that much longer than the last one is a detour
  constexpr double kWorthNarrow = 0.7;  // of the length of the wide path
  std::optional<LocalPlan> made = planning->take();
  if (!made || !task.task() || asked_number_ != task_number_) return;
  Plan& found = made->plan;
  if (made->request.narrow) {
    if (!found.usable() || found.path.length() >= kWorthNarrow * path_length_) return;
  } else {
    // Before a long detour, search for a path through a narrower place in the next cycle. Until
    // then the robot does not move far.
    search_narrow_ = found.usable() && found.path.length() > path_length_ + kDetour;
  }
  last_margin_ = found.usable() ? found.margin : wider.path.margin;
  const bool has_old = plan_is_current && !lost_.active() && plan_fits_map();
  plan_is_current = true;
  if (found.usable()) {
    path_length_ = found.path.length();
    lost_.reset();
    tried_.clear();
    const bool whole = found.whole && made->goal.position == task.task()->goal.position;
    use(std::move(found), whole);
  } else if (!has_old) {
    no_path(*made);
  }
}

// Interprets the navigator's result with respect to the task.
NavigationStep MaplessNavigator::State::judged(const NavigationStep& step) {
  const CorridorFollower& corridor = navigator.corridor();
  const bool turning = turns();
  const bool driven_on = plan_is_current && !turning && corridor.reference_path().count > 0;
  NavigationStep answer =
      task.judge(step, {.time = input.time,
                        .plan_is_current = plan_is_current,
                        .leads_to_goal = leads_to_goal_,
                        .new_path = follows_new_plan,
                        .remaining = driven_on ? std::optional(corridor.remaining()) : std::nullopt,
                        .turn = driven_on ? turn_left(navigator, input.pose) : 0.0,
                        .patience = settings.navigation.patience});
  if (turning && answer.status == NavigationStatus::Ok)
    answer.status = NavigationStatus::Recovering;
  // An unusable plan is kept, because it explains why there is none.
  if (answer.status == NavigationStatus::GaveUp && navigator.plan().usable()) navigator.cancel();
  if (scan_refused_ && answer.limit == LimitingFactor::StaleMap)
    answer.limit = LimitingFactor::InvalidScan;
  return answer;
}

NavigationStep MaplessNavigator::State::update(const Measurements& given) {
  Measurements m = given;
  if (is_plausible(m.pose)) m.pose = perception.corrected(m.pose);
  return cycle(m);
}

NavigationStep MaplessNavigator::State::cycle(const Measurements& m) {
  planned = false;
  follows_new_plan = false;
  const bool resumed = planning->resume();
  take_plan();
  std::erase_if(ending_, [](const auto& older) { return !older->runs(); });
  const bool pose_known = is_plausible(m.pose) && std::isfinite(m.time);
  if (pose_known) act_without_path(m);
  if (resumed) {
    // A new plan or a refreshed map would be too much for the same cycle.
  } else if (rolled_) {
    // The whole map has changed, which without a thread is enough work for one cycle.
    planning->refresh(perception.grid().occupied());
    rolled_ = false;
  } else if (pose_known && std::isfinite(perception.time()) &&
             needs_plan(m.time, m.pose.position)) {
    start_plan(m.time, m.pose);
    if (!settings.planning.background) take_plan();
  }
  return drive(m, task.task() && !plan_is_current && planning->busy());
}

NavigationStep MaplessNavigator::State::replay(const NavigationInput& recorded,
                                               std::optional<Plan> plan) {
  const Measurements m{
      .time = recorded.time, .pose = recorded.pose, .pose_time = recorded.pose_time};
  hold = recorded.hold;
  if (!settings.planning.background) return cycle(m);
  follows_new_plan = plan.has_value();
  rolled_ = false;
  if (plan) {
    plan_is_current = true;
    leads_to_goal_ = task.task() && plan->usable() && plan->whole &&
                     plan->goal.position == task.task()->goal.position;
    navigator.follow(*std::move(plan));
  }
  return drive(m, recorded.planning);
}

NavigationStep MaplessNavigator::State::drive(const Measurements& m, bool planning_now) {
  input = input_of(m);
  input.map = &perception.grid().not_seen_free();
  input.map_time = perception.time();
  input.hold = hold;
  input.planning = planning_now;
  merge_tracked(perception, moving_, input);
  const NavigationStep driven = navigator.update(input);
  plan_done_ = driven.status == NavigationStatus::GoalReached;
  turn_refused_ = driven.status == NavigationStatus::Blocked;
  const NavigationStep step = judged(driven);
  asked_for_plan_ = step.wants_plan;
  sent = step.command;
  return step;
}

}  // namespace fairway
