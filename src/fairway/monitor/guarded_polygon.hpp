// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/monitor/safety_monitor.hpp"

namespace fairway {

/// Whether the corners can be those of a polygon: at least three, finite, each unlike the next.
[[nodiscard]] bool is_polygon(const Polygon& polygon) noexcept;

/// The distance of a point from the border of a polygon, negative inside [m].
[[nodiscard]] double signed_distance(const Polygon& polygon, const Eigen::Vector2d& point) noexcept;

}  // namespace fairway
