// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "nav2_fairway_controller/following/stop_reason.hpp"

namespace fairway::nav2 {

namespace {

// A part of the path that is missed by more than kSkipped [m] counts as skipped. A strip with the
// bound kSoftBound [m] prevents that, at a right-angled corner too.
constexpr double kSkipped = 0.25;
constexpr double kSoftBound = 0.2;

PieceLimits limits_of(const FollowerSettings& settings) noexcept {
  // Strips that touch would be one: parts of a piece must be further apart.
  constexpr double kCells = 0.1;  // [m]
  constexpr double kMore = 2.5;   // [m] beyond what the horizon reaches
  const MpcSettings& mpc = settings.robot.mpc;
  const double reach = mpc.horizon * mpc.step_length * settings.robot.robot.linear_max;
  const double bound = std::max(kSoftBound, settings.following.max_deviation);
  return {.radius = settings.robot.robot.radius,
          .margin = settings.robot.path.margin,
          .longest = reach + kMore,
          .apart = 2.0 * (settings.robot.robot.radius + bound) + kCells};
}

bool is_zero(const Twist2& twist) noexcept { return twist.linear == 0.0 && twist.angular == 0.0; }

}  // namespace

PathFollower::PathFollower(const FollowerSettings& settings)
    : settings_(settings),
      navigator_(settings.robot) {}

void PathFollower::drop_path() {
  navigator_.cancel();
  progress_ = {};
  piece_.reset();
  strip_ = {};
  blocked_.clear();
  progress_time_.reset();
  approaches_ = false;
}

void PathFollower::apply(FollowerChanges changes) {
  if (changes.reset) {
    drop_path();
    starts_ = true;
  }
  if (changes.settings) {
    settings_ = *changes.settings;
    settings_changed_ = true;
    piece_.reset();
  }
  if (changes.limit) limit_ = *changes.limit;
  if (changes.cancel) drop_path();
  if (!changes.path) return;
  PathTask& task = *changes.path;
  const bool same = task.path.waypoints == progress_.path().waypoints &&
                    task.goal_heading == goal_heading_ && !progress_.empty();
  if (same && progress_.arc() < progress_.length()) return;
  if (task.path.waypoints.empty()) {
    drop_path();
    return;
  }
  progress_ = PathProgress(std::move(task.path));
  goal_heading_ = task.goal_heading;
  is_new_ = true;
  piece_.reset();
  blocked_.clear();
  progress_time_.reset();
  approaches_ = false;
}

// Gives the navigator its settings with the limits of this cycle, if they have changed.
void PathFollower::update_limits(const FollowerInput& input) {
  LimitedSettings now = limited(settings_.robot, limit_);
  holds_ = now.holds;
  limit_fault_ = std::move(now.fault);
  if (input.goal && !progress_.empty()) {
    narrow_tolerances(*input.goal, now.settings.navigation);
    const Eigen::Vector2d goal = transform(frame_, progress_.at(progress_.length()));
    const auto slow = approach_speed(now.settings, *input.goal, (goal - input.pose.position).norm(),
                                     input.twist.linear);
    approaches_ = slow && (approaches_ || (piece_ && piece_->complete()));
    if (approaches_) limit_speed(*slow, now.settings.robot);
  }
  const Settings& present = navigator_.settings();
  const bool same =
      now.settings.robot.linear_max == present.robot.linear_max &&
      now.settings.navigation.goal_tolerance == present.navigation.goal_tolerance &&
      now.settings.navigation.heading_tolerance == present.navigation.heading_tolerance;
  if (same && !settings_changed_) return;
  navigator_.set_settings(now.settings);
  settings_changed_ = false;
}

// Returns whether the path's frame is known. For a short time the last one is used.
bool PathFollower::update_frame(const FollowerInput& input) {
  constexpr double kOldest = 1.0;  // [s]
  if (input.path_frame && is_finite(*input.path_frame)) {
    frame_ = *input.path_frame;
    frame_time_ = input.time;
  }
  return frame_time_ && std::abs(input.time - *frame_time_) <= kOldest;
}

bool PathFollower::needs_piece(double time) const noexcept {
  constexpr double kMoved = 0.02;  // [m] of the path's frame since the piece was chosen
  if (!piece_) return true;
  const auto moved = [&](double arc) {
    const Eigen::Vector2d point = progress_.at(arc);
    return (transform(frame_, point) - transform(piece_frame_, point)).norm() > kMoved;
  };
  if (moved(piece_->from) || moved(piece_->to)) return true;
  if (piece_->complete() && !piece_failed_) return false;
  return std::abs(time - piece_time_) >= settings_.robot.planning.retry_period;
}

void PathFollower::set_map(const FollowerInput& input) {
  map_is_set_ = true;
  if (strip_.waypoints.empty()) {
    navigator_.set_map(input.obstacles);
    return;
  }
  // Where the robot is outside the strip, it needs space to return and to stop.
  const RobotSettings& robot = settings_.robot.robot;
  constexpr double kLeast = 0.05;  // [m]
  const double loose =
      settings_.following.max_deviation > 0.0 ? kLeast : braking_distance(robot) + kLeast;
  map_ = strip_around(strip_, input.obstacles, robot.radius, strip_bound_, std::max(loose, kLeast));
  navigator_.set_map(map_);
}

// Gives a piece to the navigator. Returns whether a plan for it is usable, or is being made.
bool PathFollower::follow(const PathPiece& piece,
                          double bound,
                          const FollowerInput& input,
                          const Measurements& measurements) {
  Path path = piece_path(progress_, piece, frame_, input.pose.position);
  strip_ = bound > 0.0 ? path : Path{};
  strip_bound_ = bound;
  set_map(input);
  std::optional<double> heading;
  if (piece.complete() && goal_heading_) {
    heading = std::remainder(*goal_heading_ + frame_.heading, 2.0 * std::numbers::pi);
  }
  navigator_.follow(std::move(path), heading);
  piece_ = piece;
  piece_frame_ = frame_;
  piece_time_ = input.time;
  if (settings_.robot.planning.background) return true;
  static_cast<void>(navigator_.plan_now(measurements));
  return navigator_.plan().usable() || !navigator_.plan_is_current();
}

// Tries pieces that end at different places until there is a plan for one.
void PathFollower::try_pieces(const FollowerInput& input, const Measurements& measurements) {
  PieceLimits limits = limits_of(settings_);
  const double hard = settings_.following.max_deviation;
  piece_failed_ = false;
  for (const double shorten : {1.0, 0.6, 0.3}) {
    limits.shorten = shorten;
    const PathPiece piece = choose_piece(progress_, frame_, input.obstacles, limits);
    constexpr double kLeastLength = 0.03;  // [m]
    if (!piece.complete() && piece.length() < kLeastLength) {
      if (shorten < 1.0) break;
      navigator_.cancel();
      piece_.reset();
      strip_ = {};
      blocked_ = why_no_piece(progress_, piece, frame_, input.obstacles, limits);
      blocked_fault_ =
          piece.end == PieceEnd::OutsideMap ? FollowerFault::BadPath : FollowerFault::NoControl;
      return;
    }
    blocked_.clear();
    // A longer piece replaces the present one only if that is worth a new plan.
    constexpr double kLonger = 0.25;  // [m]
    const bool moved = piece_ && (piece_frame_.position != frame_.position ||
                                  piece_frame_.heading != frame_.heading);
    if (piece_ && !moved && navigator_.plan().usable() && shorten == 1.0 && !piece.complete() &&
        std::abs(piece.to - piece_->to) < kLonger && piece.end == piece_->end) {
      piece_time_ = input.time;
      return;
    }
    const Path path = piece_path(progress_, piece, frame_, input.pose.position);
    const double soft =
        has_shortcut(path, input.obstacles, limits.radius, kSkipped) ? kSoftBound : 0.0;
    if (follow(piece, hard > 0.0 ? hard : soft, input, measurements)) return;
    if (hard <= 0.0 && soft > 0.0 && follow(piece, 0.0, input, measurements)) return;
  }
  piece_failed_ = true;
}

void PathFollower::update_piece(const FollowerInput& input, const Measurements& measurements) {
  const Eigen::Vector2d position = inverse_transform(frame_, input.pose.position);
  constexpr double kAhead = 1.5;  // [m] that is searched, for jumps of the path's frame
  if (std::exchange(is_new_, false)) {
    progress_.start(position);
    best_ = progress_.arc();
  } else {
    const double ahead = progress_.arc() + kAhead;
    progress_.advance(position, piece_ ? std::min(piece_->to, ahead) : ahead);
  }
  if (needs_piece(input.time)) try_pieces(input, measurements);
}

FollowerStep PathFollower::judged(const NavigationStep& step, const FollowerInput& input) {
  constexpr double kProgress = 0.05;  // [m]; less is noise of the pose
  FollowerStep answer{.command = step.command,
                      .status = step.status,
                      .limit = step.limit,
                      .rectangle = step.rectangle,
                      .reason = {}};
  if (!progress_.empty()) {
    answer.driven = progress_.arc();
    answer.remaining = progress_.length() - progress_.arc();
    answer.deviation = progress_.deviation();
  }
  if (!progress_time_ || progress_.arc() > best_ + kProgress || input.time < *progress_time_) {
    best_ = progress_.arc();
    progress_time_ = input.time;
  }
  if (step.status == NavigationStatus::GoalReached && piece_) {
    progress_.reached(piece_->to);
    if (piece_->complete()) {
      answer.remaining = 0.0;
    } else {  // the end of a piece is no goal of Nav2
      answer.status = NavigationStatus::Ok;
      piece_.reset();
    }
  }
  if (!is_zero(step.command) || progress_.empty()) return answer;
  const double stalled = input.time - *progress_time_;
  const bool reached = answer.status == NavigationStatus::GoalReached;
  const bool waits = answer.status == NavigationStatus::Ok ||
                     answer.status == NavigationStatus::Degraded ||
                     answer.status == NavigationStatus::Recovering ||
                     answer.status == NavigationStatus::Planning || reached || holds_;
  if (!reached) answer.reason = reason_of(step);
  if (waits && stalled < settings_.following.patience) return answer;
  if (reached) {
    answer.reason =
        "the robot has reached the goal within navigation.goal_tolerance and "
        ".heading_tolerance, but the goal checker does not accept it";
  }
  answer.fault = blocked_.empty() ? FollowerFault::NoControl : blocked_fault_;
  return answer;
}

std::string PathFollower::reason_of(const NavigationStep& step) const {
  if (holds_) return limit_fault_;
  if (!blocked_.empty()) return blocked_;
  std::string text = why_standing(step, navigator_.plan(), progress_, piece_);
  const StepExplanation why = navigator_.explain(step, 0.0);
  const bool says_more = why.kind == StepExplanation::Kind::MovingObstacle ||
                         why.kind == StepExplanation::Kind::Stop ||
                         why.kind == StepExplanation::Kind::Input;
  return says_more ? text + "; " + why.text : text;
}

FollowerStep PathFollower::update(const FollowerInput& input) {
  apply(mailbox_.take());
  if (starts_) navigator_.reset(input.twist);
  starts_ = false;
  const bool has_frame = update_frame(input);
  update_limits(input);
  const bridge::SeenObstacles moving = input.moving.collect(input.time);
  const Measurements measurements{.time = input.time,
                                  .pose = input.pose,
                                  .pose_time = input.pose_time,
                                  .obstacles = moving.obstacles,
                                  .obstacles_time = moving.time,
                                  .obstacles_due = input.moving.has_detectors(),
                                  .map_time = input.obstacles_time};
  const bool follows = !progress_.empty() && has_frame && !holds_ && is_finite(input.pose);
  if (!progress_.empty() && (!has_frame || holds_) && piece_) {
    navigator_.cancel();
    piece_.reset();
    strip_ = {};
  }
  map_is_set_ = false;
  if (follows) update_piece(input, measurements);
  if (!map_is_set_) set_map(input);
  FollowerStep step = judged(navigator_.update(measurements), input);
  if (!progress_.empty() && !has_frame && is_zero(step.command)) {
    step.fault = FollowerFault::NoFrame;
    step.reason = "no transform from the frame of the path to the frame of the costmap";
  }
  return step;
}

}  // namespace fairway::nav2
