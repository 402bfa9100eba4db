# SPDX-License-Identifier: Apache-2.0
"""Corridors alone: rectangles along a path of your own, kept up to date when the map changes."""

import numpy as np

import fairway

cells = np.zeros((160, 240), np.int8)
cells[:80, 120] = 100
path = [(1, 1), (4, 5), (8, 5), (11, 1)]
settings = fairway.Settings()
settings.robot.radius = 0.3

builder = fairway.CorridorBuilder(settings)
result = builder.build(fairway.Map.from_array(cells, 0.05), path)
print(f"{result.reason}: {len(result.corridor)} rectangles")
for r in result.corridor.rectangles:
    print(f"  seed ({r.seed[0]:.2f}, {r.seed[1]:.2f}), turned by {r.orientation:.2f} rad, {r.area:.1f} m^2")

# A pallet appears beside the path; only the cells of this block may have changed.
cells[112:121, 100:109] = 100
result = builder.update(fairway.Map.from_array(cells, 0.05), first=(112, 100), last=(120, 108))
print(f"{result.reason} after the change: {len(result.corridor)} rectangles")
assert result.built
