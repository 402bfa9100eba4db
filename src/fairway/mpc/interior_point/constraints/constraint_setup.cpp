// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/constraints/constraint_setup.hpp"

#include <algorithm>
#include <cmath>

namespace fairway::interior_point {
namespace {

// Constraints that stay this far from violation are left out [m or m^2].
constexpr double kNeverActive = 1e-6;
// Value of the padding of a constraint with less than four steps.
constexpr double kNoConstraint = 1.0;

// Computes the greatest distance of pose k from the start, over all commands.
void find_reach(const Workspace& w, double dt, PoseArray& reach) noexcept {
  const CommandLimits& limits = w.limits[kLinear];
  double low = limits.previous;
  double high = limits.previous;
  reach[0] = 0.0;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    low = std::max(limits.low[k], low - limits.max_change);
    high = std::min(limits.high[k], high + limits.max_change);
    reach[k + 1] = reach[k] + dt * std::max(std::abs(low), std::abs(high));
  }
}

// A rectangle relative to a pose: its axis, the start in its frame, and its extent; or no
// rectangle.
struct RectangleFrame {
  double axis_x = 0.0, axis_y = 0.0;
  double along = 0.0, across = 0.0;
  double min_along = -kNoConstraint, max_along = kNoConstraint;
  double min_across = -kNoConstraint, max_across = kNoConstraint;
};
using FourRectangles = std::array<RectangleFrame, kLanes>;

// Collects one number from each of four steps in a register. Loading a vector right after storing
// its parts would be slow.
template <typename Step>
FAIRWAY_LANES Lanes128 gathered(const std::array<Step, kLanes>& four,
                                double Step::*member) noexcept {
  return {four[0].*member, four[1].*member, four[2].*member, four[3].*member};
}

FAIRWAY_LANES FourRectangles rectangles_of(const ControlProblem& problem,
                                           std::size_t slot,
                                           std::size_t first,
                                           RectangleAxis& axis) noexcept {
  FourRectangles four;
  const auto horizon = static_cast<std::size_t>(problem.horizon);
  const Eigen::Vector2d& origin = problem.start.position;
  for (std::size_t k = first; k < std::min(first + kLanes, horizon + 1); ++k) {
    const StepRegion& region = problem.regions[k];
    if (static_cast<std::size_t>(region.count) <= slot) continue;
    const OrientedRectangle& rectangle = region.rectangles[slot];
    const Eigen::Vector2d& along = axis.of(rectangle.orientation);
    const double x = origin.x() - rectangle.seed.x();
    const double y = origin.y() - rectangle.seed.y();
    four[k - first] = {.axis_x = along.x(),
                       .axis_y = along.y(),
                       .along = along.x() * x + along.y() * y,
                       .across = along.x() * y - along.y() * x,
                       .min_along = rectangle.min.x(),
                       .max_along = rectangle.max.x(),
                       .min_across = rectangle.min.y(),
                       .max_across = rectangle.max.y()};
  }
  return four;
}

FAIRWAY_LANES SoftConstraintBlock& append_constraint(ConstraintKind kind,
                                                     std::size_t index,
                                                     std::size_t first,
                                                     Workspace& w) noexcept {
  SoftConstraintBlock& constraint = w.soft_constraints[w.num_soft_constraints++];
  constraint.kind = kind;
  constraint.index = static_cast<int>(index);
  constraint.first_step = static_cast<int>(first);
  return constraint;
}

// Adds the sides of the rectangles of one slot, for the poses from `first` on.
FAIRWAY_LANES void load_corridor(const FourRectangles& four,
                                 std::size_t slot,
                                 std::size_t first,
                                 const PoseArray& reach,
                                 double near,
                                 Workspace& w) noexcept {
  const auto add = [&](std::size_t side, const Lanes128& x, const Lanes128& y,
                       const Lanes128& offset) {
    const Lanes128 margin = offset - lanes<Lanes128>(reach, first);
    if (least_of(margin) > kNeverActive) return;
    SoftConstraintBlock& constraint =
        append_constraint(ConstraintKind::Corridor, 4 * slot + side, first, w);
    constraint.offset = offset;
    constraint.normal_x = x;
    constraint.normal_y = y;
    constraint.near = Lanes128(near);
  };
  const Lanes128 axis_x = gathered(four, &RectangleFrame::axis_x);
  const Lanes128 axis_y = gathered(four, &RectangleFrame::axis_y);
  const Lanes128 along = gathered(four, &RectangleFrame::along);
  const Lanes128 across = gathered(four, &RectangleFrame::across);
  add(0, axis_x, axis_y, along - gathered(four, &RectangleFrame::min_along));
  add(1, -axis_x, -axis_y, gathered(four, &RectangleFrame::max_along) - along);
  add(2, -axis_y, axis_x, across - gathered(four, &RectangleFrame::min_across));
  add(3, axis_y, -axis_x, gathered(four, &RectangleFrame::max_across) - across);
}

// Bounds of the roots of four numbers, computed from the root of the first. They are tight if the
// numbers differ little.
struct RootBounds {
  Lanes128 least, most;
};
FAIRWAY_LANES RootBounds root_bounds(const Lanes128& squares) noexcept {
  constexpr double kLeastRoot = 1e-9;
  const double root = std::max(std::sqrt(squares[0]), kLeastRoot);
  const Lanes128 most = 0.5 * (squares / root + root);
  return {.least = squares / most, .most = most};
}

// Returns whether some admissible commands could violate a barrier constraint.
FAIRWAY_LANES bool is_needed(const SoftConstraintBlock& constraint,
                             std::size_t count,
                             const Lanes128& reach,
                             const Lanes128& reach_before) noexcept {
  // With q = |p_{k-1} - o_{k-1}| and |p_k - o_k| >= q - a, the constraint is at least
  // (q - a)^2 - beta q^2 - offset, which grows with q beyond a / (1 - beta).
  const Lanes128 x = constraint.centre_before_x;
  const Lanes128 y = constraint.centre_before_y;
  const Lanes128 retention = constraint.retention;
  const Lanes128 move_x = constraint.centre_x - x;
  const Lanes128 move_y = constraint.centre_y - y;
  const Lanes128 q = root_bounds(x * x + y * y).least - reach_before;
  const Lanes128 a = reach - reach_before + root_bounds(move_x * move_x + move_y * move_y).most;
  const Lanes128 margin = (q - a) * (q - a) - retention * q * q - constraint.offset - kNeverActive;
  const Lanes128 never = least(margin, (1.0 - retention) * q - a);
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (!(never[lane] > 0.0)) return true;
  }
  return false;
}

// Position of an obstacle at the time of a pose.
struct Place {
  double x = 0.0, y = 0.0, keep_out = 0.0;
};

// Adds one obstacle, for the poses from `first` on.
FAIRWAY_LANES void load_barrier(const ControlProblem& problem,
                                std::size_t j,
                                std::size_t first,
                                const PoseArray& reach,
                                double near,
                                Workspace& w) noexcept {
  const PredictedObstacle& obstacle = problem.obstacles[j];
  const double beta = problem.barrier_retention;
  const std::size_t count = std::min(kLanes, w.horizon + 1 - first);
  const auto place = [&](std::size_t k) -> Place {
    if (k > w.horizon) return {};
    return {.x = obstacle.position[k].x() - problem.start.position.x(),
            .y = obstacle.position[k].y() - problem.start.position.y(),
            .keep_out = obstacle.keep_out[k]};
  };
  std::array<Place, kLanes> now;
  std::array<Place, kLanes> before;
  std::array<double, kLanes> there{};
  before[0] = place(first - 1);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    now[lane] = place(first + lane);
    if (lane > 0) before[lane] = lane < count ? now[lane - 1] : Place{};
    there[lane] = lane < count ? 1.0 : 0.0;
  }
  const Lanes128 is_there{there[0], there[1], there[2], there[3]};
  const Lanes128 keep_out = gathered(now, &Place::keep_out);
  const Lanes128 keep_out_before = gathered(before, &Place::keep_out);
  SoftConstraintBlock& constraint = w.soft_constraints[w.num_soft_constraints];
  constraint.centre_x = gathered(now, &Place::x);
  constraint.centre_y = gathered(now, &Place::y);
  constraint.centre_before_x = gathered(before, &Place::x);
  constraint.centre_before_y = gathered(before, &Place::y);
  const Lanes128 retention = beta * is_there;
  constraint.retention = retention;
  constraint.offset = keep_out * keep_out - retention * keep_out_before * keep_out_before -
                      kNoConstraint * (1.0 - is_there);
  constraint.near = near * (2.0 * keep_out + near) * is_there;
  if (is_needed(constraint, count, lanes<Lanes128>(reach, first),
                lanes<Lanes128>(reach, first - 1)))
    append_constraint(ConstraintKind::Barrier, j, first, w);
}

}  // namespace

void load_soft_constraints(const ControlProblem& problem, Workspace& w) noexcept {
  PoseArray reach{};
  find_reach(w, problem.dt, reach);
  std::array<RectangleAxis, kMaxRectanglesPerStep> axes;
  const double near = near_distance(problem);
  w.num_soft_constraints = 0;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    w.model.now[b] = {};
    const std::size_t first = kLanes * b + 1;
    ConstraintRange& range = w.constraint_ranges[b];
    range.corridor = range.watched_corridor = w.num_soft_constraints;
    for (std::size_t slot = 0; slot < kMaxRectanglesPerStep; ++slot)
      load_corridor(rectangles_of(problem, slot, first, axes[slot]), slot, first, reach, near, w);
    range.barrier = range.watched_barrier = w.num_soft_constraints;
    for (std::size_t j = 0; j < static_cast<std::size_t>(problem.num_obstacles); ++j)
      load_barrier(problem, j, first, reach, near, w);
    range.end = w.num_soft_constraints;
  }
}

}  // namespace fairway::interior_point
