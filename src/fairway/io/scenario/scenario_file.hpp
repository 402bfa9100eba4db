// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway::io {

/// Reads a scenario and the map that it names.
///
///     map: maps/office.yaml        # relative to this file; a map_server map
///     name: office                 # default: the file's name
///     time_limit: 90               # [s]
///     seed: 1
///     settings: {preset: paper, robot: {radius: 0.3}}    # as in a settings file
///     robots:
///       - {name: amr, start: [0, 0, 1.57], goal: [5, 3]}     # the goal's heading is optional
///         # robot: {kind: car, ...}: its own body and base, see io/scenario/robot_model_file.hpp,
///         # or {file: robots/car.yaml}
///     obstacles:                                             # moving obstacles
///       - {name: person, radius: 0.3, loop: true, key_frames: [[0, 1, 2], [5, 4, 2]]}  # t, x, y
///       # `passing: true`: present only from its first key frame to its last
///     zones:                                                 # see io/scenario/zones_file.hpp
///       - {kind: keep_out, polygon: [[2, 1], [4, 1], [4, 3]]}
///     radio: {on: true, delay: 0.0, loss: 0.0, range: 15.0}  # communication [-, s, -, m]
///     pedestrians:                                           # recorded people
///       tracks: ../people.obsmat.txt   # relative to this file; format: io/tracks_file.hpp
///       frame_rate: 25                 # frames per second
///       radius: 0.3                    # [m]
///       from: 0                        # time in the recording at which the run begins [s]
///
/// Only `map` and `robots` are required. Starts and goals must lie on the map; the run finds out
/// whether the robot fits there.
///
/// Notes what read_map notes, the scenario's own files, and settings under their old names.
[[nodiscard]] Expected<Scenario> read_scenario(const std::string& path, FileNotes* notes = nullptr);

}  // namespace fairway::io
