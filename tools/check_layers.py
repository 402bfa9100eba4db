#!/usr/bin/env python3
"""Fails when a folder of src/fairway includes one that comes later in the data flow."""

import pathlib
import re
import sys

ORDER = ["base", "geometry", "map", "path", "corridor", "prediction", "perception", "mpc", "navigation", "simulation", "physics", "io"]
INCLUDE = re.compile(r'^\s*#include\s+"fairway/([a-z_0-9]+)/', re.MULTILINE)


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent / "src" / "fairway"
    files = [f for pattern in ("*.hpp", "*.cpp") for f in sorted(root.rglob(pattern))]
    bad = 0
    for file in files:
        folder = file.relative_to(root).parts[0]
        if folder not in ORDER:
            print(f"{file.relative_to(root)}: folder '{folder}' is not in the order of layers")
            bad += 1
            continue
        for included in INCLUDE.findall(file.read_text()):
            if included not in ORDER or ORDER.index(included) > ORDER.index(folder):
                print(f"{file.relative_to(root)}: '{folder}' must not include '{included}'")
                bad += 1
    print(f"{len(files)} files checked, {bad} wrong")
    return 1 if bad or not files else 0


if __name__ == "__main__":
    sys.exit(main())
