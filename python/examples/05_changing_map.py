# SPDX-License-Identifier: Apache-2.0
"""A door closes while the robot drives to it, and later another one opens. A thread makes the plans."""

import numpy as np

import fairway
from fairway import NavigationStatus

settings = fairway.Settings()
settings.planning.background = True
settings.navigation.patience = 30.0  # [s] without progress
cells = np.zeros((160, 240), np.int8)
cells[:, 120] = 100
cells[40:64, 120] = 0

navigator = fairway.MapNavigator(settings, fairway.Map.from_array(cells, 0.05))
navigator.set_goal(10.5, 2.5)
robot = (1.5, 2.5, 0.0)
last = None
period = settings.navigation.control_period
for cycle in range(900):
    if cycle == 20:
        cells[40:64, 120] = 100
    if cycle == 80:
        cells[100:124, 120] = 0
    if cycle in (20, 80):
        navigator.update_map(fairway.Map.from_array(cells, 0.05), (0, 119), (159, 121))

    step = navigator.update(cycle * period, robot)
    robot = fairway.step(robot, step.command, period)
    navigator.wait_for_plan()  # only because this loop is faster than real time
    if step.status != last:
        last = step.status
        print(f"{cycle * period:5.1f} s  ({robot[0]:.2f}, {robot[1]:.2f})  "
              f"{step.status.text}: {step.limit.text}")
    if step.status in (NavigationStatus.GoalReached, NavigationStatus.GaveUp):
        break
assert step.status == NavigationStatus.GoalReached
