# SPDX-License-Identifier: Apache-2.0
"""Three robots whose paths cross publish what they intend, and each drives around the others."""

import math

import numpy as np

import fairway

settings = fairway.Settings()
period = settings.navigation.control_period  # [s]
grid = fairway.Map.from_array(np.zeros((200, 200), np.int8), 0.05)
starts = [(1.0, 5.0), (8.0, 1.5), (8.0, 8.5)]
goals = [(9.0, 5.0), (2.0, 8.5), (2.0, 1.5)]
poses = [(*s, math.atan2(g[1] - s[1], g[0] - s[0])) for s, g in zip(starts, goals)]
robots = [fairway.MapNavigator(settings, grid) for _ in starts]
for robot, goal in zip(robots, goals):
    robot.set_goal(*goal)
messages = [robot.share(i, 0.0, poses[i]) for i, robot in enumerate(robots)]

for cycle in range(600):
    time, arrived = cycle * period, 0
    for i, robot in enumerate(robots):
        others = messages[:i] + messages[i + 1:]
        step = robot.update(time, poses[i], fleet=others, robot=i)
        messages[i] = robot.share(i, time, poses[i])
        poses[i] = fairway.step(poses[i], step.command, period)
        arrived += step.status == fairway.NavigationStatus.GoalReached
    if arrived == len(robots):
        break
print(f"{arrived} arrived after {time:.1f} s")
assert arrived == len(robots)
