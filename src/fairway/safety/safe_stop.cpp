// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/safe_stop.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace fairway {

namespace {

// The commands after the first, `follow` of them, and full braking from there.
StopSequence follow_then_brake(std::span<const Twist2> commands,
                               std::size_t follow,
                               const RobotSettings& robot,
                               double period) noexcept {
  StopSequence stop;
  for (std::size_t i = 1; i <= follow; ++i)
    stop.commands[static_cast<std::size_t>(stop.count++)] = commands[i];
  const StopSequence braking = brake_from(commands[follow], robot, period);
  for (int i = 0; i < braking.count && stop.count < StopSequence::kMaxLength; ++i)
    stop.commands[static_cast<std::size_t>(stop.count++)] =
        braking.commands[static_cast<std::size_t>(i)];
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

}  // namespace

void SafeStop::reset(const Twist2& actual) noexcept {
  stop_ = brake_from(actual, robot_, period_);
  done_ = 0;
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
    const StopOutcome outcome = follow_stop(situation.pose, situation.current, commands[0], stop,
                                            period_, situation.hold, situation.around);
    if (outcome.verdict == StopVerdict::HitsStatic) return false;
    if (outcome.verdict != StopVerdict::Free) continue;
    stop_ = stop;
    done_ = 0;
    return true;
  }
  return false;
}

StopSequence SafeStop::rest() const noexcept {
  StopSequence rest;
  for (int i = done_; i < stop_.count; ++i)
    rest.commands[static_cast<std::size_t>(rest.count++)] =
        stop_.commands[static_cast<std::size_t>(i)];
  return rest;
}

double SafeStop::contact_time(const StopSituation& situation) const noexcept {
  StopSequence after = rest();
  Twist2 first;
  if (after.count > 0) {
    first = after.commands[0];
    std::copy(after.commands.begin() + 1, after.commands.begin() + after.count,
              after.commands.begin());
    --after.count;
  }
  const StopOutcome outcome = follow_stop(situation.pose, situation.current, first, after, period_,
                                          situation.hold, situation.around);
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
  // A way that something moving would meet is looked at no further than to there; what stands must
  // be out of all of it, since what moves may do otherwise.
  StopSituation alone = situation;
  alone.around.moving = {};
  alone.around.fleet = {};
  const auto consider = [&](std::span<const Twist2> way) {
    const StopSequence stop = follow_then_brake(way, way.size() - 1, robot_, period_);
    const StopOutcome outcome = follow_stop(situation.pose, situation.current, way[0], stop,
                                            period_, situation.hold, situation.around);
    if (outcome.verdict == StopVerdict::HitsStatic) return;
    const bool whole = outcome.verdict == StopVerdict::Free;
    const double time = whole ? std::numeric_limits<double>::infinity() : outcome.time;
    if (!(time > latest)) return;
    if (!whole && check_stop(alone.pose, alone.current, way[0], stop, period_, alone.around) !=
                      StopVerdict::Free) {
      return;
    }
    latest = time;
    found = true;
    stop_.count = 1;
    stop_.commands[0] = way[0];
    for (int i = 0; i < stop.count && stop_.count < StopSequence::kMaxLength; ++i)
      stop_.commands[static_cast<std::size_t>(stop_.count++)] =
          stop.commands[static_cast<std::size_t>(i)];
    done_ = 0;
  };
  if (!commands.empty()) consider(commands);
  for (const double linear : {robot_.linear_max, 0.5 * robot_.linear_max, robot_.linear_min}) {
    for (const double angular : {0.0, robot_.angular_max, -robot_.angular_max}) {
      run_towards(situation.current, {.linear = linear, .angular = angular}, robot_, period_, run);
      consider(run);
    }
  }
  return found;
}

Twist2 SafeStop::next() noexcept {
  return done_ < stop_.count ? stop_.commands[static_cast<std::size_t>(done_++)] : Twist2{};
}

}  // namespace fairway
