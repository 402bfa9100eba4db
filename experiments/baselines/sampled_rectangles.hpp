// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway::baselines {

/// Which samples are tested when a side has advanced.
enum class Sampling : std::uint8_t {
  Strip,  ///< the whole strip gained, every half cell, as SRC [13] does
  Edge,   ///< only the new edge, once per cell (FSRC [14], Eq. (7)): may jump over obstacles
};

/// Growth of a workspace rectangle by samples, as published. It is for comparison only, since a
/// sampled rectangle may contain obstacles.
struct SampledGrowth {
  Sampling sampling = Sampling::Edge;
  int num_orientations = 10;  ///< N_c; 1 for SRC and FSRC
  double growth_step = 0.1;   ///< Delta_L [m]
  double max_growth = 8.0;    ///< L_max [m]
};

/// Algorithm 1 with its flags reset for every orientation and "or" in its stop test. It does not
/// work without these two changes. A failed step is undone. None when the seed is blocked.
[[nodiscard]] std::optional<OrientedRectangle> grow_sampled(const BitGrid& obstacles,
                                                            const Eigen::Vector2d& seed,
                                                            const SampledGrowth& settings);

/// Algorithm 2 as printed, with a finite loop. A point outside the last rectangle (not contracted)
/// makes the point before it a seed; the goal always gets a rectangle. Contracted rectangles may
/// not overlap.
[[nodiscard]] std::vector<OrientedRectangle> build_sampled(const BitGrid& obstacles,
                                                           const Path& path,
                                                           const SampledGrowth& settings);

}  // namespace fairway::baselines
