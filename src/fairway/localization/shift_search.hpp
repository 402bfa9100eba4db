// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "fairway/localization/scan_matching.hpp"
#include "fairway/localization/surface_points.hpp"

namespace fairway {

/// Searches the shift of a scan in a direction in which the walls around say nothing, as in a long
/// corridor, by the few points whose surfaces face that direction.
///
/// @param motion  Of the scan about `center`, right but for that shift.
/// @param along   Unit vector.
/// @param reach   Greatest shift [m]; no more than 2 m are searched.
/// @return the shift with which most of these points lie on the map [m]; none if there are too few
///         points, if too few of them fit, or if no shift is clearly the best.
[[nodiscard]] std::optional<double> find_shift(const SurfacePoints& map,
                                               std::span<const SurfacePoint> scan,
                                               const Eigen::Vector2d& center,
                                               const ScanMotion& motion,
                                               const Eigen::Vector2d& along,
                                               double reach) noexcept;

}  // namespace fairway
