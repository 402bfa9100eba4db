// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/body_path_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/path/se2/search_tree.hpp"
#include "fairway/path/se2/shortcuts.hpp"

namespace fairway {

namespace {

// One attempt: a margin and a size of cells.
struct Attempt {
  double margin;
  double cell;
  int headings;
  int max_states;
};

struct Ends {
  Pose2 start;
  Pose2 goal;
  GoalDistance to_goal;
  GoalDistance to_start;
};

BodyPathResult search(const BodyClearance& clearance,
                      const MotionCost& cost,
                      const Ends& ends,
                      const Attempt& attempt,
                      const BodyPathSettings& settings) {
  const internal::SearchTask task{
      .clearance = &clearance,
      .cost = &cost,
      .moves = make_moves(cost.base(), clearance.body().circumscribed_radius(), attempt.cell,
                          attempt.headings),
      .margin = attempt.margin,
      .greediness = settings.greediness};
  internal::SearchTree forwards(task, ends.start, ends.goal, false, ends.to_goal);
  internal::SearchTree backwards(task, ends.goal, ends.start, true, ends.to_start);
  constexpr int kTurn = 32;  // states that a tree expands in its turn
  BodyPathResult result;
  result.margin = attempt.margin;
  bool more_forwards = true;
  bool more_backwards = true;
  // A tree that is exhausted proves that there is no path at this resolution; one that is done has
  // one.
  while (more_forwards && more_backwards) {
    more_forwards = forwards.expand(kTurn);
    more_backwards = backwards.expand(kTurn);
    result.expanded = forwards.expanded() + backwards.expanded();
    if (result.expanded > attempt.max_states) break;
  }
  const bool first =
      forwards.path() && (!backwards.path() || forwards.path_cost() <= backwards.path_cost());
  const auto& best = first ? forwards.path() : backwards.path();
  if (best) {
    result.status = BodyPathStatus::Found;
    result.path = *best;
  } else {
    result.status =
        more_forwards && more_backwards ? BodyPathStatus::GaveUp : BodyPathStatus::NoPath;
  }
  return result;
}

}  // namespace

const char* to_text(BodyPathStatus status) noexcept {
  switch (status) {
    case BodyPathStatus::Found:
      return "found";
    case BodyPathStatus::StartBlocked:
      return "the body does not fit at the start";
    case BodyPathStatus::GoalBlocked:
      return "the body does not fit at the goal";
    case BodyPathStatus::NoPath:
      return "there is no path for the body";
    case BodyPathStatus::GaveUp:
      return "no path was found within the budget";
  }
  return "unknown";
}

std::string BodyPathResult::reason() const {
  std::string text = to_text(status);
  if (status == BodyPathStatus::NoPath || status == BodyPathStatus::GaveUp)
    text += ": " + std::to_string(expanded) + " states searched";
  return text;
}

BodyPathResult plan_body_path(const BodyClearance& clearance,
                              const BaseModel& base,
                              const Pose2& start,
                              const Pose2& goal,
                              const BodyPathSettings& settings) {
  BodyPathResult result;
  if (!clearance.is_free(start, 0.0)) {
    result.status = BodyPathStatus::StartBlocked;
    return result;
  }
  if (!clearance.is_free(goal, 0.0)) {
    result.status = BodyPathStatus::GoalBlocked;
    return result;
  }
  const MotionCost cost(base, settings.reverse_factor, settings.cusp_factor);
  const Ends ends{.start = start,
                  .goal = goal,
                  .to_goal = GoalDistance(clearance, goal.position),
                  .to_start = GoalDistance(clearance, start.position)};
  // No path has more clearance than its ends.
  const double most = 0.98 * std::min(clearance.distance(start, settings.margin),
                                      clearance.distance(goal, settings.margin));
  const double margin = std::min(most, settings.margin);
  const double fine = 0.5 * settings.cell;
  const int headings = settings.headings;
  const int states = settings.max_states;
  // Large cells find what is easy; where they do not soon, smaller ones are faster after all.
  constexpr int kEasy = 25000;
  const int easy = std::min(kEasy, states);
  const double large = 2.0 * settings.cell;
  const std::array<Attempt, 7> attempts{{{margin, large, headings, easy},
                                         {0.6 * margin, large, headings, easy},
                                         {0.6 * margin, settings.cell, headings, states},
                                         {0.5 * most, settings.cell, headings, states},
                                         {0.5 * most, fine, 2 * headings, states},
                                         {0.2 * most, settings.cell, headings, states},
                                         {0.1 * most, fine, 2 * headings, states}}};
  for (Attempt attempt : attempts) {
    const int before = result.expanded;
    attempt.max_states = std::min(attempt.max_states, settings.total_states - before);
    if (attempt.max_states <= 0) {
      result.status = BodyPathStatus::GaveUp;
      return result;
    }
    result = search(clearance, cost, ends, attempt, settings);
    result.expanded += before;
    if (result.status != BodyPathStatus::Found) continue;
    take_shortcuts(clearance, cost, result.margin, settings.shortcut_tries, result.path);
    return result;
  }
  return result;
}

}  // namespace fairway
