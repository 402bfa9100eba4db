// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/map/bit_grid.hpp"
#include "fairway/navigation/corridor_string.hpp"

namespace fairway {

/// How far along the string a disc of `radius` stays free, at most `limit` [m].
///
/// In steps of 0.1 m, so it may be up to that much less than the truth, never more. A disc that is
/// not free at the start is taken as large as it fits there: the robot stands there, after all.
[[nodiscard]] double free_length(const BitGrid& obstacles,
                                 const StringAhead& string,
                                 double radius,
                                 double limit) noexcept;

}  // namespace fairway
