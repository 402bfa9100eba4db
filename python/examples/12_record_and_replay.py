# SPDX-License-Identifier: Apache-2.0
"""Records a run while callbacks watch it, and runs its navigators again."""

import pathlib
import tempfile

import numpy as np

import fairway

scenario = fairway.Scenario(fairway.Map.from_array(np.zeros((160, 200), np.int8), 0.05))
scenario.add_robot(start=(1, 4, 0), goal=(9, 4))
scenario.add_obstacle([(0, 5, 7.5), (7, 5, 0.5)])
scenario.sensing, scenario.noise = "lidar", "standard"


def on_plan(time: float, robot: int, plan: fairway.Plan) -> None:
    print(f"{time:5.1f} s  robot {robot} follows a path of {plan.length:.2f} m")


with tempfile.TemporaryDirectory() as folder:
    log = pathlib.Path(folder) / "run.mcap"
    episode = fairway.simulate(scenario, on_plan=on_plan, log=log)
    again = fairway.replay(log)
trace = episode.trace  # a structured array: trace["time"], trace["x"], ...
print(f"{again.cycles} cycles, the same to the bit: {again.same}; "
      f"greatest speed {trace['linear'].max():.2f} m/s")
assert episode.success and again.same
