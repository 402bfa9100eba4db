// SPDX-License-Identifier: Apache-2.0
// What a MaplessNavigator does while there is no path in what it knows.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/map/free_space.hpp"
#include "fairway/navigation/facade/mapless_navigator_state.hpp"
#include "fairway/tracking/corridor_check.hpp"

namespace fairway {

using Eigen::Vector2d;

// Whether the plan being followed is still free in the map. A cell that flickers at a side does not
// count.
bool MaplessNavigator::State::plan_fits_map() const noexcept {
  const double flicker = 0.5 * wider.perception.resolution;
  return navigator.plan().usable() &&
         corridor_is_free(perception.grid().occupied(), navigator.corridor(), wider.robot.radius,
                          flicker) &&
         path_is_free();
}

void MaplessNavigator::State::use(Plan plan, bool leads_to_goal) {
  leads_to_goal_ = leads_to_goal;
  follows_new_plan = true;
  plan_done_ = false;
  navigator.follow(std::move(plan));
}

// Handles a search that found no path.
void MaplessNavigator::State::no_path(LocalPlan& made) {
  constexpr double kHere = 0.3;  // [m]; a viewpoint that near is not driven to
  if (!lost_.active()) {
    lost_.begin(plan_time_);
    use(std::move(made.plan), false);
    return;
  }
  if (!made.request.find_opening) return;
  double facing = input.pose.heading;
  bool drive = false;
  if (made.opening) {
    const Vector2d ahead = made.opening->blocked_at - input.pose.position;
    facing = std::atan2(ahead.y(), ahead.x());
    drive =
        made.to_opening.usable() && (made.opening->viewpoint - input.pose.position).norm() > kHere;
    tried_.add(made.opening->blocked_at);
  }
  lost_.searched(plan_time_, drive, facing);
  if (lost_.action() == LostPathAction::Examine) use(std::move(made.to_opening), false);
}

void MaplessNavigator::State::act_without_path(const Measurements& m) {
  constexpr int kFewestScans = 10;  // obstacles seen in one of these scans are not doubted
  if (!lost_.active()) return;
  const bool other = lost_.update({.time = m.time,
                                   .scans = scans_,
                                   .heading = m.pose.heading,
                                   .standing = sent.linear == 0.0 && sent.angular == 0.0,
                                   .arrived = plan_done_,
                                   .fits = plan_fits_map(),
                                   .refused = turn_refused_,
                                   .blind_angle = blind_angle_});
  if (!other) return;
  switch (lost_.action()) {
    case LostPathAction::None:
    case LostPathAction::Examine:
      break;
    case LostPathAction::Brake:
      if (navigator.plan().usable()) use(Plan{}, false);
      break;
    case LostPathAction::Turn:
    case LostPathAction::Wait:
      use(turn_plan(m.pose, lost_.heading()), false);
      break;
    case LostPathAction::Search:
      planning->note_change(
          perception.doubt_unseen(std::max(kFewestScans, scans_ - lost_.look_began())));
      search_opening_ = true;
      break;
  }
}

// A plan that stays here and turns.
Plan MaplessNavigator::State::turn_plan(const Pose2& pose, double heading) const {
  const double side = 0.5 * wider.navigation.goal_tolerance;
  Plan plan{.path_status = PathStatus::Found,
            .corridor_status = CorridorStatus::Built,
            .path = {.waypoints = {pose.position, pose.position}},
            .corridor = {.robot_radius = wider.robot.radius},
            .goal = {.position = pose.position, .heading = heading},
            .margin = wider.path.margin};
  plan.corridor.rectangles.push_back({.seed = pose.position,
                                      .orientation = 0.0,
                                      .min = Vector2d(-side, -side),
                                      .max = Vector2d(side, side)});
  plan.corridor.spans.push_back({});
  return plan;
}

// Whether the plan being followed only turns. Depends on the plan alone, so that a replay finds the
// same.
bool MaplessNavigator::State::turns() const noexcept {
  const Plan& plan = navigator.plan();
  return plan.usable() && !leads_to_goal_ && plan.goal.heading && plan.path.length() == 0.0;
}

}  // namespace fairway
