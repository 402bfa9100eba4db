// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/geometry/body_shape.hpp"
#include "fairway/trajectory/drive_reference.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

/// Returns the greatest rate at each row of a drive at which the body obeys the speed limits of
/// zones, with a reserve for deviations; see DriveReference::limit_rate. Empty where none limits
/// the drive.
[[nodiscard]] std::vector<double> zone_rates(const ZoneMap& zones,
                                             const BodyShape& body,
                                             const DriveReference& drive);

}  // namespace fairway
