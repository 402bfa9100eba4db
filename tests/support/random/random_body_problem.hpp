// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "fairway/mpc/body/body_problem.hpp"

namespace fairway::test {

/// Settings of random problems of a rectangular body.
struct BodyProblemKind {
  int horizon = 20;
  int obstacles = 2;
  bool overlap = false;  ///< two rectangles at every step, instead of during a part of the horizon
};

/// Seeded problems: a rectangular body drives from one rectangle into the next, which is turned
/// against it. Rear vertices are in the first rectangle, front vertices in the second one, cut
/// points in both. Moving obstacles cross. Not all problems are feasible.
class RandomBodyProblems {
 public:
  explicit RandomBodyProblems(std::uint64_t seed) : engine_(seed) {}

  template <typename Motion>
  BodyProblem<Motion> next(const BodyProblemKind& kind) {
    BodyProblem<Motion> problem;
    problem.horizon = kind.horizon;
    problem.start = {.position = point(5.0), .heading = uniform(-3.0, 3.0)};
    set_limits(problem);
    set_body(problem);
    set_corridor(problem, kind);
    set_obstacles(problem, kind.obstacles);
    return problem;
  }

  // The numbers of std::uniform_real_distribution differ between standard libraries.
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }

 private:
  Eigen::Vector2d point(double reach) {
    const double x = uniform(-reach, reach);
    return {x, uniform(-reach, reach)};
  }

  void set_limits(BodyProblem<UnicycleMotion>& problem) {
    problem.input_min = {-0.5, -1.0};
    problem.input_max = {1.0, 1.0};
    problem.max_change = {0.1, 0.2};
    problem.previous_input = {uniform(-0.1, 0.6), uniform(-0.2, 0.2)};
    problem.num_input_limits = 2;  // both wheels
    for (std::size_t i = 0; i < 2; ++i)
      problem.input_limits[i] = {.normal = {1.0, i == 0 ? 0.4 : -0.4}, .bound = 1.2};
  }
  void set_limits(BodyProblem<SteeredMotion>& problem) {
    problem.motion.wheelbase = uniform(0.6, 1.2);
    problem.input_min = {-0.5, -1.2};
    problem.input_max = {1.0, 1.2};
    problem.max_change = {0.1, 0.12};
    problem.previous_input = {uniform(-0.1, 0.6), uniform(-0.2, 0.2)};
  }
  void set_limits(BodyProblem<OmniMotion>& problem) {
    problem.input_min = {-0.5, -0.5, -1.0};
    problem.input_max = {1.0, 0.5, 1.0};
    problem.max_change = {0.1, 0.1, 0.2};
    problem.previous_input = {uniform(-0.2, 0.5), uniform(-0.2, 0.2), uniform(-0.3, 0.3)};
    problem.num_input_limits = 4;  // the wheels of a mecanum base
    for (std::size_t i = 0; i < 4; ++i)
      problem.input_limits[i] = {
          .normal = {1.0, (i & 1U) != 0 ? 1.0 : -1.0, (i & 2U) != 0 ? 0.6 : -0.6}, .bound = 1.1};
  }

  template <typename Motion>
  void set_body(BodyProblem<Motion>& problem) {
    length_ = uniform(0.8, 1.6);
    width_ = uniform(0.5, 0.8);
    rear_ = -uniform(0.2, 0.5) * length_;
    const double front = rear_ + length_;
    const double middle = 0.5 * (rear_ + front);
    const double half = 0.5 * width_;
    problem.num_points = 6;
    problem.points = {Eigen::Vector2d(rear_, -half),  Eigen::Vector2d(rear_, half),
                      Eigen::Vector2d(front, -half),  Eigen::Vector2d(front, half),
                      Eigen::Vector2d(middle, -half), Eigen::Vector2d(middle, half),
                      Eigen::Vector2d::Zero(),        Eigen::Vector2d::Zero()};
    for (std::size_t i = 0; i < 6; ++i)
      problem.insets[i] = motion_inset(problem.points[i], 1.0, 1.0, problem.dt);
    problem.num_discs = 3;
    for (std::size_t i = 0; i < 3; ++i)
      problem.discs[i] = {.center = {rear_ + length_ * (static_cast<double>(i) + 0.5) / 3.0, 0.0},
                          .radius = std::hypot(length_ / 6.0, half)};
  }

  // The first rectangle contains the body. The second one begins inside of it and is turned; or,
  // with `overlap`, it contains the body too.
  template <typename Motion>
  void set_corridor(BodyProblem<Motion>& problem, const BodyProblemKind& kind) {
    constexpr std::uint8_t kRear = 0b110011;
    constexpr std::uint8_t kFront = 0b111100;
    constexpr std::uint8_t kAll = 0b111111;
    const double front = rear_ + length_;
    const double turn = kind.overlap ? uniform(-0.15, 0.15) : uniform(-0.8, 0.8);
    const OrientedRectangle first = {
        .seed = problem.start.position,
        .orientation = problem.start.heading + uniform(-0.1, 0.1),
        .min = {rear_ - 0.4, -0.5 * width_ - uniform(0.2, 0.6)},
        .max = {front + uniform(0.5, 1.5), 0.5 * width_ + uniform(0.2, 0.6)}};
    const Eigen::Vector2d corner = first.to_world({0.7 * first.max.x(), 0.0});
    const double behind = kind.overlap ? corner_distance(problem.start, corner) + 1.5 : 1.2;
    const OrientedRectangle second = {.seed = corner,
                                      .orientation = first.orientation + turn,
                                      .min = {-behind, -0.5 * width_ - uniform(0.3, 0.7)},
                                      .max = {3.0, 0.5 * width_ + uniform(0.3, 0.7)}};
    const double speed = uniform(0.3, 0.9);
    const double to_corner = corner_distance(problem.start, corner);
    bool switching = false;
    for (int k = 1; k <= problem.horizon; ++k) {
      const double travelled = speed * problem.dt * k;
      const double share = std::clamp((travelled - to_corner) / length_ + 0.8, 0.0, 1.0);
      const Pose2 target = {
          .position = travelled < to_corner
                          ? Eigen::Vector2d(problem.start.position +
                                            travelled * direction(first.orientation))
                          : Eigen::Vector2d(corner + (travelled - to_corner) *
                                                         direction(second.orientation)),
          .heading = first.orientation + share * turn};
      problem.targets[static_cast<std::size_t>(k)] = {
          .position = target.position, .heading = target.heading, .weight = {20.0, 20.0, 0.5}};
      switching = switching || holds(problem, second, target, kFront);
      BodyRegion& region = problem.regions[static_cast<std::size_t>(k)];
      if (kind.overlap || (switching && !holds(problem, second, target, kAll))) {
        region = {.rectangles = {first, second}, .points = {kRear, kFront}, .count = 2};
      } else {
        region.rectangles[0] = switching ? second : first;
        region.points[0] = kAll;
        region.count = 1;
      }
    }
  }

  static double corner_distance(const Pose2& start, const Eigen::Vector2d& corner) {
    return (corner - start.position).norm();
  }

  // Whether the rectangle contains these points of the body at a pose, with 3 cm to spare.
  template <typename Motion>
  static bool holds(const BodyProblem<Motion>& problem,
                    const OrientedRectangle& rectangle,
                    const Pose2& pose,
                    std::uint8_t points) {
    for (int i = 0; i < problem.num_points; ++i) {
      if ((points >> i & 1) != 0 &&
          !rectangle.contains(transform(pose, problem.points[static_cast<std::size_t>(i)]), -0.03))
        return false;
    }
    return true;
  }

  template <typename Motion>
  void set_obstacles(BodyProblem<Motion>& problem, int count) {
    problem.num_obstacles = count;
    for (int j = 0; j < count; ++j) {
      const double distance = uniform(1.6, 3.0);
      const Eigen::Vector2d place =
          problem.start.position + distance * direction(uniform(-3.14, 3.14));
      const Eigen::Vector2d velocity = point(0.6);
      for (int k = 0; k <= problem.horizon; ++k) {
        const auto at = static_cast<std::size_t>(k);
        PredictedObstacle& obstacle = problem.obstacles[static_cast<std::size_t>(j)];
        obstacle.position[at] = place + problem.dt * k * velocity;
        obstacle.keep_out[at] = 0.35;
      }
    }
  }

  std::mt19937_64 engine_;
  double length_ = 1.0, width_ = 0.5, rear_ = -0.5;
};

}  // namespace fairway::test
