// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway::baselines {

/// What is sampled when a side has advanced.
enum class Sampling : std::uint8_t {
  Strip,  ///< the whole strip gained, every half cell, as SRC [13] does
  Edge,   ///< only the new edge, once per cell, as FSRC [14] and Eq. (7) do: may hop over obstacles
};

/// Growth of a rectangle in the workspace by samples, as published: for comparison only, since a
/// sampled rectangle may hold obstacles.
struct SampledGrowth {
  Sampling sampling = Sampling::Edge;
  int num_orientations = 10;  ///< N_c; 1 for SRC and FSRC
  double growth_step = 0.1;   ///< Delta_L [m]
  double max_growth = 8.0;    ///< L_max [m]
};

/// Algorithm 1 with its flags reset for every orientation and "or" in its stop test; without these
/// two changes it does not work at all. A failed step is undone. None when the seed is blocked.
[[nodiscard]] std::optional<OrientedRectangle> grow_sampled(const BitGrid& obstacles,
                                                            const Eigen::Vector2d& seed,
                                                            const SampledGrowth& settings);

/// Algorithm 2 as printed, with its loop made finite: a point outside the last rectangle (not
/// contracted) makes the point before it a seed; the goal always gets a rectangle. Nothing makes
/// sure that contracted rectangles meet.
[[nodiscard]] std::vector<OrientedRectangle> build_sampled(const BitGrid& obstacles,
                                                           const Path& path,
                                                           const SampledGrowth& settings);

}  // namespace fairway::baselines
