// SPDX-License-Identifier: Apache-2.0
#include "bridge/pilot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bridge/path_strips.hpp"
#include "fairway/base/contract.hpp"
#include "fairway/trajectory/trajectory.hpp"

namespace fairway::bridge {

namespace {

constexpr int kLastZeros = 5;  // number of final commands: a base that misses one must not coast

bool is_zero(const NavigationStep& step) noexcept {
  return step.command.linear == 0.0 && step.command.angular == 0.0 && step.lateral == 0.0;
}

}  // namespace

Pilot::Pilot(const Settings& settings, const PilotOptions& options)
    : settings_(settings),
      options_(options),
      senses_({.use_map = options.use_map,
               .use_scan = options.use_scan,
               .localisation_timeout = options.localisation_timeout,
               .robot = options.robot}) {
  if (options_.use_map) make_navigator();
  make_guard();
}

void Pilot::make_guard() {
  guard_.reset();
  if (!options_.use_monitor || !options_.use_scan) return;
  // The monitor brakes like a base that turns freely; others need the stop along their drive.
  if (options_.body && options_.body->base.kind != BaseKind::Unicycle) return;
  MonitorSettings monitor =
      options_.body ? monitor_settings(settings_, *options_.body) : monitor_settings(settings_);
  monitor.stop_zone = options_.monitor_stop_zone;
  monitor.slow_zone = options_.monitor_slow_zone;
  monitor.slow_speed = options_.monitor_slow_speed;
  guard_.emplace(monitor);
}

Settings Pilot::with_options(const Settings& settings) const {
  Settings own = settings;
  own.planning.background = options_.plan_in_background;
  own.navigation.patience = options_.patience;
  own.perception.max_beams = static_cast<int>(options_.max_beams);
  return own;
}

void Pilot::make_navigator() {
  if (options_.body) {
    navigator_.emplace(BodyNavigator(with_options(settings_), *options_.body));
    if (map_ && options_.use_map) navigator_->set_map(*map_);
  } else if (options_.use_map) {
    navigator_.emplace(MapNavigator(with_options(settings_)));
    if (map_) navigator_->set_map(*map_);
  } else if (!odometry().empty() && is_plausible(odometry().pose())) {
    navigator_.emplace(MaplessNavigator(with_options(settings_), odometry().pose().position));
  }
  if (navigator_ && !options_.zones.empty()) navigator_->set_zones(options_.zones);
}

void Pilot::set_settings(const Settings& settings) {
  settings_ = settings;
  make_guard();
  if (!navigator_) return;
  navigator_->set_settings(with_options(settings));
}

// A steered wheel is where the motion of the base shows it, and at standstill where it was sent.
void Pilot::reset_navigator(const PlanarTwist& actual) {
  if (options_.body) steering_ = steering_of(options_.body->base, actual, steering_);
  navigator_->reset(actual, steering_);
}

void Pilot::set_map(const OccupancyGrid& map) {
  map_ = map;
  if (navigator_) navigator_->set_map(map);
}

void Pilot::add_odometry(double time, const Pose2& pose, const PlanarTwist& twist) {
  senses_.add_odometry(time, pose, twist);
  if (!navigator_) make_navigator();
}

bool Pilot::add_scan(LidarScan scan, double duration, const Pose2& sensor_on_robot) {
  if (!navigator_) return false;
  const std::optional<PlacedScan> placed = senses_.place(scan, duration, sensor_on_robot);
  if (!placed) return false;
  if (guard_) guard_->observe(placed->in_odometry, sensor_on_robot);
  if (options_.use_map && !map_) return true;  // there is nothing to add it to
  const bool taken = navigator_->observe(placed->in_world, placed->position);
  if (taken) senses_.note_scan();
  return taken;
}

void Pilot::set_goal(const Goal& goal) {
  goal_ = goal;
  path_ = {};
  poses_ = {};
  set_strips({});
  fresh_goal_ = true;
}

void Pilot::follow(Path path, const std::optional<double>& goal_heading, double bound) {
  FAIRWAY_EXPECTS(!path.waypoints.empty());
  if (options_.body) {
    PosePath poses;
    for (const Eigen::Vector2d& waypoint : path.waypoints)
      poses.poses.push_back({.position = waypoint, .heading = {}});
    poses.poses.back().heading = goal_heading;
    if (bound > 0.0 && !has_own_strips()) poses.max_deviation = bound;
    follow(std::move(poses));
    return;
  }
  goal_ = Goal{.position = path.waypoints.back(), .heading = goal_heading};
  path_ = std::move(path);
  set_strips(bound > 0.0 ? strips_along(path_, bound) : Zones{});
  fresh_goal_ = true;
}

void Pilot::follow(PosePath path) {
  FAIRWAY_EXPECTS(options_.body && !path.poses.empty());
  goal_ = Goal{.position = path.poses.back().position, .heading = path.poses.back().heading};
  path_ = {};
  poses_ = std::move(path);
  fresh_goal_ = true;
}

bool Pilot::has_own_strips() const noexcept {
  return std::any_of(options_.zones.begin(), options_.zones.end(),
                     [](const Zone& zone) { return zone.kind == ZoneKind::Strip; });
}

// Several strips count as their union, so that those of the path would weaken those of the options.
void Pilot::set_strips(Zones strips) {
  if (has_own_strips() || (strips.empty() && strips_.empty())) return;
  strips_ = std::move(strips);
  Zones zones = options_.zones;
  zones.insert(zones.end(), strips_.begin(), strips_.end());
  if (navigator_) navigator_->set_zones(zones);
}

void Pilot::cancel() {
  goal_.reset();
  path_ = {};
  poses_ = {};
  set_strips({});
  fresh_goal_ = false;
  if (state_ == PilotState::Idle) return;
  state_ = PilotState::Stopping;
  zeros_left_ = kLastZeros;
  if (navigator_) navigator_->cancel();
}

std::optional<SharedMotion> Pilot::share(double time) const {
  const std::optional<Pose2> now = pose();
  if (!options_.use_map || !now || !navigator_) return std::nullopt;
  return navigator_->share(options_.robot, time, *now);
}

void Pilot::begin_goal() {
  waits_since_.reset();
  if (!navigator_) return;
  if (!poses_.poses.empty()) {
    navigator_->follow(poses_);
  } else if (!path_.waypoints.empty()) {
    navigator_->follow(path_, goal_->heading);
  } else {
    navigator_->set_goal(*goal_);
  }
}

PilotStep Pilot::cycle(double time) {
  PilotStep answer;
  if (fresh_goal_) {
    state_ = PilotState::Driving;
    fresh_goal_ = false;
    begin_goal();
  }
  if (state_ == PilotState::Idle) {
    // Other programs may drive the robot now, so a drive starts with its actual twist, which the
    // fleet also receives.
    if (guard_) guard_->reset();
    if (!odometry().empty()) sent_ = senses_.twist();
    if (navigator_ && !odometry().empty()) reset_navigator(sent_);
    return answer;
  }

  const Measurements measured = senses_.measure(time);
  NavigationStep step{.status = NavigationStatus::Stale, .limit = LimitingFactor::StalePose};
  if (navigator_) step = navigator_->update(measured);

  answer.send = true;
  answer.command = step.command;
  answer.lateral = step.lateral;
  answer.steering = step.steering;
  answer.status = step.status;
  answer.limit = step.limit;
  answer.rectangle = step.rectangle;
  answer.plan = step.plan;
  answer.pose_time = *measured.pose_time;
  answer.new_plan = navigator_ && navigator_->follows_new_plan();
  has_planned_ = has_planned_ || answer.new_plan;
  guard(time, answer);
  sent_ = {.linear = answer.command.linear,
           .lateral = answer.lateral,
           .angular = answer.command.angular};
  if (options_.body) steering_ = answer.steering;
  if (state_ == PilotState::Driving) {
    explain(time, step, answer);
    judge(time, step, answer);
  } else if (is_zero(step) && --zeros_left_ <= 0) {
    state_ = PilotState::Idle;
  }
  return answer;
}

// The last check of a command. The navigator goes on from what was really sent.
void Pilot::guard(double time, PilotStep& answer) {
  if (!guard_ || odometry().empty()) return;
  const Pose2 pose = odometry().at(time).value_or(odometry().pose());
  const Twist2 last{.linear = sent_.linear, .angular = sent_.angular};
  const MonitorVerdict verdict = guard_->check(time, pose, last, answer.command);
  answer.monitor = verdict.reason;
  if (verdict.reason == MonitorReason::None) return;
  answer.command = verdict.command;
  if (navigator_)
    navigator_->replace_last({.linear = verdict.command.linear, .angular = verdict.command.angular},
                             steering_);
}

void Pilot::explain(double time, const NavigationStep& step, PilotStep& answer) {
  constexpr double kPeriod = 1.0;  // [s]
  if (!navigator_ || !is_zero(step) || step.status == NavigationStatus::GoalReached) {
    explanation_.clear();
    return;
  }
  if (explanation_.empty() || std::abs(time - explained_at_) >= kPeriod) {
    explanation_ = navigator_->explain(step, senses_.twist().linear);
    explained_at_ = time;
  }
  answer.explanation = explanation_;
}

// A BodyNavigator does not give up itself.
bool Pilot::waits_too_long(double time, const NavigationStep& step) noexcept {
  if (!options_.body || !is_zero(step) || step.status == NavigationStatus::Holding) {
    waits_since_.reset();
    return false;
  }
  if (!waits_since_) waits_since_ = time;
  return std::abs(time - *waits_since_) >= options_.patience;
}

// Decides whether the drive has ended, and how.
void Pilot::judge(double time, const NavigationStep& step, PilotStep& answer) {
  if (step.status == NavigationStatus::GoalReached) {
    answer.end = GoalEnd::Reached;
    cancel();
  } else if (waits_too_long(time, step) || step.status == NavigationStatus::GaveUp) {
    answer.end = GoalEnd::GivenUp;
    answer.reason = reason_of(step);
    if (has_planned_ && !navigator_->plan().usable()) {
      const PathStatus path = navigator_->plan().path_status;
      answer.path = path == PathStatus::Found ? PathStatus::NoConnection : path;
    }
    cancel();
  }
}

std::string Pilot::reason_of(const NavigationStep& step) const {
  std::string text = to_text(step.status);
  if (step.limit != LimitingFactor::None) text += std::string(": ") + to_text(step.limit);
  if (has_planned_ && !navigator_->plan().usable()) {
    text += ": " + navigator_->why_no_plan();
  }
  return text;
}

}  // namespace fairway::bridge
