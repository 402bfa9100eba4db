// SPDX-License-Identifier: Apache-2.0
#include "bridge/pilot.hpp"

#include <cmath>
#include <limits>

#include "fairway/base/contract.hpp"

namespace fairway::bridge {

namespace {

constexpr double kProgress = 0.05;  // [m] nearer to the goal count as getting on
constexpr int kLastZeros = 5;       // commands: a base that misses one must not coast
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_zero(const Twist2& twist) noexcept { return twist.linear == 0.0 && twist.angular == 0.0; }

}  // namespace

Expected<void> validate(const PilotOptions& options) {
  if (!options.use_map && !options.use_scan) {
    return fail("use_map, use_scan: expected one of them true, found both false");
  }
  if (!(options.patience > 0.0)) {
    return fail("patience: expected a positive number, found " + std::to_string(options.patience));
  }
  if (!(options.localisation_timeout > 0.0)) {
    return fail("localisation_timeout: expected a positive number, found " +
                std::to_string(options.localisation_timeout));
  }
  return {};
}

Pilot::Pilot(const Settings& settings, const PilotOptions& options)
    : settings_(settings),
      options_(options) {
  if (options_.use_map) make_guide();
}

void Pilot::make_guide() {
  plans_seen_ = 0;
  if (options_.use_map) {
    guide_ = make_map_guide(settings_, options_);
    if (map_) guide_->set_map(*map_);
  } else if (!odometry_.empty() && is_finite(odometry_.pose())) {
    guide_ = make_mapless_guide(settings_, options_.max_beams, odometry_.pose().position);
  }
}

void Pilot::set_settings(const Settings& settings) {
  settings_ = settings;
  if (!guide_) return;
  make_guide();
  guide_->reset(sent_);
  if (goal_) guide_->set_goal(*goal_);
}

void Pilot::set_map(const OccupancyGrid& map) {
  map_ = map;
  if (guide_) guide_->set_map(map);
}

void Pilot::add_odometry(double time, const Pose2& pose, const Twist2& twist) {
  odometry_.add(time, pose, twist);
  if (!guide_) make_guide();
}

void Pilot::set_localisation(const Pose2& odometry_in_map, double time) {
  localisation_ = odometry_in_map;
  localisation_time_ = time;
}

Pose2 Pilot::in_world(const Pose2& pose) const {
  return options_.use_map ? compose(*localisation_, pose) : pose;
}

std::optional<Pose2> Pilot::pose() const {
  if (odometry_.empty() || (options_.use_map && !localisation_)) return std::nullopt;
  return in_world(odometry_.pose());
}

bool Pilot::add_scan(LidarScan scan, double duration, const Pose2& sensor_on_robot) {
  if (!guide_ || !options_.use_scan || (options_.use_map && !localisation_)) return false;
  const std::optional<Pose2> first = odometry_.at(scan.time - duration);
  const std::optional<Pose2> last = odometry_.at(scan.time);
  if (!first || !last) return false;
  scan.first_pose = in_world(compose(*first, sensor_on_robot));
  scan.last_pose = in_world(compose(*last, sensor_on_robot));
  guide_->observe(scan, in_world(*last).position);
  return true;
}

void Pilot::set_goal(const Goal& goal) {
  FAIRWAY_EXPECTS(is_finite(goal.position));
  goal_ = goal;
  fresh_goal_ = true;
  least_remaining_ = kInfinity;
}

void Pilot::cancel() {
  goal_.reset();
  fresh_goal_ = false;
  if (state_ == PilotState::Idle) return;
  state_ = PilotState::Stopping;
  zeros_left_ = kLastZeros;
  if (guide_) guide_->cancel();
}

std::optional<SharedMotion> Pilot::share(std::uint32_t robot, double time) const {
  const std::optional<Pose2> now = pose();
  if (!options_.use_map || !now) return std::nullopt;
  return guide_->navigator().share(robot, time, *now);
}

PilotStep Pilot::cycle(double time) {
  PilotStep answer;
  if (fresh_goal_) {
    state_ = PilotState::Driving;
    fresh_goal_ = false;
    progress_time_ = time;
    if (guide_) guide_->set_goal(*goal_);
  }
  if (state_ == PilotState::Idle) {
    // Others may drive it meanwhile: a drive begins with what it does, and the fleet is told so.
    if (guide_ && !odometry_.empty()) guide_->reset(odometry_.twist());
    return answer;
  }

  GuideInput input{.time = time, .pose = {}, .pose_time = -kInfinity, .board = board_};
  if (const std::optional<Pose2> now = pose()) {
    input.pose = *now;
    if (options_.use_map) input.fleet = fleet_.around(now->position, time);
    const bool lost = options_.use_map && time - localisation_time_ > options_.localisation_timeout;
    if (!lost) input.pose_time = odometry_.time();
  }
  NavigationStep step{.status = NavigationStatus::Stale, .limit = LimitingFactor::StalePose};
  if (guide_) step = guide_->update(input);

  answer.send = true;
  answer.command = step.command;
  answer.status = step.status;
  answer.limit = step.limit;
  answer.rectangle = step.rectangle;
  answer.plan = step.plan;
  answer.pose_time = input.pose_time;
  if (guide_) {
    answer.new_plan = guide_->plans_made() != plans_seen_;
    plans_seen_ = guide_->plans_made();
  }
  sent_ = step.command;
  if (state_ == PilotState::Driving) {
    watch_progress(time, step, answer);
  } else if (is_zero(step.command) && --zeros_left_ <= 0) {
    state_ = PilotState::Idle;
  }
  return answer;
}

void Pilot::watch_progress(double time, const NavigationStep& step, PilotStep& answer) {
  const bool current = guide_ && guide_->plan_is_current();
  if (current && step.status == NavigationStatus::GoalReached) {
    answer.end = GoalEnd::Reached;
    cancel();
    return;
  }
  if (step.status == NavigationStatus::GoalReached) answer.status = NavigationStatus::NoPlan;
  // The string has points once the robot was found in the corridor.
  if (current && guide_->navigator().corridor().reference_path().count > 0) {
    const double remaining = guide_->navigator().corridor().remaining();
    if (answer.new_plan) least_remaining_ = remaining;
    if (remaining < least_remaining_ - kProgress) {
      least_remaining_ = remaining;
      progress_time_ = time;
    }
  }
  if (time - progress_time_ < options_.patience) return;
  answer.end = GoalEnd::GivenUp;
  answer.reason = reason_of(step);
  cancel();
}

std::string Pilot::reason_of(const NavigationStep& step) const {
  std::string text = to_text(step.status);
  if (step.limit != LimitingFactor::None) text += std::string(": ") + to_text(step.limit);
  const bool planned = guide_ && guide_->plans_made() > 0;
  if (planned && !guide_->navigator().plan().usable()) {
    text += std::string(": ") + guide_->navigator().plan().reason();
  }
  return text;
}

}  // namespace fairway::bridge
