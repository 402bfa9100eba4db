// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/mapless_navigator.hpp"

#include <utility>

#include "fairway/navigation/explanation/step_explanation.hpp"
#include "fairway/navigation/facade/mapless_navigator_state.hpp"

namespace fairway {

MaplessNavigator::MaplessNavigator(const Settings& settings, const Eigen::Vector2d& position)
    : state_(std::make_unique<State>(settings, nullptr, position)) {}

MaplessNavigator::MaplessNavigator(const Settings& settings,
                                   ControlSolver& solver,
                                   const Eigen::Vector2d& position)
    : state_(std::make_unique<State>(settings, &solver, position)) {}

MaplessNavigator::MaplessNavigator(MaplessNavigator&&) noexcept = default;
MaplessNavigator& MaplessNavigator::operator=(MaplessNavigator&&) noexcept = default;
MaplessNavigator::~MaplessNavigator() = default;

bool MaplessNavigator::observe(const LidarScan& scan, const Eigen::Vector2d& position) {
  return state_->observe(scan, position);
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
  state_->task.end();
  state_->navigator.cancel();
}

void MaplessNavigator::set_zones(const Zones& zones) { state_->set_zones(zones); }
void MaplessNavigator::hold() noexcept { state_->hold = true; }
void MaplessNavigator::resume() noexcept { state_->hold = false; }
bool MaplessNavigator::on_hold() const noexcept { return state_->hold; }

void MaplessNavigator::reset(const Twist2& actual) noexcept { state_->navigator.reset(actual); }

void MaplessNavigator::replace_last(const Twist2& sent) noexcept {
  state_->navigator.replace_last(sent);
  state_->sent = sent;
}

void MaplessNavigator::set_settings(const Settings& settings) {
  auto next = std::make_unique<State>(settings, state_->solver, state_->input.pose.position);
  next->continue_from(*state_);
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

NavigationStep MaplessNavigator::replay(const NavigationInput& recorded, std::optional<Plan> plan) {
  return state_->replay(recorded, std::move(plan));
}

const Settings& MaplessNavigator::settings() const noexcept { return state_->settings; }
const Plan& MaplessNavigator::plan() const noexcept { return state_->navigator.plan(); }
bool MaplessNavigator::plan_is_current() const noexcept { return state_->plan_is_current; }
bool MaplessNavigator::planned() const noexcept { return state_->planned; }
bool MaplessNavigator::follows_new_plan() const noexcept { return state_->follows_new_plan; }
Pose2 MaplessNavigator::corrected(const Pose2& odometry) const noexcept {
  return state_->perception.corrected(odometry);
}
std::optional<Eigen::Matrix3d> MaplessNavigator::pose_covariance() const noexcept {
  const PoseCertainty* const certainty = state_->perception.certainty();
  return certainty != nullptr ? std::optional(certainty->covariance) : std::nullopt;
}
MovingObstacles MaplessNavigator::tracked() const noexcept {
  return state_->perception.tracker().obstacles();
}
void MaplessNavigator::wait_for_plan() const noexcept { state_->planning->wait(); }
const Navigator& MaplessNavigator::navigator() const noexcept { return state_->navigator; }
const Perception& MaplessNavigator::perception() const noexcept { return state_->perception; }
const NavigationInput& MaplessNavigator::input() const noexcept { return state_->input; }

std::string MaplessNavigator::explanation() const {
  if (!state_->task.can_be_done()) return {};
  const PreparedMap map(state_->perception.grid().occupied());
  const Eigen::Vector2d& here = state_->input.pose.position;
  const Plan plan =
      Planner().plan(map, here, state_->task.task()->goal, planner_settings(state_->settings));
  if (plan.usable() || plan.path_status == PathStatus::GoalOutsideMap) return {};
  return fairway::explain(map, here, plan, state_->settings.robot.radius);
}

StepExplanation MaplessNavigator::explain(const NavigationStep& step, double speed) const {
  if (step.limit == LimitingFactor::NoPath && state_->plan_is_current && !plan().usable())
    return {.kind = StepExplanation::Kind::Path, .text = plan().reason()};
  return explain_step(state_->navigator, step, state_->input, speed);
}

}  // namespace fairway
