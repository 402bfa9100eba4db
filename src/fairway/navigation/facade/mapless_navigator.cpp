// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/mapless_navigator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "fairway/map/free_space.hpp"
#include "fairway/navigation/facade/local_planning.hpp"
#include "fairway/navigation/facade/navigation_task.hpp"
#include "fairway/navigation/facade/obstacle_merge.hpp"
#include "fairway/navigation/facade/progress_watch.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/tracking/corridor_check.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A cell of the map may turn out occupied although what is in it lies at its far side: wherever
// there is room, keep so much more that the robot still has its own room then.
Settings with_margins(const Settings& settings) {
  Settings wider = settings;
  wider.path.margin += settings.perception.resolution;
  wider.safety.stop_margin += 0.5 * settings.perception.resolution;
  return wider;
}

// How far the robot can get within a horizon [m].
double reach_of_horizon(const Settings& settings) noexcept {
  return settings.mpc.horizon * settings.mpc.step_length * settings.robot.linear_max;
}

}  // namespace

struct MaplessNavigator::State {
  State(const Settings& given, ControlSolver* solver, const Vector2d& position)
      : settings(given),
        solver_(solver),
        wider_(with_margins(given)),
        perception(given.perception, position),
        navigator(solver != nullptr ? Navigator(wider_, *solver) : Navigator(wider_)),
        planning(std::make_unique<LocalPlanning>(wider_, perception.grid().occupied())) {}

  void set_task(NavigationTask given);
  void observe(const LidarScan& scan, const Vector2d& position);
  [[nodiscard]] NavigationStep update(const Measurements& measurements);

  Settings settings;
  ControlSolver* solver_;

 private:
  Settings wider_;

 public:
  Perception perception;
  Navigator navigator;
  std::unique_ptr<LocalPlanning> planning;
  std::optional<NavigationTask> task;
  NavigationInput input;
  bool planned = false;           // in the last cycle
  bool follows_new_plan = false;  // likewise
  bool gave_up = false;
  bool plan_is_current = false;
  Twist2 sent;

 private:
  [[nodiscard]] bool needs_plan(double time) const noexcept;
  [[nodiscard]] bool path_is_free() const noexcept;
  void start_plan(double time, const Pose2& pose);
  void take_plan();
  [[nodiscard]] NavigationStep judged(NavigationStep step);

  std::vector<MovingObstacle> moving_;
  ProgressWatch progress_;
  int task_number_ = 0;
  int asked_number_ = 0;  // the task of the plan that was asked for last
  bool rolled_ = true;    // the window has moved since the map was refreshed
  bool asked_for_plan_ = true;
  bool leads_to_goal_ = false;    // the present corridor
  bool look_for_narrow_ = false;  // in the next plan: the present one goes a long way round
  double plan_time_ = 0.0;
  double last_margin_ = kInfinity;  // of the last usable plan [m]
  double way_length_ = kInfinity;   // likewise, of its path [m]
};

void MaplessNavigator::State::set_task(NavigationTask given) {
  task = std::move(given);
  ++task_number_;
  gave_up = false;
  plan_is_current = false;
  asked_for_plan_ = true;
  look_for_narrow_ = false;
  way_length_ = kInfinity;
  plan_time_ = -kInfinity;
  progress_.reset();
  if (!task->valid) navigator.cancel();
}

void MaplessNavigator::State::observe(const LidarScan& scan, const Vector2d& position) {
  perception.observe(scan, position, wider_.robot.radius);
  rolled_ = rolled_ || perception.grid().rolled();
  planning->note_change(perception.grid().changed());
}

// At once where the robot is about to drive into something new; else not more often than that pays.
bool MaplessNavigator::State::needs_plan(double time) const noexcept {
  constexpr double kRetryAfter = 0.25;  // [s]; without a way, or when a longer corridor is wanted
  constexpr double kSoon = 1.0;         // [m], beyond the braking distance
  if (!task || !task->valid || planning->busy()) return false;
  const CorridorFollower& corridor = navigator.corridor();
  const bool driven_on = navigator.plan().usable() && corridor.reference_path().count > 0;
  // A cell that flickers in and out at the side is no reason for another plan.
  const double flicker = 0.5 * wider_.perception.resolution;
  const auto is_free_for = [&](double length) {
    return corridor_is_free(perception.grid().occupied(), corridor, wider_.robot.radius, flicker,
                            length);
  };
  if (look_for_narrow_ || (driven_on && !is_free_for(braking_distance(wider_.robot) + kSoon)))
    return true;
  if (time - plan_time_ < kRetryAfter) return false;
  if (!driven_on || asked_for_plan_) return true;
  if (!leads_to_goal_ && corridor.remaining() < reach_of_horizon(wider_)) return true;
  return !is_free_for(kInfinity) || !path_is_free();
}

// Whether the path is still free beyond the corridor, so that a dead end is noticed from afar.
bool MaplessNavigator::State::path_is_free() const noexcept {
  const Plan& now = navigator.plan();
  if (now.whole) return true;
  const double clearance = std::max(0.0, wider_.robot.radius - 0.5 * wider_.perception.resolution);
  const std::vector<Vector2d>& points = now.path.waypoints;
  double covered = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    covered += (points[i] - points[i - 1]).norm();
    if (covered < LocalPlanning::corridor_length(wider_)) continue;
    if (!is_free(perception.grid().occupied(), points[i - 1], points[i], clearance)) return false;
  }
  return true;
}

void MaplessNavigator::State::start_plan(double time, const Pose2& pose) {
  constexpr double kNarrow = 0.05;  // share of the margin that is kept in the narrowest places
  planned = true;
  plan_time_ = time;
  asked_number_ = task_number_;
  const double wished = wider_.path.margin;
  const bool narrow = std::exchange(look_for_narrow_, false);
  planning->start(perception.grid().occupied(),
                  {.position = pose.position,
                   .goal = task->goal,
                   .along = task->along,
                   .margin = narrow ? kNarrow * wished : std::min(wished, 2.0 * last_margin_),
                   .narrow = narrow});
}

void MaplessNavigator::State::take_plan() {
  constexpr double kDetour = 1.0;       // [m]; a way that is so much longer than the last one was
  constexpr double kWorthNarrow = 0.7;  // of the wide way's length
  std::optional<LocalPlan> made = planning->take();
  if (!made || !task || asked_number_ != task_number_) return;
  Plan& found = made->plan;
  if (made->request.narrow) {
    if (!found.usable() || found.path.length() >= kWorthNarrow * way_length_) return;
  } else {
    // Before a long way round: is there none through a narrower place? That is the next cycle's
    // work; by then the robot will not have gone far.
    look_for_narrow_ = found.usable() && found.path.length() > way_length_ + kDetour;
  }
  last_margin_ = found.usable() ? found.margin : wider_.path.margin;
  plan_is_current = true;
  // An old plan is better than none while the map may be wrong about a narrow place: every command
  // is checked before it is sent.
  if (!found.usable() && navigator.plan().usable()) return;
  way_length_ = found.path.length();
  leads_to_goal_ = found.whole && made->goal.position == task->goal.position;
  follows_new_plan = true;
  navigator.follow(std::move(found));
}

NavigationStep MaplessNavigator::State::judged(NavigationStep step) {
  if (!task) {
    if (gave_up && step.status == NavigationStatus::NoPlan) step.status = NavigationStatus::GaveUp;
    return step;
  }
  if (!task->valid) {
    step.status = NavigationStatus::BadInput;
    step.limit = LimitingFactor::InvalidGoal;
    return step;
  }
  if (step.status == NavigationStatus::GoalReached && !leads_to_goal_) {
    // As near as it gets for now, but not there.
    step.status = NavigationStatus::Blocked;
    step.limit = LimitingFactor::NoPath;
    step.wants_plan = true;
  }
  if (step.status == NavigationStatus::GoalReached) return step;
  std::optional<double> remaining;
  if (navigator.corridor().reference_path().count > 0) remaining = navigator.corridor().remaining();
  const double stalled = progress_.update(input.time, remaining, follows_new_plan);
  if (settings.navigation.patience > 0.0 && stalled >= settings.navigation.patience) {
    task.reset();
    gave_up = true;
    if (navigator.plan().usable()) navigator.cancel();  // else the plan tells why there is none
    step.status = NavigationStatus::GaveUp;
  }
  return step;
}

NavigationStep MaplessNavigator::State::update(const Measurements& m) {
  planned = false;
  follows_new_plan = false;
  take_plan();
  const bool pose_known = is_finite(m.pose) && std::isfinite(m.time);
  if (rolled_) {
    // All of the map is new, which without a thread is enough work for one cycle.
    planning->refresh(perception.grid().occupied());
    rolled_ = false;
  } else if (pose_known && std::isfinite(perception.time()) && needs_plan(m.time)) {
    start_plan(m.time, m.pose);
    if (!settings.planning.background) take_plan();
  }
  input = input_of(m);
  input.map = &perception.grid().not_seen_free();
  input.map_time = perception.time();
  input.planning = task && !plan_is_current && planning->busy();
  merge_tracked(perception, moving_, input);
  const NavigationStep step = judged(navigator.update(input));
  asked_for_plan_ = step.wants_plan;
  sent = step.command;
  return step;
}

MaplessNavigator::MaplessNavigator(const Settings& settings, const Vector2d& position)
    : state_(std::make_unique<State>(settings, nullptr, position)) {}

MaplessNavigator::MaplessNavigator(const Settings& settings,
                                   ControlSolver& solver,
                                   const Vector2d& position)
    : state_(std::make_unique<State>(settings, &solver, position)) {}

MaplessNavigator::MaplessNavigator(MaplessNavigator&&) noexcept = default;
MaplessNavigator& MaplessNavigator::operator=(MaplessNavigator&&) noexcept = default;
MaplessNavigator::~MaplessNavigator() = default;

void MaplessNavigator::observe(const LidarScan& scan, const Vector2d& position) {
  state_->observe(scan, position);
}

void MaplessNavigator::set_goal(const Goal& goal) { state_->set_task(task_of(goal)); }

void MaplessNavigator::follow(Path path, const std::optional<double>& goal_heading) {
  if (path.waypoints.empty()) {
    cancel();
    return;
  }
  state_->set_task(task_of(std::move(path), goal_heading));
}

void MaplessNavigator::cancel() {
  state_->task.reset();
  state_->gave_up = false;
  state_->navigator.cancel();
}

void MaplessNavigator::reset(const Twist2& actual) noexcept { state_->navigator.reset(actual); }

void MaplessNavigator::set_settings(const Settings& settings) {
  auto next = std::make_unique<State>(settings, state_->solver_, state_->input.pose.position);
  next->navigator.reset(state_->sent);
  if (state_->task) next->set_task(*state_->task);
  state_ = std::move(next);
}

NavigationStep MaplessNavigator::update(const Measurements& measurements) {
  return state_->update(measurements);
}

SharedMotion MaplessNavigator::share(std::uint32_t robot,
                                     double time,
                                     const Pose2& pose) const noexcept {
  return state_->navigator.share(robot, time, pose);
}

const Settings& MaplessNavigator::settings() const noexcept { return state_->settings; }
const Plan& MaplessNavigator::plan() const noexcept { return state_->navigator.plan(); }
bool MaplessNavigator::plan_is_current() const noexcept { return state_->plan_is_current; }
bool MaplessNavigator::planned() const noexcept { return state_->planned; }
bool MaplessNavigator::follows_new_plan() const noexcept { return state_->follows_new_plan; }
MovingObstacles MaplessNavigator::tracked() const noexcept {
  return state_->perception.tracker().obstacles();
}
void MaplessNavigator::wait_for_plan() const noexcept { state_->planning->wait(); }
const Navigator& MaplessNavigator::navigator() const noexcept { return state_->navigator; }
const Perception& MaplessNavigator::perception() const noexcept { return state_->perception; }
const NavigationInput& MaplessNavigator::input() const noexcept { return state_->input; }

}  // namespace fairway
