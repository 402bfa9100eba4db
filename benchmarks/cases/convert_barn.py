#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Converts worlds of the BARN challenge for `fairway barn`.

    git clone https://github.com/Daffan/the-barn-challenge
    benchmarks/cases/convert_barn.py the-barn-challenge barn
    fairway barn barn

The challenge describes a world by Gazebo cylinders and a reference path; `fairway barn` reads a
map_server grid, start, goal and optimal time. Poses stay in the world frame of Gazebo.
"""
import argparse
import ast
import json
import math
import pathlib
import re
import struct
import sys

from make_narrow_worlds import GOAL, START, write_map

POST = 0.075  # [m], radius of a cylinder; paths are given in steps of two radii


def posts_of(world: pathlib.Path) -> list:
    """Centres of the cylinders [m]."""
    models = re.findall(r"<model name='unit_cylinder[^']*'>.*?<pose[^>]*>([^<]*)</pose>.*?</model>",
                        world.read_text(), re.DOTALL)
    return [tuple(float(number) for number in pose.split()[:2]) for pose in models]


def rows_of(file: pathlib.Path) -> list:
    """Rows of a NumPy file of pairs of 64-bit integers."""
    data = file.read_bytes()
    length = struct.unpack("<H", data[8:10])[0]
    header = ast.literal_eval(data[10:10 + length].decode())
    if header["descr"] != "<i8" or len(header["shape"]) != 2 or header["fortran_order"]:
        sys.exit(f"{file}: expected rows of 64-bit integers, found {header}")
    numbers = [value for value, in struct.iter_unpack("<q", data[10 + length:])]
    return list(zip(numbers[::2], numbers[1::2]))


def reference_length(file: pathlib.Path) -> float:
    """Length of the reference path from start to goal [m], as the challenge computes it."""
    path = [(x * 2 * POST - POST - 60 * POST, y * 2 * POST + POST + 5) for x, y in rows_of(file)]
    points = [START, *path, GOAL]
    return sum(math.dist(a, b) for a, b in zip(points, points[1:]))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("checkout", type=pathlib.Path, help="folder of Daffan/the-barn-challenge")
    parser.add_argument("folder", type=pathlib.Path, help="where the converted worlds go")
    parser.add_argument("--worlds", default=",".join(str(n) for n in range(0, 300, 6)),
                        help="numbers with commas between them; the 50 of our figures by default")
    options = parser.parse_args()
    source = options.checkout / "jackal_helper/worlds/BARN"
    (options.folder / "maps").mkdir(parents=True, exist_ok=True)
    worlds = []
    for number in map(int, options.worlds.split(",")):
        name = f"world_{number:03}"
        write_map(options.folder / "maps", name, posts_of(source / f"world_{number}.world"))
        length = reference_length(source / f"path_files/path_{number}.npy")
        worlds.append({"world": number, "start": [*START, 1.57], "goal": [*GOAL, 1.57],
                       "goal_radius": 1.0, "timeout_s": 100.0, "path_length": round(length, 4),
                       "OT": round(length / 2.0, 4), "map": f"maps/{name}.yaml"})
    (options.folder / "barn.json").write_text(json.dumps({"worlds": worlds}, indent=1) + "\n")
    print(f"{len(worlds)} worlds in {options.folder}")


if __name__ == "__main__":
    main()
