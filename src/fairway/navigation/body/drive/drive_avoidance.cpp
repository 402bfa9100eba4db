// SPDX-License-Identifier: Apache-2.0
// How a DriveFollower avoids being run into. Its cycle is in drive_follower.cpp.
#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/navigation/body/drive/drive_follower.hpp"
#include "fairway/navigation/body/drive/evasion.hpp"

namespace fairway {

namespace {

constexpr std::array<double, 2> kLeavingShares{1.0, -1.0};  // of its velocity, of an obstacle

}  // namespace

// Whether a robot that stops after a candidate can stay there, or back out along its drive, before
// an obstacle arrives. Obstacles walk on, or turn back at once.
bool DriveFollower::can_leave(const FollowerView& view, const Candidate& next) const noexcept {
  constexpr double kAhead = 4.0;  // [s]
  constexpr double kStep = 0.1;   // [s]
  const BodyShape& body = view.clearance->body();
  MovingSurroundings moving = view.moving;
  moving.fleet = {};  // other robots stop
  moving.prediction.obstacle_growth = 0.0;
  const double fastest = std::max(base_.linear_max, -base_.linear_min) + base_.lateral_max;
  if (is_apart(body, view.pose, moving, fastest, kAhead)) return true;
  const Eigen::Vector2d beside = view.pose.position - reference_.pose_at(progress_.phase).position;
  const auto is_free = [&](double share, double target) {
    DriveProgress now = next.sent_for;
    bool stopped = false;
    for (double time = kStep; time <= kAhead; time += kStep) {
      now = reference_.advanced(now, stopped ? target : 0.0, kStep, 0.5 * kStep);
      stopped = stopped || now.rate == 0.0;
      const Pose2 drive = reference_.pose_at(now.phase);
      if (body_separation(body, {.position = drive.position + beside, .heading = drive.heading},
                          moving, time, share) < 0.0)
        return false;
    }
    return true;
  };
  const double back = backing_rate();
  return std::all_of(kLeavingShares.begin(), kLeavingShares.end(), [&](double share) {
    return is_free(share, 0.0) || (back < 0.0 && is_free(share, back));
  });
}

// A robot that would be run into where it stops drives on if that is predicted to be free: out of
// the way. Its stop need not be free of an obstacle that walks on into it. It is proven for
// obstacles that stop or turn back, so that the robot itself never drives into them.
bool DriveFollower::gives_way(const FollowerView& view, double target) noexcept {
  if (target == 0.0 || beside_ > 0.0) return false;
  constexpr double kDistance = 0.02;  // [m]
  MovingSurroundings moving = view.moving;
  moving.fleet = {};
  moving.prediction.obstacle_margin = kDistance;
  moving.prediction.obstacle_growth = 0.0;
  const BodyShape& body = view.clearance->body();
  const auto separation = [&](double rate) {
    return look_ahead(body, view.pose, reference_, progress_, rate, moving, look_ahead_).separation;
  };
  if (separation(0.0) >= 0.0 || separation(target) < 0.0) return false;
  const Candidate next = candidate(view, target);
  if (prove(view, next, Excuse::GivesWay) != StopVerdict::Free) return false;
  take(next);
  return true;
}

// Whether the rest of the last proven stop still is free of moving obstacles. Then it is executed:
// nothing else is as safe.
bool DriveFollower::stop_is_free(const FollowerView& view) noexcept {
  const double now = since_ / period_;
  if (now >= proven_.count) return false;
  trial_.first = proven_.at(now);
  trial_.count = 0;
  do {
    trial_.inputs[static_cast<std::size_t>(trial_.count)] = proven_.at(now + trial_.count + 1);
    ++trial_.count;
  } while (now + trial_.count < proven_.count);
  return check_stop(base_, view.pose, manoeuvre(trial_.first), trial_, surroundings(view)) ==
         StopVerdict::Free;
}

// Where also braking meets a moving obstacle, driving on may pass before it without contact.
// Otherwise braking is right: nothing else stops earlier. Static obstacles stay excluded. A robot
// beside its drive would return to it at the same time, which is not foreseen here.
bool DriveFollower::escape(const FollowerView& view) noexcept {
  if (beside_ > 0.0) return false;
  constexpr double kDistance = 0.05;  // [m]
  FollowerView fixed = view;
  fixed.moving.obstacles = {};
  MovingSurroundings moving = view.moving;
  moving.prediction.obstacle_margin = kDistance;
  moving.prediction.obstacle_growth = 0.0;
  const BodyShape& body = view.clearance->body();
  for (const double rate : {1.0, 0.6, 0.0}) {
    const bool passes =
        look_ahead(body, view.pose, reference_, progress_, rate, moving, look_ahead_).separation >
        0.0;
    if (!passes && rate > 0.0) continue;
    const Candidate next = candidate(view, rate);
    if (prove(fixed, next) != StopVerdict::Free) continue;
    take(next);
    return true;
  }
  return false;
}

}  // namespace fairway
