# SPDX-License-Identifier: Apache-2.0
import os
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ._fairway import Rectangle
from .settings import Settings
from .statuses import SolveStatus

__all__ = ["Problem", "Solution", "Solver", "read_problems", "solve", "step"]

_Numbers = Sequence[float] | npt.NDArray[np.generic]
_Array = npt.NDArray[np.float64]

class Problem:
    """One optimal control problem, Eq. (15) of the paper."""

    dt: float
    integration: str
    start: _Numbers
    command_min: _Numbers
    command_max: _Numbers
    previous_command: _Numbers
    max_change: _Numbers
    stop_at_end: bool
    penalise_first_change: bool
    barrier_retention: float
    violation_weight: float
    command_weight: _Numbers
    change_weight: _Numbers
    targets: Any  # an array of N x 3; anything that NumPy converts to one can be assigned
    target_weights: Any  # the same, or one row for all steps
    def __init__(
        self, horizon: int = 10, dt: float = 0.1, integration: str = "midpoint"
    ) -> None: ...
    @staticmethod
    def from_settings(settings: Settings, last_command: _Numbers = (0.0, 0.0)) -> Problem: ...
    @property
    def horizon(self) -> int: ...
    @property
    def num_obstacles(self) -> int: ...
    def set_region(self, step: int, rectangles: Sequence[Rectangle]) -> None: ...
    def set_corridor(self, rectangle: Rectangle) -> None: ...
    def add_obstacle(self, positions: npt.ArrayLike, keep_out: float) -> None: ...

class Solution:
    """The result of a solver: finite, and within the hard constraints."""

    @property
    def status(self) -> SolveStatus: ...
    @property
    def iterations(self) -> int: ...
    @property
    def cost(self) -> float: ...
    @property
    def max_violation(self) -> float: ...
    @property
    def sum_violation(self) -> float: ...
    @property
    def limiting(self) -> tuple[str, int, int]: ...
    @property
    def commands(self) -> _Array: ...
    @property
    def poses(self) -> _Array: ...

class Solver:
    """The real-time interior-point solver; keeps its memory between problems."""

    def __init__(self, settings: Settings | None = None) -> None: ...
    def solve(self, problem: Problem, guess: npt.ArrayLike | None = None) -> Solution: ...

def solve(
    problem: Problem, guess: npt.ArrayLike | None = None, settings: Settings | None = None
) -> Solution: ...
def step(
    pose: _Numbers, command: _Numbers, dt: float, integration: str = "midpoint"
) -> tuple[float, float, float]: ...
def read_problems(path: str | os.PathLike[str]) -> list[Problem]: ...
