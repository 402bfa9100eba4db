// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/monitor/safety_monitor.hpp"

namespace fairway::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

inline Polygon box(double back, double front, double half_width) {
  return {{back, -half_width}, {front, -half_width}, {front, half_width}, {back, half_width}};
}

// A body from -0.3 to 0.3 m that is 0.4 m wide.
inline MonitorSettings plain() { return {.footprint = {box(-0.3, 0.3, 0.2)}}; }

}  // namespace fairway::test
