// SPDX-License-Identifier: Apache-2.0
// What options a pilot accepts.
#include <string>

#include "bridge/pilot.hpp"

namespace fairway::bridge {

Expected<void> validate(const PilotOptions& options) {
  if (!options.use_map && !options.use_scan) {
    return fail("use_map, use_scan: expected one of them true, found both false");
  }
  if (!(options.patience > 0.0)) {
    return fail("patience: expected a positive number, found " + std::to_string(options.patience));
  }
  if (!(options.localisation_timeout > 0.0)) {
    return fail("localisation_timeout: expected a positive number, found " +
                std::to_string(options.localisation_timeout));
  }
  const bool zones = !options.monitor_stop_zone.empty() || !options.monitor_slow_zone.empty();
  const bool watched = options.use_monitor && options.use_scan &&
                       (!options.body || options.body->base.kind == BaseKind::Unicycle);
  if (zones && !watched) {
    return fail(
        "monitor_stop_zone, monitor_slow_zone: expected a robot that the safety monitor checks: "
        "with scans, and no body or one of kind unicycle");
  }
  const MonitorSettings zones_alone{.footprint = {{{0, 0}, {1, 0}, {0, 1}}},
                                    .stop_zone = options.monitor_stop_zone,
                                    .slow_zone = options.monitor_slow_zone,
                                    .slow_speed = options.monitor_slow_speed};
  if (!fairway::validate(zones_alone)) {
    return fail(
        "monitor_stop_zone, monitor_slow_zone, monitor_slow_speed: expected polygons whose corners "
        "differ, and a speed from 0.01 to 10 m/s");
  }
  return {};
}

}  // namespace fairway::bridge
