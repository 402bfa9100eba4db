# SPDX-License-Identifier: Apache-2.0
"""Crosses a hall while a person walks across the robot's path."""

import numpy as np

import fairway

scenario = fairway.Scenario(fairway.Map.from_array(np.zeros((160, 200), np.int8), 0.05))
scenario.add_robot(start=(1, 4, 0), goal=(9, 4), name="amr")
scenario.add_obstacle([(0, 5, 7.5), (7, 5, 0.5)], name="person")  # time, x, y

result = fairway.simulate(scenario)
robot = result.robots[0]
print(f"{'arrived' if result.success else 'did not arrive'} after {robot.time:.1f} s, "
      f"at least {robot.min_separation:.2f} m from the person")
assert result.success
