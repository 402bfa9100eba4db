// SPDX-License-Identifier: Apache-2.0
// What zones and a hold ask of a cycle of a Navigator. The cycle itself is in navigator.cpp.
#include <algorithm>
#include <cmath>

#include "fairway/navigation/limiting_factor.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/safety/zone_check.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

constexpr double kBeside = 0.05;       // [m] that the robot may leave its reference path by
constexpr double kZoneBraking = 0.85;  // share of the limit; the targets use 0.8
constexpr double kHoldBraking = 0.8;

}  // namespace

// Where zones along the path limit the speed.
void Navigator::find_zone_speeds(const NavigationInput& input) noexcept {
  zone_speeds_.spans.clear();
  in_speed_zone_ = false;
  const ZoneMap* zones = input.map->zones();
  if (zones == nullptr || zones->speed_regions().empty()) return;
  const RobotSettings& robot = settings_.robot;
  const double horizon = settings_.mpc.horizon * settings_.mpc.step_length;
  const double reach = 2.0 * braking_distance(robot) + horizon * robot.linear_max + 1.0;
  find_speed_limits(*zones, path_, body_.circumscribed_radius() + kBeside, reach, zone_speeds_);
}

// Limits the speed so that the limit of a zone ahead can still be met after the next command. It
// also sets the speed of a robot that brakes for a hold.
void Navigator::limit_speed(const NavigationInput& input) noexcept {
  const double change = change_max(linear_actuation(settings_.robot));
  // The first command of an answer is reached a step later.
  const double ahead = settings_.mpc.step_length;
  const double reaction = longest_ + dead_time_ + lag_ + ahead;
  const double speed = std::abs(sent_.linear);
  const double braking = kZoneBraking * change;
  double limit =
      std::min(zone_speeds_.at(0.0, braking), zone_speeds_.at(speed * reaction, braking));
  in_speed_zone_ = limit < settings_.robot.linear_max;
  if (input.hold) limit = std::min(limit, std::max(0.0, speed - kHoldBraking * change * ahead));
  if (!(limit < settings_.robot.linear_max)) return;
  // No faster than the base can brake: the solver takes no bounds that contradict each other.
  const double least = sent_.linear - problem_.max_change.linear;
  const double most = sent_.linear + problem_.max_change.linear;
  problem_.command_max.linear = std::min(problem_.command_max.linear, std::max(limit, least));
  problem_.command_min.linear = std::max(problem_.command_min.linear, std::min(-limit, most));
  problem_.command_min.linear = std::min(problem_.command_min.linear, problem_.command_max.linear);
}

// At standstill; a turn on the spot ends.
NavigationStep Navigator::stay_on_hold() noexcept {
  recovery_.reset();
  solution_.horizon = 0;
  return stop(NavigationStatus::Holding, LimitingFactor::Hold);
}

// Names the zone or the hold behind what limits the robot.
void Navigator::name_limits(const NavigationInput& input, NavigationStep& step) const noexcept {
  if (step.limit == LimitingFactor::StopNotProven) step.limit = limit_of(stop_.refusal());
  const bool placeless =
      step.limit == LimitingFactor::NoPath || step.limit == LimitingFactor::OutsideCorridor;
  const ZoneMap* zones = input.map != nullptr ? input.map->zones() : nullptr;
  if (placeless && zones != nullptr && plan_.path_status != PathStatus::GoalBlocked) {
    const Eigen::Vector2d& here = input.pose.position;
    if (const auto zone = zones->forbidding(segment_rectangle(here, here), settings_.robot.radius,
                                            ZoneSubject::Disc)) {
      step.limit = limit_of(verdict_of(*zones, *zone));
    }
  }
  const bool driving =
      step.status == NavigationStatus::Ok || step.status == NavigationStatus::Degraded;
  if (!driving) return;
  if (in_speed_zone_ && step.limit == LimitingFactor::Speed) step.limit = LimitingFactor::SpeedZone;
  if (!input.hold || goal_check_.reached()) return;
  step.status = NavigationStatus::Holding;
  step.limit = LimitingFactor::Hold;
}

}  // namespace fairway
