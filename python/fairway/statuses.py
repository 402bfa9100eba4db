# SPDX-License-Identifier: Apache-2.0
"""What became of a cycle, a path, a corridor or a solve."""

from ._fairway import (
    CorridorStatus,
    LimitingFactor,
    NavigationStatus,
    PathStatus,
    SolveStatus,
)

__all__ = ["CorridorStatus", "LimitingFactor", "NavigationStatus", "PathStatus", "SolveStatus"]
