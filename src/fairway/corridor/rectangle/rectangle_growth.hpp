// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/corridor/rectangle/turned_frame.hpp"

namespace fairway {

/// Lengths and orientations of Algorithm 1.
struct GrowthSettings {
  int num_orientations = 10;  ///< N_c, Eq. (4)
  double growth_step = 0.1;   ///< Delta_L: step by which a side advances [m]
  double max_growth = 8.0;    ///< L_max: greatest distance of a side from the seed [m]
  double start_size = 0.0;    ///< Delta_L0: initial distance of every side from the seed [m]
};

/// Grows a free rectangle around `seed` in several orientations and returns the largest: Algorithm
/// 1 as corrected in docs/paper_notes.md. With one orientation this is SRC [13].
///
/// In each orientation the four sides advance in turn (up, left, down, right), one step at a time.
/// A side stops when the strip that it would gain comes within `clearance` of a blocked cell,
/// leaves the map, or passes max_growth. A side that cannot make a whole step continues by single
/// cells, so at the end no side can advance by another cell. The strip is tested exactly, not
/// sampled. Ties go to the smaller angle; the first orientation is the world's x-axis.
///
/// The growth starts from a part of the obstacles (see greedy_box); only a result that the map
/// confirms counts.
///
/// @param clearance  0 in workspace, the robot's radius in configuration space [m].
/// @return A rectangle for which is_free holds, with seed `seed`; none if the initial rectangle is
///       not free in any orientation, or the seed is not finite.
[[nodiscard]] std::optional<OrientedRectangle> grow_rectangle(
    const BitGrid& obstacles,
    double clearance,
    const Eigen::Vector2d& seed,
    const GrowthSettings& settings) noexcept;

}  // namespace fairway
