// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_setup.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"

namespace fairway::interior_point {
namespace {

// Bounds of rows that are not needed: far enough to weigh nothing.
constexpr double kFar = 1e8;
// How far a guess is drawn to the middle of the hard rows, and the pursuit that replaces one.
constexpr double kInwards = 0.005;
constexpr double kPursuitInwards = 0.3;
// Rows that stay this far from being violated are left out [m or m^2].
constexpr double kNeverActive = 1e-6;

void load_targets(const ControlProblem& problem, Workspace& w) noexcept {
  const Eigen::Vector2d origin = problem.start.position;
  for (std::size_t k = 1; k <= w.horizon; ++k) {
    const StepTarget& target = problem.targets[k];
    w.target_x[k] = target.position.x() - origin.x();
    w.target_y[k] = target.position.y() - origin.y();
    w.target_heading[k] = target.heading - w.full_turns;
    w.weight_x[k] = target.weight.x();
    w.weight_y[k] = target.weight.y();
    w.weight_heading[k] = target.weight.z();
  }
}

void load_hard_rows(const ControlProblem& problem, Workspace& w) noexcept {
  const std::size_t n = w.horizon;
  bool any_change_row = false;
  for (std::size_t j = 0; j < 2; ++j) {
    find_command_limits(problem, static_cast<int>(j), w.limits[j]);
    const CommandLimits& limits = w.limits[j];
    for (std::size_t k = 0; k < n; ++k) {
      const bool fixed = limits.fixed[k];
      w.hard.low[j * n + k] = fixed ? -kFar : limits.low[k];
      w.hard.high[j * n + k] = fixed ? kFar : limits.high[k];
      const double change = limits.change_row[k] ? limits.max_change : kFar;
      w.hard.low[(2 + j) * n + k] = -change;
      w.hard.high[(2 + j) * n + k] = change;
      any_change_row = any_change_row || limits.change_row[k];
    }
  }
  w.hard.count = (any_change_row ? 4 : 2) * n;
}

// How far from the start pose k can be, whatever the commands.
void find_reach(const Workspace& w, double dt, PoseArray& reach) noexcept {
  const CommandLimits& limits = w.limits[0];
  double low = limits.previous;
  double high = limits.previous;
  reach[0] = 0.0;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    low = std::max(limits.low[k], low - limits.max_change);
    high = std::min(limits.high[k], high + limits.max_change);
    reach[k + 1] = reach[k] + dt * std::max(std::abs(low), std::abs(high));
  }
}

// Appends a row for step k, to the last segment where it continues that.
std::size_t append_row(ElasticRows& rows, RowKind kind, std::size_t index, std::size_t k) noexcept {
  if (rows.num_segments > 0) {
    Segment& last = rows.segments[rows.num_segments - 1];
    if (last.kind == kind && last.index == index && last.first_step + last.count == k) {
      ++last.count;
      return rows.count++;
    }
  }
  rows.segments[rows.num_segments++] = {
      .kind = kind, .index = index, .first_step = k, .count = 1, .row = rows.count};
  return rows.count++;
}

void load_corridor(const ControlProblem& problem, const PoseArray& reach, Workspace& w) noexcept {
  for (std::size_t slot = 0; slot < kMaxRectanglesPerStep; ++slot) {
    for (std::size_t side = 0; side < 4; ++side) {
      double orientation = 0.0;
      Eigen::Vector2d axis(1.0, 0.0);
      for (std::size_t k = 1; k <= w.horizon; ++k) {
        const StepRegion& region = problem.regions[k];
        if (static_cast<std::size_t>(region.count) <= slot) continue;
        const OrientedRectangle& rectangle = region.rectangles[slot];
        if (rectangle.orientation != orientation) {
          orientation = rectangle.orientation;
          axis = direction(orientation);
        }
        const Eigen::Vector2d along = side < 2 ? axis : Eigen::Vector2d(-axis.y(), axis.x());
        const double start = along.dot(problem.start.position - rectangle.seed);
        const auto coordinate = static_cast<Eigen::Index>(side / 2);
        const bool lower = side % 2 == 0;
        const double offset =
            lower ? start - rectangle.min[coordinate] : rectangle.max[coordinate] - start;
        if (offset > reach[k] + kNeverActive) continue;
        const std::size_t row = append_row(w.elastic, RowKind::Corridor, 4 * slot + side, k);
        w.elastic.offset[row] = offset;
        w.elastic.normal_x[row] = lower ? along.x() : -along.x();
        w.elastic.normal_y[row] = lower ? along.y() : -along.y();
      }
    }
  }
}

void load_obstacles(const ControlProblem& problem, const PoseArray& reach, Workspace& w) noexcept {
  const double beta = problem.barrier_retention;
  for (std::size_t j = 0; j < static_cast<std::size_t>(problem.num_obstacles); ++j) {
    const PredictedObstacle& obstacle = problem.obstacles[j];
    std::size_t first = w.horizon + 1;
    std::size_t last = 0;
    for (std::size_t k = 0; k <= w.horizon; ++k) {
      const Eigen::Vector2d relative = obstacle.position[k] - problem.start.position;
      w.obstacle_x[j][k] = relative.x();
      w.obstacle_y[j][k] = relative.y();
      if (k == 0) continue;
      const double before = obstacle.keep_out[k - 1];
      const double now = obstacle.keep_out[k];
      w.barrier_offset[j][k] = now * now - beta * before * before;
      // With q = |p_{k-1} - o_{k-1}| and |p_k - o_k| >= q - a, the row is at least
      // (q - a)^2 - beta q^2 - offset, which grows with q beyond a / (1 - beta).
      const double ox = w.obstacle_x[j][k - 1];
      const double oy = w.obstacle_y[j][k - 1];
      const double q = std::sqrt(ox * ox + oy * oy) - reach[k - 1];
      const double mx = relative.x() - ox;
      const double my = relative.y() - oy;
      const double a = reach[k] - reach[k - 1] + std::sqrt(mx * mx + my * my);
      const bool never = (1.0 - beta) * q > a &&
                         (q - a) * (q - a) - beta * q * q > w.barrier_offset[j][k] + kNeverActive;
      if (never) continue;
      first = std::min(first, k);
      last = k;
    }
    for (std::size_t k = first; k <= last; ++k)
      append_row(w.elastic, RowKind::Barrier, j, k);
  }
}

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
  double heading = w.problem->start.heading - w.full_turns;
  double cosine = w.start_cosine;
  double sine = w.start_sine;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const double dx = w.target_x[k + 1] - x;
    const double dy = w.target_y[k + 1] - y;
    const double along = cosine * dx + sine * dy;
    const double across = cosine * dy - sine * dx;
    const double distance = std::sqrt(dx * dx + dy * dy);
    double turn = w.target_heading[k + 1] - heading;
    if (distance > kArrived) turn = along > 0.0 ? across / distance : std::copysign(1.0, across);
    point.linear[k] = limited(0, k, along / (kStepsAhead * dt));
    point.angular[k] = limited(1, k, turn / (kStepsToTurn * dt));
    x += dt * point.linear[k] * cosine;
    y += dt * point.linear[k] * sine;
    heading += dt * point.angular[k];
    cosine = std::cos(heading);
    sine = std::sin(heading);
  }
}

// Among obstacles the middle alone is the better start: a pursuit can lead into a place behind them
// that has no way out.
double cold_inwards(const Workspace& w) noexcept {
  for (std::size_t s = 0; s < w.elastic.num_segments; ++s) {
    if (w.elastic.segments[s].kind == RowKind::Barrier) return 1.0;
  }
  return kPursuitInwards;
}

}  // namespace

void load_problem(const ControlProblem& problem, Workspace& w) noexcept {
  w.problem = &problem;
  w.horizon = static_cast<std::size_t>(problem.horizon);
  w.half_turn = problem.integration == Integration::Midpoint ? 0.5 * problem.dt : 0.0;
  w.full_turns = problem.start.heading - wrap_to_pi(problem.start.heading);
  w.start_cosine = std::cos(problem.start.heading);
  w.start_sine = std::sin(problem.start.heading);
  w.now = &w.points[0];
  w.trial = &w.points[1];
  load_targets(problem, w);
  load_hard_rows(problem, w);
  PoseArray reach;
  find_reach(w, problem.dt, reach);
  w.elastic.count = 0;
  w.elastic.num_segments = 0;
  load_corridor(problem, reach, w);
  load_obstacles(problem, reach, w);
}

void load_guess(const InitialGuess& guess, const Workspace& w, Point& point) noexcept {
  const auto given = static_cast<std::size_t>(std::clamp(guess.count, 0, kMaxHorizon));
  for (std::size_t k = 0; k < w.horizon && given > 0; ++k) {
    const Twist2& command = guess.commands[std::min(k, given - 1)];
    point.linear[k] = command.linear;
    point.angular[k] = command.angular;
  }
  const double inwards = given > 0 ? kInwards : cold_inwards(w);
  if (given == 0) pursue(w, point);
  for (std::size_t j = 0; j < 2; ++j) {
    CommandArray& commands = j == 0 ? point.linear : point.angular;
    const CommandLimits& limits = w.limits[j];
    clip_to_reach(limits, static_cast<int>(w.horizon), commands.data());
    for (std::size_t k = 0; k < w.horizon; ++k) {
      const double middle = 0.5 * (limits.reach_low[k] + limits.reach_high[k]);
      commands[k] += inwards * (middle - commands[k]);
      if (limits.fixed[k]) commands[k] = limits.low[k];
    }
  }
}

}  // namespace fairway::interior_point
