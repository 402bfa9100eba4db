# SPDX-License-Identifier: Apache-2.0
import os
from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt

from ._fairway import Map, Plan, Step
from .settings import Settings
from .statuses import NavigationStatus

__all__ = [
    "BarnScore",
    "BarnWorld",
    "Episode",
    "Replay",
    "RobotResult",
    "RunControl",
    "Scenario",
    "jackal_settings",
    "read_barn",
    "replay",
    "simulate",
]

_Numbers = Sequence[float] | npt.NDArray[np.generic]
_Array = npt.NDArray[np.float64]
_Pose = tuple[float, float, float]
_OnPlan = Callable[[float, int, Plan], object]
_OnStep = Callable[[float, int, _Pose, tuple[float, float], Step], object]

class Scenario:
    """Everything that a simulated run depends on: equal scenarios give equal bits."""

    name: str
    map: Map
    settings: Settings
    time_limit: float
    seed: int
    sensing: str
    noise: str
    def __init__(self, map: Map, settings: Settings | None = None) -> None: ...
    @staticmethod
    def read(path: str | os.PathLike[str]) -> Scenario: ...
    def add_robot(self, start: _Numbers, goal: _Numbers, name: str = "robot") -> None: ...
    def add_obstacle(
        self,
        key_frames: npt.ArrayLike,
        radius: float = 0.3,
        name: str = "person",
        loop: bool = False,
        passing: bool = False,
    ) -> None: ...
    @property
    def robots(self) -> list[tuple[str, _Pose, tuple[float, ...]]]: ...
    @property
    def num_obstacles(self) -> int: ...

class RobotResult:
    """The result of one robot."""

    @property
    def name(self) -> str: ...
    @property
    def reached(self) -> bool: ...
    @property
    def collided(self) -> bool: ...
    @property
    def time(self) -> float: ...
    @property
    def length(self) -> float: ...
    @property
    def min_clearance(self) -> float: ...
    @property
    def min_separation(self) -> float: ...
    @property
    def cycles(self) -> int: ...
    @property
    def status_counts(self) -> dict[NavigationStatus, int]: ...
    @property
    def cycle_seconds(self) -> _Array: ...
    @property
    def solve_seconds(self) -> _Array: ...
    @property
    def plan(self) -> Plan: ...

class Episode:
    """The result of a whole run."""

    @property
    def success(self) -> bool: ...
    @property
    def time(self) -> float: ...
    @property
    def robots(self) -> list[RobotResult]: ...
    @property
    def trace(self) -> npt.NDArray[np.void]: ...

class RunControl:
    """The run as a callback of `simulate` sees it, during the call only."""

    @property
    def time(self) -> float: ...
    @property
    def poses(self) -> _Array: ...
    @property
    def obstacles(self) -> _Array: ...
    def set_goal(self, robot: int, goal: _Numbers) -> None: ...
    def set_cells(self, cells: npt.ArrayLike, blocked: bool) -> None: ...
    def set_obstacle(
        self, index: int, key_frames: npt.ArrayLike, radius: float = 0.3, loop: bool = False
    ) -> None: ...
    def remove_obstacle(self, index: int) -> None: ...
    def set_settings(self, settings: Settings) -> None: ...

class Replay:
    """What running a recording again has shown."""

    @property
    def cycles(self) -> int: ...
    @property
    def different(self) -> int: ...
    @property
    def same(self) -> bool: ...
    @property
    def first_difference(self) -> tuple[float, int, Step, Step] | None: ...

class BarnWorld:
    """One world of the BARN or DynaBARN dataset."""

    @property
    def number(self) -> int: ...
    @property
    def map(self) -> Map: ...
    @property
    def start(self) -> _Pose: ...
    @property
    def goal(self) -> tuple[float, float]: ...
    @property
    def optimal_time(self) -> float: ...
    def scenario(
        self,
        settings: Settings | None = None,
        sensing: str = "map",
        seed: int = 1,
        trial: int = 0,
    ) -> Scenario: ...
    def score(self, trial: int, result: Episode) -> BarnScore: ...

class BarnScore:
    """Proxy scores: not from Gazebo and not comparable with official BARN results."""

    @property
    def world(self) -> int: ...
    @property
    def trial(self) -> int: ...
    @property
    def success(self) -> bool: ...
    @property
    def collided(self) -> bool: ...
    @property
    def time(self) -> float: ...
    @property
    def score(self) -> float: ...

def simulate(
    scenario: Scenario,
    *,
    on_cycle: Callable[[float], bool | None] | None = None,
    on_plan: _OnPlan | None = None,
    on_step: _OnStep | None = None,
    play: Callable[[RunControl], bool | None] | None = None,
    log: str | os.PathLike[str] | None = None,
    report: str | os.PathLike[str] | None = None,
) -> Episode: ...
def replay(
    path: str | os.PathLike[str], *, on_plan: _OnPlan | None = None, on_step: _OnStep | None = None
) -> Replay: ...
def read_barn(path: str | os.PathLike[str], worlds: Sequence[int] = []) -> list[BarnWorld]: ...
def jackal_settings() -> Settings: ...
