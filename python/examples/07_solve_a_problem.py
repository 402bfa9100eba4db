# SPDX-License-Identifier: Apache-2.0
"""The solver alone: one optimal control problem, then the next one from the shifted answer."""

import numpy as np

import fairway

problem = fairway.Problem(horizon=20, dt=0.1)
problem.start = (0, 0, 0)
problem.max_change = (0.2, 0.4)  # linear and angular, per step
k = np.arange(21)
problem.targets = np.column_stack([0.1 * k, 0 * k, 0 * k])[1:]  # x, y, heading
problem.target_weights = (20, 20, 0.5)
problem.set_corridor(fairway.Rectangle(min=(-1, -1), max=(6, 1.5)))
# Comes towards the robot at 0.5 m/s.
problem.add_obstacle(np.column_stack([2.5 - 0.05 * k, np.full(21, 0.2)]), keep_out=0.6)

solver = fairway.Solver()
first = solver.solve(problem)
print(f"cold: {first.status.text} after {first.iterations} iterations, cost {first.cost:.2f}, "
      f"first command {first.commands[0, 0]:.2f} m/s {first.commands[0, 1]:.2f} rad/s")

problem.start = first.poses[1]
problem.previous_command = first.commands[0]
following = solver.solve(problem, guess=first.commands[1:])
print(f"warm: {following.status.text} after {following.iterations} iterations")
assert first.status == fairway.SolveStatus.Solved
