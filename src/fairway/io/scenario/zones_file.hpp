// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/base/error.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway::io {

class YamlMapping;

/// Reads the list `zones` of a mapping; empty for a missing key.
///
///     zones:
///       - {kind: keep_out, polygon: [[2, 1], [4, 1], [4, 3]], name: pit}   # [m]
///       - {kind: speed_limit, polygon: [...], speed: 0.4}                  # [m/s]
///       - {kind: penalty, polygon: [...], weight: 4}     # a metre costs 1 + weight
///       - {kind: preferred, polygon: [...], weight: 1}   # a metre elsewhere costs 1 + weight
///       - {kind: strip, polygon: [...], reference: centre}     # or contour
///       - {kind: one_way, polygon: [...], direction: 1.57}     # [rad]
///
/// `reference` says whether keep-outs, speed limits and strips hold for the centre of the robot or
/// for its contour. The default is contour, and for strips centre. `weight` may be left out.
[[nodiscard]] Zones read_zones(YamlMapping& root);

/// Reads a file with such a list.
[[nodiscard]] Expected<Zones> read_zones_file(const std::string& path);

}  // namespace fairway::io
