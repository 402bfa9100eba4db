// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway::io {

/// Reads a scenario and the map that it names.
///
///     map: maps/office.yaml        # relative to this file; a map_server map
///     name: office                 # without it the file's name
///     time_limit: 90               # [s]
///     seed: 1
///     settings: {preset: paper, robot: {radius: 0.3}}    # as in a settings file
///     robots:
///       - {name: amr, start: [0, 0, 1.57], goal: [5, 3]}     # a goal's heading may be left out
///     obstacles:                                             # what moves on its own
///       - {name: person, radius: 0.3, loop: true, key_frames: [[0, 1, 2], [5, 4, 2]]}  # t, x, y
///       # `passing: true`: it is there only from its first key frame to its last
///     radio: {on: true, delay: 0.0, loss: 0.0, range: 15.0}  # how robots hear each other [s, -,
///     m] pedestrians:                                           # people as they were recorded
///       tracks: ../people.obsmat.txt   # relative to this file; io/tracks_file.hpp says the format
///       frame_rate: 25                 # frames per second
///       radius: 0.3                    # [m]
///       from: 0                        # where in the recording the run begins [s]
///
/// Only `map` and `robots` are required. Starts and goals must lie on the map; whether a robot fits
/// there is for the run to find out.
///
/// `warnings`, if given, gets what parse_settings says of old names.
[[nodiscard]] Expected<Scenario> read_scenario(const std::string& path,
                                               std::vector<std::string>* warnings = nullptr);

}  // namespace fairway::io
