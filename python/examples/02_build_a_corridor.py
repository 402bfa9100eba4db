# SPDX-License-Identifier: Apache-2.0
"""Covers a path with rectangles by two methods: the paper's, and the fewest."""

import numpy as np

import fairway

cells = np.zeros((300, 400), np.int8)
i = np.arange(150)
cells[40 + i, 100 + i] = 100
grid = fairway.Map.from_array(cells, resolution=0.05)

settings = fairway.Settings()
for method in ("mdsrc", "fewest"):
    settings.corridor.method = method
    plan = fairway.plan(grid, (2, 4), (16, 3), settings)
    assert plan.usable, plan.reason
    print(f"{method:6}: {len(plan.rectangles)} rectangles, "
          f"{plan.corridor.mean_area:.1f} m^2 on average")
