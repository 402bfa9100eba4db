# SPDX-License-Identifier: Apache-2.0
from typing import ClassVar

class NavigationStatus:
    """State of the navigator in a cycle."""

    __members__: ClassVar[dict[str, NavigationStatus]]
    Ok: ClassVar[NavigationStatus]
    Degraded: ClassVar[NavigationStatus]
    Stopping: ClassVar[NavigationStatus]
    Blocked: ClassVar[NavigationStatus]
    Recovering: ClassVar[NavigationStatus]
    Stale: ClassVar[NavigationStatus]
    BadInput: ClassVar[NavigationStatus]
    Infeasible: ClassVar[NavigationStatus]
    NoPlan: ClassVar[NavigationStatus]
    GoalReached: ClassVar[NavigationStatus]
    Planning: ClassVar[NavigationStatus]
    GaveUp: ClassVar[NavigationStatus]
    Holding: ClassVar[NavigationStatus]
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    @property
    def text(self) -> str: ...
    @property
    def label(self) -> str: ...
    @property
    def meaning(self) -> str: ...
    @property
    def causes(self) -> str: ...
    @property
    def remedy(self) -> str: ...

class LimitingFactor:
    """The reason why a robot is slow, turns or stops in a cycle."""

    __members__: ClassVar[dict[str, LimitingFactor]]
    None_: ClassVar[LimitingFactor]
    Speed: ClassVar[LimitingFactor]
    Acceleration: ClassVar[LimitingFactor]
    Corridor: ClassVar[LimitingFactor]
    MovingObstacle: ClassVar[LimitingFactor]
    StopNotProven: ClassVar[LimitingFactor]
    OutsideCorridor: ClassVar[LimitingFactor]
    StalePose: ClassVar[LimitingFactor]
    StaleMap: ClassVar[LimitingFactor]
    StaleTracks: ClassVar[LimitingFactor]
    InvalidPose: ClassVar[LimitingFactor]
    InvalidTracks: ClassVar[LimitingFactor]
    PoseJump: ClassVar[LimitingFactor]
    SolverFailed: ClassVar[LimitingFactor]
    NoPath: ClassVar[LimitingFactor]
    InvalidGoal: ClassVar[LimitingFactor]
    InvalidTime: ClassVar[LimitingFactor]
    SmallerPlan: ClassVar[LimitingFactor]
    InvalidScan: ClassVar[LimitingFactor]
    LateCycle: ClassVar[LimitingFactor]
    KeepOutZone: ClassVar[LimitingFactor]
    Strip: ClassVar[LimitingFactor]
    SpeedZone: ClassVar[LimitingFactor]
    OneWayZone: ClassVar[LimitingFactor]
    Hold: ClassVar[LimitingFactor]
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    @property
    def text(self) -> str: ...
    @property
    def label(self) -> str: ...
    @property
    def meaning(self) -> str: ...
    @property
    def causes(self) -> str: ...
    @property
    def remedy(self) -> str: ...

class PathStatus:
    """Result of a path search."""

    __members__: ClassVar[dict[str, PathStatus]]
    Found: ClassVar[PathStatus]
    StartOutsideMap: ClassVar[PathStatus]
    GoalOutsideMap: ClassVar[PathStatus]
    StartBlocked: ClassVar[PathStatus]
    GoalBlocked: ClassVar[PathStatus]
    NoConnection: ClassVar[PathStatus]
    InvalidInput: ClassVar[PathStatus]
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    @property
    def text(self) -> str: ...

class CorridorStatus:
    """Result of building a corridor."""

    __members__: ClassVar[dict[str, CorridorStatus]]
    Built: ClassVar[CorridorStatus]
    EmptyPath: ClassVar[CorridorStatus]
    SeedBlocked: ClassVar[CorridorStatus]
    NoOverlap: ClassVar[CorridorStatus]
    InvalidInput: ClassVar[CorridorStatus]
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    @property
    def text(self) -> str: ...

class SolveStatus:
    """Reason why a solve ended."""

    __members__: ClassVar[dict[str, SolveStatus]]
    Solved: ClassVar[SolveStatus]
    LeastViolation: ClassVar[SolveStatus]
    IterationLimit: ClassVar[SolveStatus]
    Stalled: ClassVar[SolveStatus]
    InvalidProblem: ClassVar[SolveStatus]
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    @property
    def text(self) -> str: ...
