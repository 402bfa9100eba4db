// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/simulation/moving_body.hpp"

namespace fairway::io {

/// How people were recorded.
struct TracksFormat {
  double frame_rate = 25.0;  ///< frames per second
  double radius = 0.3;       ///< of a person [m]
};

/// Reads the tracks of people as the UCY and ETH data have them: a line for each person and frame,
/// of eight numbers `frame id x z y vx vz vy` with blanks between them [m, m/s]. Empty lines are
/// skipped, z and the velocities are not used, and the lines of different people may be mixed.
///
/// @return A body for each person in the order of their ids, named `person ID`, that is there from
///         its first frame to its last; times count from frame 0 [s].
[[nodiscard]] Expected<std::vector<MovingBody>> read_tracks(const std::string& path,
                                                            const TracksFormat& format = {});

}  // namespace fairway::io
