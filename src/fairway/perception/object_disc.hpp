// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace fairway {

inline constexpr double kSmallestRadius = 0.1;   ///< of an object [m]
inline constexpr std::size_t kFewestPoints = 3;  ///< that determine a disc
inline constexpr std::size_t kFewestRound = 6;   ///< of which its shape is known

/// The disc that represents an object of which one side was seen.
struct ObjectDisc {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< [m]
  bool round = false;   ///< whether the points lie on its outline; if not, it is a guess
};

/// Finds the disc of a cluster of points in the order of their beams. The result is none for too
/// few points, and for clusters larger than `object_size` [m].
[[nodiscard]] std::optional<ObjectDisc> disc_of(std::span<const Eigen::Vector2d> points,
                                                const Eigen::Vector2d& sensor,
                                                double object_size) noexcept;

/// Finds where the points of two round objects that overlap meet, if they are that: both parts then
/// lie on outlines of discs, which the whole cluster does not.
/// @return the number of points of the first object.
[[nodiscard]] std::optional<std::size_t> find_waist(std::span<const Eigen::Vector2d> points,
                                                    const Eigen::Vector2d& sensor,
                                                    double object_size) noexcept;

}  // namespace fairway
