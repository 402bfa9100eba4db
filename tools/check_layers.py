#!/usr/bin/env python3
"""Fails when a folder of src/fairway includes a later one, or a target one that it does not link.

Folders are listed in the order of the data flow, including subfolders: a folder may include itself and
earlier folders. A subfolder precedes its parent if the parent is its public interface.
"""

import pathlib
import re
import sys

# Per target: its folders in order. A target may include its own folders and those of earlier
# targets that it links.
TARGETS = [
    ("fairway", [], [
        "base", "geometry", "monitor", "zones", "map", "prediction", "path", "path/se2", "trajectory", "corridor/rectangle", "corridor", "mpc", "mpc/body",
        "mpc/interior_point/workspace", "mpc/interior_point/constraints", "mpc/interior_point/newton",
        "mpc/interior_point/lockstep",
        "mpc/interior_point", "mpc/interior_point/body", "planning", "tracking", "tracking/space_time", "safety", "fleet", "localization", "perception/object", "perception",
        "navigation", "navigation/explanation", "navigation/facade", "navigation/body/proof", "navigation/body/control", "navigation/body/drive", "navigation/body/guide", "navigation/body", ""]),
    ("fairway_ipopt", ["fairway"], ["mpc/ipopt"]),
    ("fairway_simulation", ["fairway"], [
        "simulation/sensors", "simulation/bodies", "simulation/judges", "simulation/people", "simulation", "simulation/interactive", "simulation/scenarios",
        "simulation/recorded",
        "simulation/physics"]),
    ("fairway_io", ["fairway", "fairway_simulation"], [
        "io", "io/yaml", "io/maps", "io/drawing", "io/scenario", "io/mcap",
        "io/recording/exact", "io/recording", "io/recording/reading", "io/web_report"]),
]
INCLUDE = re.compile(r'^\s*#include\s+"(fairway|experiments)/([a-z_0-9/]*?)/?([a-z_0-9]+\.hpp)"', re.MULTILINE)


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent / "src" / "fairway"
    target_of = {folder: name for name, _, folders in TARGETS for folder in folders}
    links = {name: set(linked) for name, linked, _ in TARGETS}
    order = {folder: i for _, _, folders in TARGETS for i, folder in enumerate(folders)}
    files = [f for pattern in ("*.hpp", "*.cpp") for f in sorted(root.rglob(pattern))]
    wrong = []
    for file in files:
        folder = file.relative_to(root).parent.as_posix().replace(".", "")
        if folder not in order:
            wrong.append(f"{file.relative_to(root)}: folder '{folder}' is not in the order of layers")
            continue
        target = target_of[folder]
        for tree, included, header in INCLUDE.findall(file.read_text()):
            if tree == "experiments":
                wrong.append(f"{file.relative_to(root)}: the library must not include experiments")
            elif included not in order:
                wrong.append(f"{file.relative_to(root)}: '{included}' is not in the order of layers")
            elif target_of[included] == target:
                if order[included] > order[folder]:
                    wrong.append(f"{file.relative_to(root)}: '{folder}' must not include '{included}'")
            elif target_of[included] not in links[target]:
                wrong.append(f"{file.relative_to(root)}: {target} does not link {target_of[included]} ({header})")
    for line in wrong:
        print(line)
    print(f"{len(files)} files checked, {len(wrong)} wrong")
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
