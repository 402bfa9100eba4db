// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point/body/body_setup.hpp"
#include "fairway/mpc/interior_point/constraints/constraint_setup.hpp"

namespace fairway::interior_point {
namespace {

constexpr double kNeverViolated = 1e-6;  // constraints that stay this far away are left out
constexpr double kPadding = 1.0;         // value of the padding of a constraint
constexpr double kNearSteps = 2.0;       // constraints are watched beyond this many steps

// Greatest speeds of the base at one step.
struct Speeds {
  double translation = 0.0;  // [m/s]
  double turn = 0.0;         // [rad/s]
};

double greatest_of_range(double low, double high) noexcept {
  return std::max(std::abs(low), std::abs(high));
}
Speeds speeds(const UnicycleMotion& /*motion*/,
              const Eigen::Vector2d& low,
              const Eigen::Vector2d& high) noexcept {
  return {greatest_of_range(low[0], high[0]), greatest_of_range(low[1], high[1])};
}
Speeds speeds(const SteeredMotion& motion,
              const Eigen::Vector2d& low,
              const Eigen::Vector2d& high) noexcept {
  const double speed = greatest_of_range(low[0], high[0]);
  return {speed, speed / motion.wheelbase};
}
Speeds speeds(const OmniMotion& /*motion*/,
              const Eigen::Vector3d& low,
              const Eigen::Vector3d& high) noexcept {
  return {std::hypot(greatest_of_range(low[0], high[0]), greatest_of_range(low[1], high[1])),
          greatest_of_range(low[2], high[2])};
}

// Greatest translation and turn until pose k.
struct Reach {
  PoseArray translation{}, turn{};
  double near_translation = 0.0, near_turn = 0.0;

  [[nodiscard]] double of(double radius, std::size_t k) const noexcept {
    return translation[k] + radius * turn[k];
  }
  [[nodiscard]] double near(double radius) const noexcept {
    return near_translation + radius * near_turn;
  }
};

template <typename Motion>
void find_body_reach(const BodyWorkspace<Motion>& w, Reach& reach) noexcept {
  const BodyProblem<Motion>& problem = *w.problem;
  typename Motion::Input low = problem.previous_input;
  typename Motion::Input high = problem.previous_input;
  for (std::size_t k = 0; k < kLanes * w.num_blocks; ++k) {
    if (k < w.horizon) {
      low = w.input_bounds.low[k].cwiseMax(low - problem.max_change);
      high = w.input_bounds.high[k].cwiseMin(high + problem.max_change);
    }
    const Speeds most = speeds(problem.motion, low, high);
    reach.translation[k + 1] = reach.translation[k] + problem.dt * most.translation;
    reach.turn[k + 1] = reach.turn[k] + problem.dt * most.turn;
  }
  const Speeds most = speeds(problem.motion, problem.input_min, problem.input_max);
  reach.near_translation = kNearSteps * problem.dt * most.translation;
  reach.near_turn = kNearSteps * problem.dt * most.turn;
}

template <typename Motion>
BodyConstraintBlock& append_body_constraint(const BodyConstraintName& name,
                                            std::size_t mark,
                                            BodyWorkspace<Motion>& w) noexcept {
  BodyConstraintBlock& constraint = w.soft_constraints[w.num_soft_constraints++];
  constraint.name = name;
  constraint.mark = mark;
  return constraint;
}

// A rectangle relative to the start: its axis, and the place of the start in its frame.
struct BodyFrame {
  Eigen::Vector2d axis{0.0, 0.0};
  Eigen::Vector2d start{0.0, 0.0};
  Eigen::Vector2d min{0.0, 0.0}, max{0.0, 0.0};
  unsigned points = 0;  // bit i: point i must be inside
};

template <typename Motion>
BodyFrame frame_of(const BodyProblem<Motion>& problem,
                   std::size_t slot,
                   std::size_t k,
                   RectangleAxis& axes) noexcept {
  const BodyRegion& region = problem.regions[k];
  if (static_cast<std::size_t>(region.count) <= slot) return {};
  const OrientedRectangle& r = region.rectangles[slot];
  const Eigen::Vector2d axis = axes.of(r.orientation);
  const Eigen::Vector2d from_seed = problem.start.position - r.seed;
  return {.axis = axis,
          .start = {axis.dot(from_seed), axis.x() * from_seed.y() - axis.y() * from_seed.x()},
          .min = r.min,
          .max = r.max,
          .points = region.points[slot]};
}

// Adds one side of four rectangles for one point: the constraints from `name` on.
template <typename Motion>
void load_side(const std::array<BodyFrame, kLanes>& frames,
               const BodyConstraintName& name,
               const Reach& reach,
               BodyWorkspace<Motion>& w) noexcept {
  const auto point = static_cast<std::size_t>(name.part);
  const auto first = static_cast<std::size_t>(name.step);
  const Eigen::Vector2d at_start(w.points[0].marks[point].x[0], w.points[0].marks[point].y[0]);
  const double radius = w.marks[point].norm();
  const bool across = name.index % 4 >= 2;
  const bool upper = name.index % 2 == 1;
  Pack4d offset{{kPadding, kPadding, kPadding, kPadding}};
  Pack4d x{};
  Pack4d y{};
  bool needed = false;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const BodyFrame& frame = frames[lane];
    if ((frame.points >> point & 1U) == 0) continue;
    const auto i = static_cast<Eigen::Index>(across);
    const double sign = upper ? -1.0 : 1.0;
    const Eigen::Vector2d normal =
        sign * (across ? Eigen::Vector2d(-frame.axis.y(), frame.axis.x()) : frame.axis);
    x[lane] = normal.x();
    y[lane] = normal.y();
    offset[lane] = (upper ? frame.max[i] - frame.start[i] : frame.start[i] - frame.min[i]) -
                   w.problem->insets[point];
    needed = needed || !(offset[lane] + normal.dot(at_start) - reach.of(radius, first + lane) >
                         kNeverViolated);
  }
  if (!needed) return;
  BodyConstraintBlock& c = append_body_constraint(name, point, w);
  c.offset = offset;
  c.normal_x = x;
  c.normal_y = y;
  c.near = Lanes128(reach.near(radius));
}

// Returns whether some admissible inputs could violate an obstacle constraint. With q the distance
// before the step, and at least q - a after it, the constraint is at least
// (q - a)^2 - beta q^2 - offset, which grows with q beyond a / (1 - beta).
bool is_obstacle_needed(double q, double a, double beta, double offset) noexcept {
  const double margin = (q - a) * (q - a) - beta * q * q - offset - kNeverViolated;
  return !(std::min(margin, (1.0 - beta) * q - a) > 0.0);
}

// Adds one obstacle and one disc of the body, for the poses from `first` on.
template <typename Motion>
void load_obstacle(std::size_t j,
                   std::size_t disc,
                   std::size_t first,
                   const Reach& reach,
                   BodyWorkspace<Motion>& w) noexcept {
  const BodyProblem<Motion>& problem = *w.problem;
  const PredictedObstacle& obstacle = problem.obstacles[j];
  const std::size_t mark = static_cast<std::size_t>(problem.num_points) + disc;
  const Eigen::Vector2d at_start(w.points[0].marks[mark].x[0], w.points[0].marks[mark].y[0]);
  const double disc_radius = problem.discs[disc].radius;
  const double radius = w.marks[mark].norm();
  const double near = reach.near(radius);
  const double beta = problem.barrier_retention;
  BodyConstraintBlock c;
  bool needed = false;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const std::size_t k = first + lane;
    c.offset[lane] = -kPadding;
    c.near[lane] = c.retention[lane] = 0.0;
    c.center_x[lane] = c.center_y[lane] = c.center_before_x[lane] = c.center_before_y[lane] = 0.0;
    if (k > w.horizon) continue;
    const Eigen::Vector2d center = obstacle.position[k] - problem.start.position;
    const Eigen::Vector2d before = obstacle.position[k - 1] - problem.start.position;
    const double keep_out = obstacle.keep_out[k] + disc_radius;
    const double keep_out_before = obstacle.keep_out[k - 1] + disc_radius;
    c.center_x[lane] = center.x();
    c.center_y[lane] = center.y();
    c.center_before_x[lane] = before.x();
    c.center_before_y[lane] = before.y();
    c.retention[lane] = beta;
    c.offset[lane] = keep_out * keep_out - beta * keep_out_before * keep_out_before;
    c.near[lane] = near * (2.0 * keep_out + near);
    const double reached = reach.of(radius, k - 1);
    needed = needed || is_obstacle_needed((at_start - before).norm() - reached,
                                          reach.of(radius, k) - reached + (center - before).norm(),
                                          beta, c.offset[lane]);
  }
  if (!needed) return;
  BodyConstraintBlock& constraint = append_body_constraint({.kind = ConstraintKind::Barrier,
                                                            .step = static_cast<int>(first),
                                                            .index = static_cast<int>(j),
                                                            .part = static_cast<int>(disc)},
                                                           mark, w);
  c.name = constraint.name;
  c.mark = constraint.mark;
  constraint = c;
}

template <typename Motion>
void load_sides(std::size_t slot,
                std::size_t first,
                const Reach& reach,
                RectangleAxis& axis,
                BodyWorkspace<Motion>& w) noexcept {
  std::array<BodyFrame, kLanes> frames;
  unsigned points = 0;
  for (std::size_t lane = 0; lane < kLanes && first + lane <= w.horizon; ++lane) {
    frames[lane] = frame_of(*w.problem, slot, first + lane, axis);
    points |= frames[lane].points;
  }
  for (std::size_t point = 0; point < static_cast<std::size_t>(w.problem->num_points); ++point) {
    if ((points >> point & 1U) == 0) continue;
    for (std::size_t side = 0; side < 4; ++side) {
      const BodyConstraintName name = {.kind = ConstraintKind::Corridor,
                                       .step = static_cast<int>(first),
                                       .index = static_cast<int>(4 * slot + side),
                                       .part = static_cast<int>(point)};
      load_side(frames, name, reach, w);
    }
  }
}

}  // namespace

template <typename Motion>
void load_body_constraints(const BodyProblem<Motion>& problem, BodyWorkspace<Motion>& w) noexcept {
  Reach reach;
  std::array<RectangleAxis, kMaxRectanglesPerStep> axes;
  find_body_reach(w, reach);
  w.num_soft_constraints = 0;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    w.model.now[b] = {};
    const std::size_t first = kLanes * b + 1;
    ConstraintRange& range = w.constraint_ranges[b];
    range.corridor = range.watched_corridor = w.num_soft_constraints;
    for (std::size_t slot = 0; slot < kMaxRectanglesPerStep; ++slot)
      load_sides(slot, first, reach, axes[slot], w);
    range.barrier = range.watched_barrier = w.num_soft_constraints;
    for (std::size_t j = 0; j < static_cast<std::size_t>(problem.num_obstacles); ++j) {
      for (std::size_t disc = 0; disc < static_cast<std::size_t>(problem.num_discs); ++disc)
        load_obstacle(j, disc, first, reach, w);
    }
    range.end = w.num_soft_constraints;
  }
}

template void load_body_constraints(const BodyProblem<UnicycleMotion>&,
                                    BodyWorkspace<UnicycleMotion>&) noexcept;
template void load_body_constraints(const BodyProblem<SteeredMotion>&,
                                    BodyWorkspace<SteeredMotion>&) noexcept;
template void load_body_constraints(const BodyProblem<OmniMotion>&,
                                    BodyWorkspace<OmniMotion>&) noexcept;

}  // namespace fairway::interior_point
