// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/simulation/people/moving_body.hpp"

namespace fairway::io {

/// Properties of a recording of people.
struct TracksFormat {
  double frame_rate = 25.0;  ///< frames per second
  double radius = 0.3;       ///< of a person [m]
};

/// Reads tracks of people in the format of the UCY and ETH data. There is one line per person and
/// frame, with eight numbers `frame id x z y vx vz vy` separated by whitespace [m, m/s]. Empty
/// lines are skipped, z and the velocities are ignored, and lines of different people may be
/// interleaved.
///
/// @return One body per person in the order of their ids, named `person ID`, present from its first
///        frame to its last; times count from frame 0 [s].
[[nodiscard]] Expected<std::vector<MovingBody>> read_tracks(const std::string& path,
                                                            const TracksFormat& format = {});

}  // namespace fairway::io
