# SPDX-License-Identifier: Apache-2.0
"""Wheels err by 3 % and by half a degree per metre; scans keep the pose in the map."""

import math

import numpy as np

import fairway

# A hall of 12 m x 8 m with walls and four pillars.
rows, columns = np.mgrid[:160, :240]
wall = (columns < 2) | (columns > 237) | (rows < 2) | (rows > 157)
pillar = (columns // 12 % 6 == 4) & (rows // 12 % 5 == 2)
cells = np.where(wall | pillar, 100, 0).astype(np.int8)
grid = fairway.Map.from_array(cells, resolution=0.05)


def measure(sensor):
    """A lidar of 360 beams all round, at the robot's centre."""
    angles = sensor[2] + np.radians(np.arange(-180, 180))
    distances = np.arange(0.0, 15.0, 0.01)
    x = ((sensor[0] + np.outer(np.cos(angles), distances)) / 0.05).astype(int)
    y = ((sensor[1] + np.outer(np.sin(angles), distances)) / 0.05).astype(int)
    hit = cells[np.clip(y, 0, 159), np.clip(x, 0, 239)] != 0
    return distances[hit.argmax(axis=1)]


settings = fairway.Settings()
period = settings.navigation.control_period  # [s]
truth = (1.5, 1.5, 0.0)
odometry = (0.0, 0.0, 0.0)  # of the wheels, in a frame of its own
localization = fairway.MapLocalization(grid)
localization.set_pose(odometry, truth)
navigator = fairway.MapNavigator(settings, grid)
navigator.set_goal(10.5, 6.5)

for cycle in range(600):
    localization.observe(cycle * period, measure(truth), odometry, min_range=0.1, max_range=15.0)
    found = localization.locate(odometry)
    step = navigator.update(cycle * period, found.pose)
    if step.status == fairway.NavigationStatus.GoalReached:
        break
    driven = (1.03 * step.linear, step.angular + 0.01 * step.linear)
    truth = fairway.step(truth, step.command, period)
    odometry = fairway.step(odometry, driven, period)

off = math.dist(found.pose[:2], truth[:2])
sigma = math.sqrt(np.trace(found.covariance[:2, :2]))
print(f"reached ({truth[0]:.2f}, {truth[1]:.2f}) in {cycle * period:.1f} s; the pose is off by {off:.3f} m, sigma {sigma:.3f} m")
assert step.status == fairway.NavigationStatus.GoalReached
assert off < 0.05
