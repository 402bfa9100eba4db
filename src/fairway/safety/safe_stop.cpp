// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/safe_stop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

constexpr double kRoundedUp = 1.0 + 1e-9;

// The commands after the first, `follow` of them, and full braking from there.
StopSequence follow_then_brake(std::span<const Twist2> commands,
                               std::size_t follow,
                               const RobotSettings& robot,
                               double period) noexcept {
  StopSequence stop;
  const auto after_first = commands.subspan(1, follow);
  stop.append(after_first.begin(), after_first.end());
  const StopSequence braking = brake_from(commands[follow], robot, period);
  stop.append(braking.begin(), braking.end());
  return stop;
}

// As fast and as hard to one side as the limits allow, from `current` on.
template <std::size_t N>
void run_towards(const Twist2& current,
                 const Twist2& wanted,
                 const RobotSettings& robot,
                 double period,
                 std::array<Twist2, N>& commands) noexcept {
  Twist2 now = current;
  for (Twist2& command : commands)
    command = now = limited_change(now, wanted, robot, period);
}

constexpr std::size_t kMostStationary = 64;

// Those of `moving` whose speed is about zero.
MovingObstacles stationary_among(MovingObstacles moving,
                                 std::array<MovingObstacle, kMostStationary>& stationary) noexcept {
  constexpr double kStill = 0.1;  // [m/s]
  std::size_t count = 0;
  for (const MovingObstacle& obstacle : moving) {
    if (obstacle.velocity.norm() < kStill && count < kMostStationary)
      stationary[count++] = obstacle;
  }
  return {stationary.data(), count};
}

// `wanted` itself where the limits allow it in `time`, else as near to it as they do.
Twist2 within_reach(const Twist2& from,
                    const Twist2& wanted,
                    const RobotSettings& robot,
                    double time) noexcept {
  constexpr double kSame = 1e-12;
  const Twist2 nearest = limited_change(from, wanted, robot, time);
  return {
      .linear = std::abs(nearest.linear - wanted.linear) < kSame ? wanted.linear : nearest.linear,
      .angular =
          std::abs(nearest.angular - wanted.angular) < kSame ? wanted.angular : nearest.angular};
}

}  // namespace

void SafeStop::reset(const Twist2& actual) noexcept {
  first_ = actual;
  last_ = actual;
  stop_ = brake_from(actual, robot_, period_);
  since_ = 0.0;
  done_ = 0;
  in_cycle_ = false;
}

void SafeStop::begin_cycle(double elapsed, double ramp) noexcept {
  since_ += elapsed;
  elapsed_ = elapsed;
  ramp_ = ramp;
  in_cycle_ = true;
}

StopManoeuvre SafeStop::manoeuvre(const StopSituation& situation,
                                  const Twist2& command,
                                  const StopSequence& stop) const noexcept {
  const double change =
      std::max(change_time(situation.current.linear, command.linear, actuation_.linear),
               change_time(situation.current.angular, command.angular, actuation_.angular));
  return {.current = situation.current,
          .command = command,
          .stop = stop,
          .period = period_,
          .ramp = change > kRoundedUp * ramp_ ? change : ramp_,
          .irregular = situation.irregular,
          .actuation = &actuation_,
          .response = situation.response,
          .history = situation.history,
          .time = situation.time};
}

// Where the next commands come a period later, as late as is promised, and as early as they came.
// Late and early ones may also begin at any time of the stop: what is between is in `later` and
// `earlier`.
StopVerdict SafeStop::prove(const StopSituation& situation,
                            const Twist2& command,
                            const StopSequence& stop) const noexcept {
  const double longest = std::max({period_, longest_interval_, situation.longest_interval});
  const double shortest =
      situation.irregular ? std::min({period_, ramp_, situation.shortest_interval}) : period_;
  StopManoeuvre regular = manoeuvre(situation, command, stop);
  regular.later = longest - period_;
  regular.earlier = period_ - shortest;
  const StopVerdict verdict =
      follow_stop(situation.pose, regular, situation.hold, situation.around).verdict;
  const bool moves = command.linear != 0.0 || command.angular != 0.0;
  if (verdict != StopVerdict::Free || !moves) return verdict;
  // The other robots are published the stop of a regular cycle, and check against that.
  CollisionEnvironment alone = situation.around;
  alone.fleet = {};
  if (longest > period_) {
    StopManoeuvre late = regular;
    late.hold = longest;
    late.later = 0.0;
    late.earlier = longest - shortest;
    const StopVerdict touches = follow_stop(situation.pose, late, situation.hold, alone).verdict;
    if (touches != StopVerdict::Free) return touches;
  }
  constexpr double kEarly = 0.9;  // periods
  if (shortest > kEarly * period_) return verdict;
  StopManoeuvre early = regular;
  early.ramp = early.hold = shortest;
  early.later = longest - shortest;
  early.earlier = 0.0;
  return follow_stop(situation.pose, early, situation.hold, alone).verdict;
}

bool SafeStop::take(const StopSituation& situation, std::span<const Twist2> commands) noexcept {
  if (commands.empty() ||
      !std::all_of(commands.begin(), commands.end(), [](const Twist2& c) { return is_finite(c); }))
    return false;
  const std::size_t most = commands.size() - 1;
  std::size_t tried = commands.size();
  const bool at_once = situation.around.moving.empty() && is_late(situation.around.fleet);
  for (const std::size_t follow : {std::size_t{0}, most / 4, most / 2, most}) {
    if (follow == tried || (at_once && follow > 0)) continue;
    tried = follow;
    const StopSequence stop = follow_then_brake(commands, follow, robot_, period_);
    const StopVerdict verdict = prove(situation, commands[0], stop);
    refusal_ = verdict;
    if (is_final(verdict)) return false;
    if (verdict != StopVerdict::Free) continue;
    first_ = commands[0];
    last_ = commands[0];
    stop_ = stop;
    since_ = 0.0;
    done_ = 0;
    in_cycle_ = false;
    return true;
  }
  return false;
}

// Of the command of this cycle: 0 is `first_`, 1 the first of `stop_`, and so on. It is what the
// base is to reach a period later, so one that is early brakes early; none adds to the lateness.
double SafeStop::index() const noexcept {
  constexpr double kWhole = 1e-6;
  const double index = (in_cycle_ ? since_ : since_ + period_) / period_;
  const double whole = std::round(index);
  return std::abs(index - whole) < kWhole ? whole : index;
}

Twist2 SafeStop::command_at(double index) const noexcept {
  if (index >= static_cast<double>(stop_.size())) return stop_.empty() ? first_ : stop_.back();
  const auto k = static_cast<std::size_t>(index);
  const Twist2& from = k == 0 ? first_ : stop_[k - 1];
  const double share = index - static_cast<double>(k);
  if (share == 0.0) return from;
  const Twist2& to = stop_[k];
  return {.linear = from.linear + share * (to.linear - from.linear),
          .angular = from.angular + share * (to.angular - from.angular)};
}

double SafeStop::contact_time(const StopSituation& situation) const noexcept {
  const double now = index();
  StopSequence after;
  for (double next = now + 1.0; next < static_cast<double>(stop_.size()) + 1.0; next += 1.0)
    after.push_back(command_at(next));
  // A stop that was proven with a margin is left for a contact only. Obstacles are seen with
  // errors, and one that comes within the margin is no reason to evade.
  CollisionEnvironment touching = situation.around;
  touching.moving_margin = 0.0;
  const StopOutcome outcome = follow_stop(
      situation.pose, manoeuvre(situation, command_at(now), after), situation.hold, touching);
  return outcome.verdict == StopVerdict::HitsMoving ? outcome.time
                                                    : std::numeric_limits<double>::infinity();
}

bool SafeStop::evade(const StopSituation& situation,
                     std::span<const Twist2> commands,
                     double than) noexcept {
  constexpr std::size_t kRun = 10;  // cycles
  std::array<Twist2, kRun> run;
  double latest = than + period_;
  bool found = false;
  // A manoeuvre that a moving obstacle would meet is looked at no further than to there. Static
  // obstacles and stationary people must be out of all of it; predictions of others may be wrong.
  StopSituation alone = situation;
  std::array<MovingObstacle, kMostStationary> stationary;
  alone.around.moving = stationary_among(situation.around.moving, stationary);
  alone.around.fleet = {};
  CollisionEnvironment around = situation.around;
  const auto consider = [&](std::span<const Twist2> way) {
    const StopSequence stop = follow_then_brake(way, way.size() - 1, robot_, period_);
    const StopOutcome outcome =
        follow_stop(situation.pose, manoeuvre(situation, way[0], stop), situation.hold, around);
    if (is_final(outcome.verdict)) return;
    const bool whole = outcome.verdict == StopVerdict::Free;
    const double time = whole ? std::numeric_limits<double>::infinity() : outcome.time;
    if (!(time > latest) || prove(alone, way[0], stop) != StopVerdict::Free) return;
    latest = time;
    found = true;
    first_ = way[0];
    stop_ = {way[0]};
    stop_.append(stop.begin(), stop.end());
    since_ = period_;  // its first command is the next
    done_ = 0;
    in_cycle_ = true;
  };
  const auto consider_all = [&] {
    if (!commands.empty()) consider(commands);
    for (const double linear : {robot_.linear_max, 0.5 * robot_.linear_max, robot_.linear_min}) {
      for (const double angular : {0.0, robot_.angular_max, -robot_.angular_max}) {
        run_towards(situation.current, {.linear = linear, .angular = angular}, robot_, period_,
                    run);
        consider(run);
      }
    }
  };
  consider_all();
  if (found) return true;
  // None comes within the margin later than the contact: now only contacts count.
  around.moving_margin = 0.0;
  consider_all();
  return found;
}

Twist2 SafeStop::next() noexcept {
  const double now = index();
  const double interval = std::max(period_, in_cycle_ ? elapsed_ : period_) * kRoundedUp;
  const Twist2 command = within_reach(last_, command_at(now), robot_, interval);
  last_ = command;
  if (!in_cycle_) since_ += period_;
  in_cycle_ = false;
  done_ = std::min(stop_.size(), static_cast<std::size_t>(now));
  const bool over = now >= static_cast<double>(stop_.size());
  if (over && (command.linear != 0.0 || command.angular != 0.0)) reset(command);
  return command;
}

}  // namespace fairway
