// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fairway/simulation/robot_driver.hpp"

namespace fairway::campaign {

/// How far the pose that a robot on a known map uses is from the truth.
struct PoseError {
  double driven = 0.0;    // [m]
  double greatest = 0.0;  // of the position [m]
  double square = 0.0;    // sum over the cycles of its square [m^2]
  std::uint64_t cycles = 0;

  /// Without a map the pose is in a frame of its own, and does not count.
  /// @param interval  From the last cycle to this one [s].
  void look(const World& world, const DrivenCycle& cycle, double interval) {
    const UnicycleRobot& robot = world.robots().front();
    const double error = (cycle.input.pose.position - robot.pose.position).norm();
    greatest = std::max(greatest, error);
    square += error * error;
    driven += std::abs(robot.twist.linear) * interval;
    ++cycles;
  }

  [[nodiscard]] bool diverged() const {
    constexpr double kDiverged = 0.3;  // [m]
    return greatest > kDiverged;
  }
};

/// The errors of all runs.
struct PoseErrors {
  PoseError sum;
  std::vector<std::uint64_t> diverged;

  void add(std::uint64_t run, const PoseError& one) {
    sum.driven += one.driven;
    sum.greatest = std::max(sum.greatest, one.greatest);
    sum.square += one.square;
    sum.cycles += one.cycles;
    if (one.diverged()) diverged.push_back(run);
  }

  [[nodiscard]] double root_mean_square() const {
    return std::sqrt(sum.square / static_cast<double>(std::max<std::uint64_t>(1, sum.cycles)));
  }
};

}  // namespace fairway::campaign
