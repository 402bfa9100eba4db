// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/io/drawing/plot_axes.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway::io {

/// Draws the polygons of zones, each kind in its own style.
void draw_zones(Canvas& canvas, const PlotAxes& axes, const Zones& zones);

/// Adds one legend entry for each kind of zone.
void add_zone_entries(std::vector<LegendEntry>& entries, const Zones& zones);

}  // namespace fairway::io
