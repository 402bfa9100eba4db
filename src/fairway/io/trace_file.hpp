// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/simulation/episode.hpp"

namespace fairway::io {

/// A run as CSV: a header line, then one line per robot and control cycle.
///
/// The first columns are time [s], robot (its name), x, y [m], heading [rad], linear [m/s], angular
/// [rad/s] and status. The motion is measured at that time. Then follow command_linear and
/// command_angular as sent for the cycle, limit (the limiting factor), rectangle (index in its
/// corridor) and clearance [m]. Numbers have nine digits.
[[nodiscard]] std::string trace_csv(const EpisodeResult& episode);

}  // namespace fairway::io
