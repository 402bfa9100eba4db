# SPDX-License-Identifier: Apache-2.0
"""Drives with a map and settings from files: 10_read_files.py [MAP.yaml SETTINGS.yaml]"""

import pathlib
import sys

import fairway

root = pathlib.Path(__file__).resolve().parents[2]
files = sys.argv[1:] or [f"{root}/scenarios/maps/workshop.yaml", f"{root}/examples/small_carrier.yaml"]
try:
    grid = fairway.Map.read(files[0])
    settings = fairway.Settings.read(files[1])
    settings.navigation.goal_tolerance = 0.05
except ValueError as error:
    sys.exit(f"fairway: {error}")

navigator = fairway.MapNavigator(settings, grid)
navigator.set_goal(22.2, 14.6)
robot = (2.0, 4.4, 0.0)
period = settings.navigation.control_period
for cycle in range(2000):
    step = navigator.update(cycle * period, robot)
    if step.status == fairway.NavigationStatus.GoalReached:
        break
    robot = fairway.step(robot, step.command, period)
print(f"{step.status.text} after {cycle * period:.1f} s along {navigator.plan.length:.1f} m")
assert step.status == fairway.NavigationStatus.GoalReached
