// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/simulation/episode.hpp"

namespace fairway::io {

/// A run as CSV: a header line, then a row per robot and control cycle.
///
/// Columns: time [s], robot (its name), x, y [m], heading [rad], linear [m/s] and angular [rad/s]
/// as driven at that time, status, then command_linear and command_angular as sent for the cycle,
/// limit (what holds the robot back most), rectangle (index in its corridor), clearance [m]. Nine
/// digits.
[[nodiscard]] std::string trace_csv(const EpisodeResult& episode);

}  // namespace fairway::io
