// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_start.hpp"

#include <algorithm>
#include <cmath>

namespace fairway::interior_point {
namespace {

// How far a guess is drawn to the middle of the hard rows, and the pursuit that replaces one.
constexpr double kInwards = 0.005;
constexpr double kPursuitInwards = 0.3;

// Drives towards the target of each step: what to begin with when there is no guess. Sharp turns
// are cheap to correct later, the wrong way round is not.
void pursue(const Workspace& w, Point& point) noexcept {
  constexpr double kStepsAhead = 5.0;  // the speed that reaches the target in so many steps
  constexpr double kStepsToTurn = 3.0;
  constexpr double kArrived = 0.1;  // nearer than this, only the heading matters [m]
  const double dt = w.problem->dt;
  const auto limited = [&](std::size_t j, std::size_t k, double command) {
    return std::clamp(command, w.limits[j].reach_low[k], w.limits[j].reach_high[k]);
  };
  double x = 0.0;
  double y = 0.0;
  double heading = point.heading[0];
  double cosine = std::cos(heading);
  double sine = std::sin(heading);
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const double dx = w.target_x[k] - x;
    const double dy = w.target_y[k] - y;
    const double along = cosine * dx + sine * dy;
    const double across = cosine * dy - sine * dx;
    const double distance = std::sqrt(dx * dx + dy * dy);
    double turn = w.target_heading[k] - heading;
    if (distance > kArrived) turn = along > 0.0 ? across / distance : std::copysign(1.0, across);
    const double linear = limited(kLinear, k, along / (kStepsAhead * dt));
    const double angular = limited(kAngular, k, turn / (kStepsToTurn * dt));
    point.commands[kLinear][k + 1] = linear;
    point.commands[kAngular][k + 1] = angular;
    x += dt * linear * cosine;
    y += dt * linear * sine;
    heading += dt * angular;
    // Turns by 2 atan(t), which is near enough, and quick.
    const double t = 0.5 * dt * angular;
    const double scale = 1.0 / (1.0 + t * t);
    const double turned = ((1.0 - t * t) * cosine - 2.0 * t * sine) * scale;
    sine = ((1.0 - t * t) * sine + 2.0 * t * cosine) * scale;
    cosine = turned;
  }
}

// Among obstacles the middle alone is the better start: a pursuit can lead into a place behind them
// that has no way out.
bool is_among_obstacles(const Workspace& w) noexcept {
  return std::any_of(w.row_ranges.begin(),
                     w.row_ranges.begin() + static_cast<std::ptrdiff_t>(w.num_blocks),
                     [](const RowRange& range) { return range.barrier < range.end; });
}

}  // namespace

void load_guess(const InitialGuess& guess, const Workspace& w, Point& point) noexcept {
  const auto given = static_cast<std::size_t>(std::clamp(guess.count, 0, kMaxHorizon));
  double inwards = kInwards;
  if (given > 0) {
    for (std::size_t k = 0; k < w.horizon; ++k) {
      const Twist2& command = guess.commands[std::min(k, given - 1)];
      point.commands[kLinear][k + 1] = command.linear;
      point.commands[kAngular][k + 1] = command.angular;
    }
  } else if (is_among_obstacles(w)) {
    for (PoseArray& commands : point.commands)
      std::fill_n(commands.begin() + 1, w.horizon, 0.0);
    inwards = 1.0;
  } else {
    pursue(w, point);
    inwards = kPursuitInwards;
  }
  for (std::size_t j = 0; j < 2; ++j) {
    double* commands = point.commands[j].data() + 1;
    const CommandLimits& limits = w.limits[j];
    clip_to_reach(limits, static_cast<int>(w.horizon), commands);
    for (std::size_t k = 0; k < w.horizon; ++k) {
      const double middle = 0.5 * (limits.reach_low[k] + limits.reach_high[k]);
      commands[k] += inwards * (middle - commands[k]);
      if (limits.fixed[k]) commands[k] = limits.low[k];
    }
  }
}

}  // namespace fairway::interior_point
