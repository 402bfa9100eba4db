# SPDX-License-Identifier: Apache-2.0
"""Says why there is no path: where the best route is too narrow, by how much, and for which robot."""

import numpy as np

import fairway

# Two rooms with one door of 0.4 m. The robot needs 0.5 m.
cells = np.zeros((80, 160), np.int8)
cells[:, 80] = 100
cells[36:44, 80] = 0
planner = fairway.Planner(fairway.Map.from_array(cells, resolution=0.05))
start = (1, 2)
plan = planner.plan(start, (7, 2))

gap = planner.find_obstruction(start, plan)
assert not plan.usable and gap is not None
x, y = gap.position
print(f"{gap.kind} at ({x:.2f}, {y:.2f}): {gap.found:.2f} m, {gap.needed:.2f} m needed")
print(planner.explain(start, plan))

# A smaller robot fits.
settings = fairway.Settings()
settings.robot.radius = 0.15
slim = fairway.plan(fairway.Map.from_array(cells, resolution=0.05), start, (7, 2), settings)
print(f"with a radius of 0.15 m the path is {slim.length:.2f} m long")
assert slim.usable
