// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "fairway/map/bit_grid.hpp"
#include "fairway/navigation/corridor_string.hpp"
#include "fairway/prediction/shared_motion.hpp"

namespace fairway {

/// Length on `string` up to where it meets the way of `other` against its direction in a place too
/// narrow to pass each other: neither to the left nor to the right has the robot room to move over
/// by both bodies [m]. Infinite if it does not within 6 m.
/// @param radius  Of the disc that covers the robot [m].
[[nodiscard]] double length_to_narrow_meeting(const StringAhead& string,
                                              const SharedMotion& other,
                                              double radius,
                                              const BitGrid& obstacles) noexcept;

/// Whether a robot at `place` is out of the way of `other`, and not where it stands.
[[nodiscard]] bool lets_pass(const Eigen::Vector2d& place,
                             const SharedMotion& other,
                             double radius) noexcept;

/// The place in `room` nearest to `position` from where all of `others` can be let pass, among a
/// grid of 15 x 15 places within 4 m and the position itself; none if there is none.
/// @param others  Entries that are null are skipped.
[[nodiscard]] std::optional<Eigen::Vector2d> passing_place(
    const OrientedRectangle& room,
    const Eigen::Vector2d& position,
    std::span<const SharedMotion* const> others,
    double radius) noexcept;

}  // namespace fairway
