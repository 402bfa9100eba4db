# SPDX-License-Identifier: Apache-2.0
"""Scenarios, simulated runs, recordings, and the worlds of BARN."""

from ._fairway import (
    BarnScore,
    BarnWorld,
    Episode,
    Replay,
    RobotResult,
    RunControl,
    Scenario,
    jackal_settings,
    read_barn,
    replay,
    simulate,
)

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
