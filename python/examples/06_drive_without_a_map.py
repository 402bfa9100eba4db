# SPDX-License-Identifier: Apache-2.0
"""Lidar scans go in, velocity commands come out: there is no map."""

import numpy as np

import fairway


def occupied(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """The true world, which the robot does not know: a wall with a gap at its upper end."""
    in_wall = (np.abs(x - 4.0) < 0.1) & (y < 2.5)
    in_hall = (x > -1.0) & (x < 9.0) & (np.abs(y) < 4.0)
    return in_wall | ~in_hall


def measure(pose: tuple) -> np.ndarray:
    """A lidar of 360 beams over a full turn, at the robot's centre."""
    angles = pose[2] - np.pi + np.arange(360) * np.pi / 180
    ranges = np.arange(0.0, 15.0, 0.01)
    hit = occupied(pose[0] + np.outer(np.cos(angles), ranges), pose[1] + np.outer(np.sin(angles), ranges))
    return np.where(hit.any(axis=1), ranges[hit.argmax(axis=1)], np.inf)


settings = fairway.Settings()
settings.robot.radius = 0.25
period = settings.navigation.control_period  # [s]
robot = (0.0, 0.0, 0.0)  # from odometry on a real robot
navigator = fairway.MaplessNavigator(settings, robot[:2])
navigator.set_goal(8, 0)

for cycle in range(600):
    navigator.observe(cycle * period, measure(robot), robot, min_range=0.1, max_range=15.0)
    step = navigator.update(cycle * period, robot)
    if step.status == fairway.NavigationStatus.GoalReached:
        break
    robot = fairway.step(robot, step.command, period)

print(f"{step.status.text}: ({robot[0]:.2f}, {robot[1]:.2f}) in {cycle * period:.1f} s")
assert step.status == fairway.NavigationStatus.GoalReached
