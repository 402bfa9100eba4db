# SPDX-License-Identifier: Apache-2.0
"""The groups of settings as classes: `fairway.Settings().robot` is a `RobotSettings`."""

from . import _fairway

__all__ = sorted(name for name in vars(_fairway) if name.endswith("Settings"))
globals().update({name: getattr(_fairway, name) for name in __all__})
