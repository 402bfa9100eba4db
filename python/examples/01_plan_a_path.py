# SPDX-License-Identifier: Apache-2.0
"""Finds a path for a disc robot around a wall, and requests one that does not exist."""

import numpy as np

import fairway

cells = np.zeros((80, 120), np.int8)
cells[:60, 60] = 100
planner = fairway.Planner(fairway.Map.from_array(cells, resolution=0.1))

found = planner.plan((1, 1), (11, 1))
print(f"{found.path_status.text}: {len(found.path)} waypoints, {found.length:.2f} m")

none = planner.plan((1, 1), (6.05, 3))
print(f"into the wall: {none.reason}")
assert found.usable and not none.usable
