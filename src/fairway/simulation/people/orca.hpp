// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

namespace fairway {

/// A walking person, as ORCA needs it.
struct OrcaAgent {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();   ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();   ///< now [m/s]
  Eigen::Vector2d preferred = Eigen::Vector2d::Zero();  ///< velocity without other people [m/s]
  double radius = 0.3;                                  ///< of its own body, as it assumes it [m]
  double speed_max = 1.0;                               ///< [m/s]
};

/// Another person, as an agent sees it.
struct OrcaNeighbour {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< now [m/s]
  double radius = 0.3;                                 ///< as the agent assumes it [m]
};

/// How far an agent looks.
struct OrcaSettings {
  double neighbour_distance = 10.0;  ///< people at this distance or further are ignored [m]
  std::size_t neighbours_max = 10;   ///< only the nearest so many count
  double horizon = 5.0;              ///< velocities are free of contact for this long [s]
  double step = 0.25;                ///< length of a step [s]
};

/// Returns the velocity that a person chooses for the next step, by optimal reciprocal collision
/// avoidance. The method is that of van den Berg, Guy, Lin and Manocha (2011), as the library RVO2
/// computes it.
///
/// Each neighbour forbids a half-plane of velocities. The result is the velocity nearest to the
/// preferred one in the disc of `speed_max` and in all half-planes. If there is none, it is the
/// velocity that violates the half-planes least, where later half-planes give in to earlier ones.
/// Neighbours at the same distance keep the order in which they are given.
[[nodiscard]] Eigen::Vector2d orca_velocity(const OrcaAgent& agent,
                                            std::span<const OrcaNeighbour> neighbours,
                                            const OrcaSettings& settings);

}  // namespace fairway
