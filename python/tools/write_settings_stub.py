#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes python/fairway/settings.pyi from the table of settings; a test compares the two.

Usage: PYTHONPATH=build/release/python python3 python/tools/write_settings_stub.py
"""

import pathlib

import numpy as np

import fairway

HEAD = '''# SPDX-License-Identifier: Apache-2.0
# Written by python/tools/write_settings_stub.py; a test compares the two.
import os
from typing import ClassVar, Literal

import numpy as np
import numpy.typing as npt

'''

SETTINGS = '''class Settings:
    """All settings of Fairway, by groups. An assignment checks type and range."""

    __hash__: ClassVar[None]  # type: ignore[assignment]
    def __init__(self, preset: Literal["default", "paper"] = "default") -> None: ...
{groups}
    @staticmethod
    def read(path: str | os.PathLike[str]) -> Settings: ...
    @staticmethod
    def parse(text: str) -> Settings: ...
    def assign(self, assignment: str) -> None: ...
    def validate(self) -> None: ...
    def yaml(self, essential: bool = False) -> str: ...
    def changed(self) -> dict[str, str]: ...
    def copy(self) -> Settings: ...
    def __copy__(self) -> Settings: ...
    def __deepcopy__(self, memo: dict[int, object]) -> Settings: ...
    def __eq__(self, other: object) -> bool: ...
'''


def type_text(value: object) -> str:
    return "npt.NDArray[np.float64]" if isinstance(value, np.ndarray) else type(value).__name__


def group_names() -> list:
    """The groups in the order of the table."""
    return [line[:-1] for line in fairway.Settings().yaml().splitlines()
            if line.endswith(":") and not line.startswith((" ", "#"))]


def stub() -> str:
    settings, text, groups = fairway.Settings(), HEAD, ""
    for name in group_names():
        group = getattr(settings, name)
        kind = type(group)
        text += f'class {kind.__name__}:\n    """{kind.__doc__}"""\n\n'
        for key, attribute in vars(kind).items():
            if isinstance(attribute, property):
                text += f"    {key}: {type_text(getattr(group, key))}\n"
                text += "".join(f"    {line}\n" for line in docstring(attribute.__doc__.rsplit(" (", 1)[0]))
        text += "\n"
        groups += f"    @property\n    def {name}(self) -> {kind.__name__}: ...\n"
    return text + SETTINGS.replace("{groups}\n", groups)


def docstring(text: str) -> list:
    """What an attribute means, without its range, in lines of at most 120 characters."""
    lines, line = [], '"""'
    for word in text.split():
        if len(line) + 1 + len(word) > 116:
            lines.append(line)
            line = word
        else:
            line += word if line == '"""' else " " + word
    return [*lines, line + '"""']


if __name__ == "__main__":
    path = pathlib.Path(__file__).resolve().parents[1] / "fairway" / "settings.pyi"
    path.write_text(stub(), encoding="utf-8")
    print(f"{path.name} written")
