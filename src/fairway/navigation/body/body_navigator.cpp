// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_navigator.hpp"

#include <stdexcept>
#include <utility>

#include "fairway/navigation/body/body_navigator_state.hpp"
#include "fairway/navigation/body/body_report.hpp"

namespace fairway {

namespace {

const RobotModel& checked_robot(const RobotModel& robot) {
  if (const Expected<void> valid = validate(robot.base); !valid)
    throw std::invalid_argument("robot." + valid.error().message);
  if (robot.body.parts().empty())
    throw std::invalid_argument("robot: expected a body, found a point");
  return robot;
}

BaseInput input_for(const BaseModel& base, const PlanarTwist& twist, double steering) noexcept {
  return {.linear = twist.linear,
          .lateral = twist.lateral,
          .turn = is_steered(base) ? steering : twist.angular};
}

}  // namespace

BodyNavigator::BodyNavigator(const Settings& settings, const RobotModel& robot)
    : state_(std::make_unique<State>(checked(settings), checked_robot(robot), nullptr)) {}

BodyNavigator::BodyNavigator(const Settings& settings,
                             const RobotModel& robot,
                             const OccupancyGrid& map)
    : BodyNavigator(settings, robot) {
  set_map(map);
}

BodyNavigator::BodyNavigator(const Settings& settings,
                             const RobotModel& robot,
                             const PreparedMap& map)
    : state_(std::make_unique<State>(checked(settings), checked_robot(robot), &map)) {}

BodyNavigator::BodyNavigator(BodyNavigator&&) noexcept = default;
BodyNavigator& BodyNavigator::operator=(BodyNavigator&&) noexcept = default;
BodyNavigator::~BodyNavigator() = default;

void BodyNavigator::set_map(const OccupancyGrid& map) { state_->around.set_map(map); }

void BodyNavigator::set_map(const BitGrid& map) { state_->around.set_map(map); }

void BodyNavigator::set_zones(const Zones& zones) {
  if (const Expected<void> valid = validate(zones); !valid)
    throw std::invalid_argument(valid.error().message);
  if (state_->around.shares_map())
    throw std::invalid_argument("set_zones: expected a navigator with a map of its own");
  state_->set_zones(zones);
}

void BodyNavigator::map_changed() { state_->around.note_map(); }

bool BodyNavigator::observe(const LidarScan& scan, const Eigen::Vector2d& position) {
  return state_->around.observe(scan, position);
}

void BodyNavigator::set_goal(const Goal& goal) { state_->set_goal(goal); }

void BodyNavigator::follow(const PosePath& path) { state_->follow(path); }

void BodyNavigator::follow(const Path& path, const std::optional<double>& goal_heading) {
  PosePath poses;
  for (const Eigen::Vector2d& waypoint : path.waypoints)
    poses.poses.push_back({.position = waypoint, .heading = {}});
  if (!poses.poses.empty()) poses.poses.back().heading = goal_heading;
  state_->follow(poses);
}

std::optional<PathPlace> BodyNavigator::place_on_path() const noexcept { return state_->place; }

const std::string& BodyNavigator::explanation() const noexcept { return state_->why; }

void BodyNavigator::cancel() noexcept { state_->cancel(); }

void BodyNavigator::reset(const PlanarTwist& actual, double steering) noexcept {
  state_->reset(input_for(state_->robot.base, actual, steering));
}

void BodyNavigator::replace_last(const PlanarTwist& sent, double steering) noexcept {
  state_->follower.replace_last(input_for(state_->robot.base, sent, steering));
}

void BodyNavigator::set_settings(const Settings& settings) {
  state_->set_settings(checked(settings));
}

NavigationStep BodyNavigator::update(const Measurements& measurements) {
  return state_->update(measurements);
}

SharedMotion BodyNavigator::share(std::uint32_t robot,
                                  double time,
                                  const Pose2& pose) const noexcept {
  SharedMotion motion = report_body(state_->robot.body, state_->follower, pose, time,
                                    state_->settings.navigation.control_period, state_->drives());
  motion.robot = robot;
  return motion;
}

bool BodyNavigator::plan_now(const Measurements& measurements) {
  state_->around.prepare();
  state_->note_place(measurements);
  state_->plan_if_needed(measurements, true);
  return state_->follows_new_plan;
}

const Settings& BodyNavigator::settings() const noexcept { return state_->settings; }
const RobotModel& BodyNavigator::robot() const noexcept { return state_->robot; }
const Plan& BodyNavigator::plan() const noexcept { return state_->plan; }
bool BodyNavigator::follows_new_plan() const noexcept { return state_->follows_new_plan; }
bool BodyNavigator::planned() const noexcept { return state_->planned; }
bool BodyNavigator::plan_is_current() const noexcept { return state_->has_drive(); }

MovingObstacles BodyNavigator::tracked() const noexcept {
  const Perception* const perception = state_->around.perception();
  return perception != nullptr ? perception->tracker().obstacles() : MovingObstacles();
}

const BitGrid* BodyNavigator::obstacles() const noexcept {
  return state_->around.known() ? &state_->around.for_plans().obstacles() : nullptr;
}

void BodyNavigator::wait_for_plan() const noexcept { state_->planning.wait(); }

void BodyNavigator::lend_clock(std::function<double()> clock) {
  state_->planning.lend_clock(std::move(clock));
}

double BodyNavigator::planning_seconds() const noexcept {
  return state_->planned ? state_->planning.seconds() : 0.0;
}

void BodyNavigator::State::set_settings(const Settings& given) {
  settings = given;
  around.set_settings(given);
  follower.set_settings(given.navigation.control_period, given.safety);
  control =
      BodyControl(robot, given.mpc, given.navigation.control_period, given.safety.stop_margin);
  planning.set_background(given.planning.background);
}

// A stop is proven for every time until the next command up to the longest hold. At rest nothing
// was held for too long, and a plan may have taken its time.
LimitingFactor BodyNavigator::State::check_cycle(const Measurements& m) noexcept {
  const double period = settings.navigation.control_period;
  const CycleTiming timing = timer_.next(m.time, period, settings.safety.longest_hold * period);
  follower.begin_cycle({.elapsed = timing.elapsed,
                        .longest = timer_.longest_late(),
                        .shortest = timer_.shortest(period),
                        .irregular = timer_.irregular()});
  const LimitingFactor bad = check(m);
  if (bad != LimitingFactor::None) return bad;
  if (timing.punctuality == Punctuality::Invalid) return LimitingFactor::InvalidTime;
  const bool late = timing.punctuality == Punctuality::Late && !follower.at_rest();
  return late ? LimitingFactor::LateCycle : LimitingFactor::None;
}

}  // namespace fairway
