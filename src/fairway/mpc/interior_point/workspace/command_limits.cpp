// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/workspace/command_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway::interior_point {
namespace {

// The interior-point method needs space between bounds; a command with a narrower interval is
// fixed.
constexpr double kLeastWidth = 1e-6;
// Share of the change bound that the reachable intervals use, so that their middles are strictly
// inside.
constexpr double kInside = 0.99;

// Returns `from` moved towards [low, high] by at most `change`.
double approach(double from, double low, double high, double change) noexcept {
  if (from > high) return std::max(high, from - change);
  if (from < low) return std::min(low, from + change);
  return from;
}

// Forward pass: the interval that the change bound allows from the previous command.
void reach_forwards(double low, double high, std::size_t n, CommandLimits& limits) noexcept {
  const double change = kInside * limits.max_change;
  double from_low = limits.previous;
  double from_high = limits.previous;
  for (std::size_t k = 0; k < n; ++k) {
    const double next_low = std::max(low, from_low - change);
    const double next_high = std::min(high, from_high + change);
    const bool outside = next_low > next_high;  // only after a single, fixed command
    const double back = approach(from_low, low, high, limits.max_change);
    limits.reach_low[k] = from_low = outside ? back : next_low;
    limits.reach_high[k] = from_high = outside ? back : next_high;
  }
}

// Backward pass: the interval from which the change bound allows the stop.
void reach_backwards(std::size_t n, CommandLimits& limits) noexcept {
  const double change = kInside * limits.max_change;
  double stop_low = 0.0;
  double stop_high = 0.0;
  bool reached = true;
  for (std::size_t k = n; k-- > 0;) {
    limits.reach_low[k] = std::max(limits.reach_low[k], stop_low);
    limits.reach_high[k] = std::min(limits.reach_high[k], stop_high);
    reached = reached && limits.reach_low[k] <= limits.reach_high[k];
    stop_low = limits.reach_low[k] - change;
    stop_high = limits.reach_high[k] + change;
  }
  if (reached) return;
  double command = limits.previous;
  for (std::size_t k = 0; k < n; ++k) {
    command = approach(command, 0.0, 0.0, limits.max_change);
    limits.reach_low[k] = limits.reach_high[k] = command;
  }
  limits.can_stop = command == 0.0;
}

}  // namespace

void find_command_limits(const ControlProblem& problem,
                         int coordinate,
                         CommandLimits& limits) noexcept {
  const auto of = [coordinate](const Twist2& t) { return coordinate == 0 ? t.linear : t.angular; };
  const double range_low = of(problem.command_min);
  const double range_high = of(problem.command_max);
  const double change = of(problem.max_change);
  const auto n = static_cast<std::size_t>(problem.horizon);
  limits.max_change = change;
  limits.previous = of(problem.previous_command);
  limits.can_stop = true;
  reach_forwards(range_low, range_high, n, limits);
  if (problem.stop_at_end) reach_backwards(n, limits);

  for (std::size_t k = 0; k < n; ++k) {
    limits.fixed[k] = !(limits.reach_high[k] - limits.reach_low[k] >= kLeastWidth);
    if (!limits.fixed[k]) continue;
    limits.low[k] = limits.high[k] = 0.5 * (limits.reach_low[k] + limits.reach_high[k]);
    limits.reach_low[k] = limits.reach_high[k] = limits.low[k];
  }
  for (std::size_t k = 0; k < n; ++k) {
    const bool after_fixed = k == 0 || limits.fixed[k - 1];
    const bool before_fixed = k + 1 < n && limits.fixed[k + 1];
    limits.change_bound[k] = !limits.fixed[k] && !after_fixed && change < range_high - range_low;
    if (limits.fixed[k]) continue;
    limits.low[k] = range_low;
    limits.high[k] = range_high;
    const auto stay_near = [&](double neighbour) {
      limits.low[k] = std::max(limits.low[k], neighbour - change);
      limits.high[k] = std::min(limits.high[k], neighbour + change);
    };
    if (after_fixed) stay_near(k == 0 ? limits.previous : limits.low[k - 1]);
    if (before_fixed) stay_near(limits.low[k + 1]);
  }
}

void clip_to_reach(const CommandLimits& limits, int horizon, double* commands) noexcept {
  double before = limits.previous;
  for (std::size_t k = 0; k < static_cast<std::size_t>(horizon); ++k) {
    const double low = std::max(limits.reach_low[k], before - limits.max_change);
    const double high = std::min(limits.reach_high[k], before + limits.max_change);
    commands[k] = commands[k] > low ? std::min(commands[k], high) : low;
    before = commands[k];
  }
}

void clip_to_limits(const CommandLimits& limits, int horizon, double* commands) noexcept {
  double before = limits.previous;
  for (std::size_t k = 0; k < static_cast<std::size_t>(horizon); ++k) {
    double& command = commands[k];
    const double low = std::max(limits.low[k], before - limits.max_change);
    const double high = std::min(limits.high[k], before + limits.max_change);
    command = command > low ? std::min(command, high) : low;
    // before + change is rounded: the difference can exceed the bound by a unit in the last place.
    const double unit =
        std::numeric_limits<double>::epsilon() * std::max(std::abs(before), std::abs(command));
    for (int i = 1; i <= 4 && std::abs(command - before) > limits.max_change; ++i)
      command =
          before + std::copysign(std::max(0.0, limits.max_change - i * unit), command - before);
    before = command;
  }
}

}  // namespace fairway::interior_point
