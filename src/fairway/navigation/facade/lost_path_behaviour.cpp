// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/lost_path_behaviour.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

constexpr double kSettle = 0.3;         // [s] at standstill before anything else is tried
constexpr double kLongestLeg = 2.0;     // [rad]
constexpr double kLongestTurn = 12.0;   // [s] for one leg
constexpr double kLongestDrive = 60.0;  // [s] to an opening
constexpr double kLongestSearch = 5.0;  // [s] until a search counts as failed
constexpr double kWait = 3.0;           // [s]
constexpr double kOverlap = 0.2;        // [rad] that is seen twice
constexpr int kMostExamined = 2;        // openings between two waits
constexpr int kRefused = 10;            // cycles after which a turn counts as impossible

}  // namespace

void LostPathBehaviour::begin(double time) noexcept {
  if (active()) return;
  enter(LostPathAction::Brake, time);
}

void LostPathBehaviour::enter(LostPathAction action, double time) noexcept {
  action_ = action;
  since_ = time;
  refusals_ = 0;
  changed_ = true;
}

void LostPathBehaviour::begin_look(const LostPathView& view) noexcept {
  look_began_ = view.scans;
  if (!(view.blind_angle > 0.0)) {
    enter(LostPathAction::Search, view.time);
    return;
  }
  const double turn = view.blind_angle + kOverlap;
  const int legs = std::max(1, static_cast<int>(std::ceil(turn / kLongestLeg)));
  leg_ = turn / legs;
  legs_ = legs - 1;
  heading_ = wrap_to_pi(view.heading + leg_);
  enter(LostPathAction::Turn, view.time);
}

bool LostPathBehaviour::update(const LostPathView& view) noexcept {
  const double elapsed = view.time - since_;
  switch (action_) {
    case LostPathAction::None:
      break;
    case LostPathAction::Brake:
      if (!view.standing)
        since_ = view.time;
      else if (elapsed >= kSettle)
        begin_look(view);
      break;
    case LostPathAction::Turn:
      refusals_ = view.refused ? refusals_ + 1 : 0;
      if (refusals_ >= kRefused || elapsed > kLongestTurn) {
        enter(LostPathAction::Search, view.time);
      } else if (view.arrived && legs_ > 0) {
        --legs_;
        heading_ = wrap_to_pi(heading_ + leg_);
        enter(LostPathAction::Turn, view.time);
      } else if (view.arrived) {
        enter(LostPathAction::Search, view.time);
      }
      break;
    case LostPathAction::Search:
      if (elapsed > kLongestSearch) enter(LostPathAction::Wait, view.time);
      break;
    case LostPathAction::Examine:
      if (view.arrived || elapsed > kLongestDrive)
        begin_look(view);
      else if (!view.fits)
        enter(LostPathAction::Brake, view.time);
      break;
    case LostPathAction::Wait:
      if (elapsed > kWait) begin_look(view);
      break;
  }
  return std::exchange(changed_, false);
}

void LostPathBehaviour::searched(double time, bool opening, double facing) noexcept {
  if (action_ != LostPathAction::Search) return;
  heading_ = facing;
  const bool drives = opening && examined_ < kMostExamined;
  examined_ = drives ? examined_ + 1 : 0;
  enter(drives ? LostPathAction::Examine : LostPathAction::Wait, time);
}

}  // namespace fairway
