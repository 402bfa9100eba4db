# SPDX-License-Identifier: Apache-2.0
"""A map goes in, velocity commands come out."""

import numpy as np

import fairway

cells = np.zeros((120, 200), np.int8)
cells[:80, 100] = 100
grid = fairway.Map.from_array(cells, resolution=0.05)

settings = fairway.Settings()
period = settings.navigation.control_period  # [s]
navigator = fairway.MapNavigator(settings, grid)
navigator.set_goal(9, 1)
robot = (1.0, 1.0, 0.0)  # x, y, heading

for cycle in range(600):
    step = navigator.update(cycle * period, robot)
    if step.status == fairway.NavigationStatus.GoalReached:
        break
    robot = fairway.step(robot, step.command, period)  # your robot base goes here

print(f"{step.status.text}: ({robot[0]:.2f}, {robot[1]:.2f}) in {cycle * period:.1f} s")
assert step.status == fairway.NavigationStatus.GoalReached
