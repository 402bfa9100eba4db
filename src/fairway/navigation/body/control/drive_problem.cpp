// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/control/drive_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/navigation/body/control/motion_input.hpp"

namespace fairway {

using Eigen::Vector2d;

namespace {

// Discs along the longer axis of a box that cover it.
template <typename Motion>
void cover_box(const Vector2d& low, const Vector2d& high, BodyProblem<Motion>& problem) noexcept {
  const Vector2d size = high - low;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const double along = size[axis];
  const double across = size[1 - axis];
  const int count = std::clamp(static_cast<int>(std::ceil(2.0 * along / across)), 1, kMaxBodyDiscs);
  const double step = along / count;
  problem.num_discs = count;
  for (int i = 0; i < count; ++i) {
    Vector2d center = 0.5 * (low + high);
    center[axis] = low[axis] + (i + 0.5) * step;
    problem.discs[static_cast<std::size_t>(i)] = {.center = center,
                                                  .radius = 0.5 * std::hypot(step, across)};
  }
}

// Discs along the longer axis of another robot, on the motion that is expected of it.
template <typename Motion>
void add_member(const DriveView& view,
                const FleetMember& member,
                BodyProblem<Motion>& problem) noexcept {
  constexpr double kMemberMargin = 0.1;  // [m]
  constexpr int kMostDiscs = 3;
  const SharedMotion& other = *member.motion;
  const double reach =
      view.clearance->body().circumscribed_radius() + other.radius +
      problem.dt * problem.horizon * (problem.input_max.cwiseAbs().maxCoeff() + other.speed_max);
  if ((other.position - view.start.position).norm() > reach) return;
  const Vector2d size = other.outline.high - other.outline.low;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const int count =
      other.outline.is_box
          ? std::clamp(static_cast<int>(std::ceil(size[axis] / size[1 - axis])), 1, kMostDiscs)
          : 1;
  const double step = size[axis] / count;
  for (int i = 0; i < count && problem.num_obstacles < kMaxObstacles; ++i) {
    Vector2d center = Vector2d::Zero();
    double radius = other.radius;
    if (other.outline.is_box) {
      center = 0.5 * (other.outline.low + other.outline.high);
      center[axis] = other.outline.low[axis] + (i + 0.5) * step;
      radius = 0.5 * std::hypot(step, size[1 - axis]);
    }
    PredictedObstacle& predicted =
        problem.obstacles[static_cast<std::size_t>(problem.num_obstacles++)];
    for (int k = 0; k <= problem.horizon; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Pose2 pose = expected_pose(member, *view.moving, view.delay + k * problem.dt);
      predicted.position[at] = transform(pose, center);
      predicted.keep_out[at] = radius + kMemberMargin;
    }
  }
}

}  // namespace

template <typename Motion>
void set_robot(const BaseModel& base,
               const BodyShape& body,
               const MpcSettings& mpc,
               BodyProblem<Motion>& problem) noexcept {
  // Longer steps than those of a disc: a robot with a body looks further ahead in time. The first
  // input is sent again in each period, so its change is limited by what is sent.
  constexpr double kStep = 2.0;  // step lengths
  constexpr double kTie = 1e-3;  // of a weight: a drive that is on time costs nothing
  problem.horizon = mpc.horizon;
  problem.dt = kStep * mpc.step_length;
  set_base(base, problem);
  const double changes = std::min(mpc.weight_linear_change, mpc.weight_angular_change);
  problem.input_weight.setConstant(kTie * std::min(mpc.weight_linear, mpc.weight_angular));
  problem.change_weight.setConstant(changes);
  problem.penalise_first_change = mpc.penalise_first_change;
  problem.barrier_retention = std::exp(-mpc.decay_rate * problem.dt);
  problem.violation_weight = mpc.violation_weight;
  for (StepTarget& target : problem.targets)
    target.weight = {mpc.weight_position, mpc.weight_position, mpc.weight_heading};
  cover_box(body.low(), body.high(), problem);
  const SlicedBody sliced = SlicedBody::of(body.low(), body.high());
  problem.num_points = static_cast<int>(sliced.points.size());
  std::copy(sliced.points.begin(), sliced.points.end(), problem.points.begin());
}

template <typename Motion>
void set_targets(const DriveView& view, BodyProblem<Motion>& problem) noexcept {
  problem.start = view.start;
  problem.previous_input = solver_input<Motion>(view.sent);
  const DriveReference& drive = *view.drive;
  const double stop = view.space->stop_after(view.progress.phase);
  DriveProgress now = view.progress;
  double heading = view.start.heading;
  for (int k = 1; k <= problem.horizon; ++k) {
    now = drive.advanced(now, 1.0, problem.dt, 0.5 * problem.dt);
    const Pose2 pose = drive.pose_at(std::min(now.phase, stop));
    heading += shortest_turn(heading, pose.heading);
    StepTarget& target = problem.targets[static_cast<std::size_t>(k)];
    target.position = pose.position;
    target.heading = heading;
  }
}

template <typename Motion>
bool set_regions(const DriveView& view,
                 const HorizonPhases& phases,
                 double margin,
                 BodyProblem<Motion>& problem) noexcept {
  constexpr std::array<std::uint8_t, 2> kParts{0b001111, 0b111100};  // with both cut points
  constexpr std::uint8_t kVertices = 0b110011;
  const BitGrid& obstacles = view.clearance->obstacles();
  const auto& links = view.space->corridor.links;
  BodyCorridor::Pair tested{links.size(), links.size()};
  double turn = 0.0;
  for (int k = 1; k <= problem.horizon; ++k) {
    const double phase = phases[static_cast<std::size_t>(k)];
    const auto pair = view.space->at(phase);
    if (!pair) return false;
    // The map may have changed since the drive was planned.
    for (const std::size_t link : *pair) {
      if (link == tested[0] || link == tested[1]) continue;
      if (!is_free(obstacles, links[link].rectangle, 0.0)) return false;
      tested = {tested[1], link};
    }
    BodyRegion& region = problem.regions[static_cast<std::size_t>(k)];
    const bool whole = (*pair)[0] == (*pair)[1];
    region.count = whole ? 1 : 2;
    for (std::size_t part = 0; part < static_cast<std::size_t>(region.count); ++part) {
      region.rectangles[part] = links[(*pair)[part]].rectangle;
      region.points[part] = whole ? kVertices : kParts[part];
    }
    const Pose2 now = view.drive->pose_at(phase);
    const Pose2 next = view.drive->pose_at(phase + problem.dt);
    turn = std::max(turn, std::abs(shortest_turn(now.heading, next.heading)) / problem.dt);
  }
  const double speed = problem.input_max.template head<1>()[0];
  for (int i = 0; i < problem.num_points; ++i) {
    const auto at = static_cast<std::size_t>(i);
    problem.insets[at] = margin + motion_inset(problem.points[at], speed, turn, problem.dt);
  }
  return true;
}

template <typename Motion>
void set_obstacles(const DriveView& view, BodyProblem<Motion>& problem) noexcept {
  const MovingSurroundings& moving = *view.moving;
  const PredictionSettings& prediction = moving.prediction;
  constexpr double kLeastStop = 1.5;  // [s]
  constexpr double kReaction = 0.5;   // before a stop [s]
  constexpr double kWide = 0.1;       // beyond the distance that is kept in any case [m]
  const double braking = problem.max_change[0] / problem.dt;
  struct Near {
    double apart = std::numeric_limits<double>::infinity();
    const MovingObstacle* obstacle = nullptr;
  };
  std::array<Near, kMaxObstacles> nearest;
  std::size_t count = 0;
  const auto nearer = [](const Near& a, const Near& b) { return a.apart < b.apart; };
  const double horizon = view.delay + problem.dt * problem.horizon;
  const double own = problem.input_max.cwiseAbs().maxCoeff() * horizon;
  for (const MovingObstacle& obstacle : moving.obstacles) {
    const double apart = (obstacle.position - view.start.position).norm() - obstacle.radius -
                         view.clearance->body().circumscribed_radius();
    if (apart > own + obstacle.velocity.norm() * (horizon + std::abs(moving.age)) + 1.0) continue;
    if (count == nearest.size() && apart >= nearest.back().apart) continue;
    if (count < nearest.size()) ++count;
    nearest[count - 1] = {.apart = apart, .obstacle = &obstacle};
    std::sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearer);
  }
  // A robot also stays out of where obstacles go while it stops: otherwise the proof of a stop
  // would fail before it is past them.
  const PlanarTwist twist = problem.motion.twist(problem.previous_input);
  const double stops =
      std::max(kLeastStop, kReaction + std::hypot(twist.linear, twist.lateral) / braking);
  problem.num_obstacles = 0;
  const auto add = [&](const MovingObstacle& obstacle, double later) {
    if (problem.num_obstacles >= kMaxObstacles) return;
    PredictedObstacle& predicted =
        problem.obstacles[static_cast<std::size_t>(problem.num_obstacles++)];
    for (int k = 0; k <= problem.horizon; ++k) {
      const double ahead = moving.age + view.delay + k * problem.dt + later;
      const double growth = is_standing(obstacle)
                                ? 0.0
                                : std::min(prediction.obstacle_growth_max,
                                           prediction.obstacle_growth * std::max(ahead, 0.0));
      const auto at = static_cast<std::size_t>(k);
      predicted.position[at] =
          prediction.predict_motion ? predicted_position(obstacle, ahead) : obstacle.position;
      predicted.keep_out[at] = obstacle.radius + prediction.obstacle_margin + growth + kWide;
    }
  };
  for (std::size_t i = 0; i < count; ++i)
    add(*nearest[i].obstacle, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_standing(*nearest[i].obstacle) && prediction.predict_motion)
      add(*nearest[i].obstacle, stops);
  }
  for (const FleetMember& member : moving.fleet)
    add_member(view, member, problem);
}

#define FAIRWAY_INSTANTIATE(Motion)                                               \
  template void set_robot(const BaseModel&, const BodyShape&, const MpcSettings&, \
                          BodyProblem<Motion>&) noexcept;                         \
  template void set_targets(const DriveView&, BodyProblem<Motion>&) noexcept;     \
  template bool set_regions(const DriveView&, const HorizonPhases&, double,       \
                            BodyProblem<Motion>&) noexcept;                       \
  template void set_obstacles(const DriveView&, BodyProblem<Motion>&) noexcept;

FAIRWAY_INSTANTIATE(UnicycleMotion)
FAIRWAY_INSTANTIATE(SteeredMotion)
FAIRWAY_INSTANTIATE(OmniMotion)
#undef FAIRWAY_INSTANTIATE

}  // namespace fairway
