// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// A narrow leg from a robot beside the strip of its first leg to the line of that leg; none if the
/// robot is in the strip, or too far from the first node.
[[nodiscard]] std::optional<RouteLeg> approach_to(const RouteLeg& leg,
                                                  const Eigen::Vector2d& robot);

}  // namespace fairway::vda5050
