// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/retreat_search.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kLatticeSpacing = 0.2;  // [m] between neighbours
constexpr double kBody = 0.05;           // [m] between bodies
constexpr int kBudget = 400;             // steps of the lattice that are checked in a cycle
constexpr std::array kClearances = {0.2, 0.1, 0.05, kLeastRetreatClearance};  // tried in turn [m]
constexpr std::uint8_t kUnseen = 255;
constexpr std::uint8_t kStartMark = 254;

struct Direction {
  int x;
  int y;
};
constexpr std::array<Direction, 8> kNeighbours{{{.x = 1, .y = 0},
                                                {.x = 0, .y = 1},
                                                {.x = -1, .y = 0},
                                                {.x = 0, .y = -1},
                                                {.x = 1, .y = 1},
                                                {.x = -1, .y = 1},
                                                {.x = -1, .y = -1},
                                                {.x = 1, .y = -1}}};

// Returns the space that other robots need before the place [m]. These are the robots between this
// one and a passing one; they retreat after this robot.
double clearance_for_followers(const Vector2d& position,
                               const PassingEnvironment& around) noexcept {
  double needed = 0.0;
  for (const FleetMember& member : around.fleet) {
    const SharedMotion& other = *member.motion;
    if (!other.under_way || around.must_yield_to(other) || other.can_step_aside) continue;
    const bool between =
        std::any_of(around.passing.begin(), around.passing.end(), [&](const SharedMotion* coming) {
          return coming != nullptr &&
                 (coming->position - other.position).norm() < (coming->position - position).norm();
        });
    if (between) needed += 2.0 * other.radius + kBody;
  }
  return needed;
}

}  // namespace

void RetreatSearch::begin(const Vector2d& position, const PassingEnvironment& around) noexcept {
  running_ = true;
  start_ = position;
  after_ = clearance_for_followers(position, around);
  pass_ = 0;
  begin_pass(around);
}

// Every clearance with a place that leaves enough for those who follow, then without.
void RetreatSearch::begin_pass(const PassingEnvironment& around) noexcept {
  more_ = pass_ % 2 == 0 ? after_ : 0.0;
  radius_ = around.radius + kClearances[pass_ / 2];
  // A start that has less clearance must be possible to leave.
  start_radius_ = std::min(
      radius_, distance_to_blocked(*around.obstacles, start_, radius_) - 2.0 * kFreeSpaceSkin);
  from_.fill(kUnseen);
  first_ = 0;
  last_ = 0;
  place_ = -1;
  path_ = {};
  if (start_radius_ >= around.radius) push(kStart, kStartMark);
}

// Whether there is another pass.
bool RetreatSearch::end_pass(const PassingEnvironment& around) noexcept {
  pass_ += after_ == 0.0 && pass_ % 2 == 0 ? 2U : 1U;
  running_ = pass_ < 2 * kClearances.size();
  if (running_) begin_pass(around);
  return running_;
}

std::optional<RetreatPath> RetreatSearch::advance(const PassingEnvironment& around) noexcept {
  int budget = kBudget;
  while (budget > 0) {
    if (place_ < 0) {
      const std::optional<int> found = expand(around, budget);
      if (found) follow_back(*found);
    } else if (straighten(around, budget)) {
      running_ = false;
      if (path_.exists() && path_.place() == at(place_)) return path_;
      running_ = true;  // it has too many corners
      if (!end_pass(around)) return RetreatPath{};
    }
    const bool exhausted = place_ < 0 && first_ == last_;
    if (exhausted && !end_pass(around)) return RetreatPath{};
  }
  return std::nullopt;
}

// Takes nodes off the queue until one suits, or the budget is used up.
std::optional<int> RetreatSearch::expand(const PassingEnvironment& around, int& budget) noexcept {
  while (first_ < last_ && budget > 0) {
    const int node = queue_[static_cast<std::size_t>(first_++)];
    --budget;
    if (node != kStart && suits(around, at(node))) return node;
    for (std::size_t d = 0; d < kNeighbours.size(); ++d) {
      const int x = node % kSide + kNeighbours[d].x;
      const int y = node / kSide + kNeighbours[d].y;
      if (x < 0 || y < 0 || x >= kSide || y >= kSide) continue;
      const int next = y * kSide + x;
      if (from_[static_cast<std::size_t>(next)] == kUnseen &&
          can_go(around, at(node), at(next), budget)) {
        push(next, static_cast<std::uint8_t>(d));
      }
    }
  }
  return std::nullopt;
}

// Puts the nodes from the start to the place that was found into the queue.
void RetreatSearch::follow_back(int place) noexcept {
  place_ = place;
  count_ = 0;
  for (int node = place;;) {
    queue_[static_cast<std::size_t>(count_++)] = static_cast<std::uint16_t>(node);
    if (node == kStart) break;
    const Direction& came = kNeighbours[from_[static_cast<std::size_t>(node)]];
    node -= came.y * kSide + came.x;
  }
  std::reverse(queue_.begin(), queue_.begin() + count_);
  here_ = 0;
  seen_ = 1;
}

// From each node straight to the furthest that is visible. True once the place is reached.
bool RetreatSearch::straighten(const PassingEnvironment& around, int& budget) noexcept {
  while (budget > 0) {
    if (seen_ + 1 < count_ && is_clear(around, queued(here_), queued(seen_ + 1), budget)) {
      ++seen_;
      continue;
    }
    path_.points.push_back(queued(seen_));
    here_ = seen_;
    ++seen_;
    if (here_ + 1 >= count_ || path_.points.full()) return true;
  }
  return false;
}

void RetreatSearch::push(int node, std::uint8_t from) noexcept {
  from_[static_cast<std::size_t>(node)] = from;
  queue_[static_cast<std::size_t>(last_++)] = static_cast<std::uint16_t>(node);
}

Vector2d RetreatSearch::at(int node) const noexcept {
  return start_ + kLatticeSpacing * Vector2d(node % kSide - kHalf, node / kSide - kHalf);
}

Vector2d RetreatSearch::queued(int index) const noexcept {
  return at(queue_[static_cast<std::size_t>(index)]);
}

// Costs as many steps as the segment is long.
bool RetreatSearch::is_clear(const PassingEnvironment& around,
                             const Vector2d& a,
                             const Vector2d& b,
                             int& budget) const noexcept {
  budget -= 1 + static_cast<int>((b - a).norm() / kLatticeSpacing);
  return is_free(*around.obstacles, a, b, a == start_ ? start_radius_ : radius_);
}

bool RetreatSearch::can_go(const PassingEnvironment& around,
                           const Vector2d& a,
                           const Vector2d& b,
                           int& budget) const noexcept {
  for (const FleetMember& member : around.fleet) {
    const SharedMotion& other = *member.motion;
    if (other.under_way && !around.must_yield_to(other)) continue;
    const double before = (a - other.position).norm();
    const double after = (b - other.position).norm();
    if (after < around.radius + other.radius + kBody && after < before) return false;
  }
  const bool past =
      std::any_of(around.passing.begin(), around.passing.end(), [&](const SharedMotion* other) {
        return other != nullptr && passes_goal_of(*other, a, b, around.radius);
      });
  return !past && is_clear(around, a, b, budget);
}

bool RetreatSearch::suits(const PassingEnvironment& around, const Vector2d& place) const noexcept {
  for (const FleetMember& member : around.fleet) {
    const double apart = (member.motion->position - place).norm();
    if (apart < around.radius + member.motion->radius + kBody) return false;
  }
  return std::all_of(around.passing.begin(), around.passing.end(), [&](const SharedMotion* other) {
    return other == nullptr || lets_pass(place, *other, around.radius, more_);
  });
}

RetreatPath find_retreat_path(const Vector2d& position, const PassingEnvironment& around) noexcept {
  RetreatSearch search;
  search.begin(position, around);
  while (true) {
    if (const std::optional<RetreatPath> found = search.advance(around)) return *found;
  }
}

}  // namespace fairway
