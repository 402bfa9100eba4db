#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Generates narrow worlds in the manner of BARN, for `fairway barn`.

A cellular automaton places posts of radius 0.075 m on a lattice of 0.15 m, between two walls that
are 4.5 m apart. Worlds are kept if their widest path has a clearance within the given bounds. The
reference length is that of the shortest path for a disc of 0.31 m on cells of 0.05 m, 8-connected.

    benchmarks/cases/make_narrow_worlds.py build/narrow --count 60 --seed 1
    build/release/bin/fairway barn build/narrow
"""
import argparse
import heapq
import json
import math
import pathlib
import random

POST, LATTICE, CELL = 0.075, 0.15, 0.05  # [m]
COLUMNS, ROWS, FIRST_ROW = 30, 64, 31  # of the lattice; obstacles from FIRST_ROW on
ORIGIN, WIDTH, HEIGHT = (-7.45, -2.95), 208, 379  # of the map, in cells of CELL
START, GOAL = (-2.25, 3.0), (-2.25, 13.0)


def draw_posts(rng):
    """The filled lattice points: walls left, right and behind, and a smoothed random field."""
    fill, rounds = rng.uniform(0.15, 0.35), rng.randint(2, 4)
    span = range(FIRST_ROW, ROWS)
    field = {(c, r) for r in span for c in range(COLUMNS) if rng.random() < fill}
    for _ in range(rounds):
        grown = set()
        for r in span:
            for c in range(COLUMNS):
                near = sum((c + i, r + j) in field for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j)
                if near >= 5 or ((c, r) in field and near >= 2):
                    grown.add((c, r))
        field = grown
    walls = {(c, r) for r in range(ROWS) for c in (0, COLUMNS - 1)} | {(c, 0) for c in range(COLUMNS)}
    return sorted(field | walls)


def post_center(post):
    return (-4.425 + LATTICE * post[0], 0.075 + LATTICE * post[1])


def distances(posts):
    """Distance from every cell centre to the nearest post's rim, at most 0.8 m."""
    reach, far = 18, 0.8
    field = [far] * (WIDTH * HEIGHT)
    for x, y in map(post_center, posts):
        cx, cy = int((x - ORIGIN[0]) / CELL), int((y - ORIGIN[1]) / CELL)
        for j in range(max(0, cy - reach), min(HEIGHT, cy + reach + 1)):
            for i in range(max(0, cx - reach), min(WIDTH, cx + reach + 1)):
                d = math.hypot(ORIGIN[0] + (i + 0.5) * CELL - x, ORIGIN[1] + (j + 0.5) * CELL - y) - POST
                if d < field[j * WIDTH + i]:
                    field[j * WIDTH + i] = d
    return field


def cell_of(point):
    return int((point[1] - ORIGIN[1]) / CELL) * WIDTH + int((point[0] - ORIGIN[0]) / CELL)


STEPS = [(i, j, math.hypot(i, j) * CELL) for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]


def neighbours(cell):
    x, y = cell % WIDTH, cell // WIDTH
    for i, j, length in STEPS:
        if 0 <= x + i < WIDTH and 0 <= y + j < HEIGHT:
            yield cell + j * WIDTH + i, length


def inside(cell):
    """Whether a cell is between the walls, or beyond their end; paths around the field do not count."""
    x, y = ORIGIN[0] + (cell % WIDTH + 0.5) * CELL, ORIGIN[1] + (cell // WIDTH + 0.5) * CELL
    return -4.425 < x < -0.075 and y > 0.075 or y > 9.6


def widest_clearance(field):
    """The largest clearance of any path from start to goal."""
    best, queue, goal = {}, [(-field[cell_of(START)], cell_of(START))], cell_of(GOAL)
    while queue:
        width, cell = heapq.heappop(queue)
        if cell in best:
            continue
        best[cell] = -width
        if cell == goal:
            return -width
        for other, _ in neighbours(cell):
            if other not in best and inside(other):
                heapq.heappush(queue, (-min(-width, field[other]), other))
    return 0.0


def shortest_way(field, radius):
    done, queue, goal = set(), [(0.0, cell_of(START))], cell_of(GOAL)
    while queue:
        length, cell = heapq.heappop(queue)
        if cell == goal:
            return length
        if cell in done:
            continue
        done.add(cell)
        for other, step in neighbours(cell):
            if other not in done and field[other] >= radius and inside(other):
                heapq.heappush(queue, (length + step, other))
    return math.inf


def write_map(folder, name, centers):
    """A cell is occupied when a post reaches into it."""
    image = bytearray(b"\xfe" * (WIDTH * HEIGHT))
    for x, y in centers:
        cx, cy = int((x - ORIGIN[0]) / CELL), int((y - ORIGIN[1]) / CELL)
        for j in range(cy - 2, cy + 3):
            for i in range(cx - 2, cx + 3):
                low = (ORIGIN[0] + i * CELL, ORIGIN[1] + j * CELL)
                dx = max(low[0] - x, 0.0, x - low[0] - CELL)
                dy = max(low[1] - y, 0.0, y - low[1] - CELL)
                if math.hypot(dx, dy) < POST - 1e-6:
                    image[(HEIGHT - 1 - j) * WIDTH + i] = 0
    (folder / f"{name}.pgm").write_bytes(b"P5\n%d %d\n255\n" % (WIDTH, HEIGHT) + image)
    (folder / f"{name}.yaml").write_text(
        f"image: {name}.pgm\nmode: trinary\nresolution: {CELL}\n"
        f"origin: [{ORIGIN[0]}, {ORIGIN[1]}, 0.0]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--least", type=float, default=0.365, help="least clearance of the widest path [m]")
    parser.add_argument("--most", type=float, default=0.45, help="largest clearance of the widest path [m]")
    options = parser.parse_args()
    (options.folder / "maps").mkdir(parents=True, exist_ok=True)
    rng, worlds = random.Random(options.seed), []
    while len(worlds) < options.count:
        posts = draw_posts(rng)
        field = distances(posts)
        clearance = widest_clearance(field)
        if not options.least <= clearance <= options.most:
            continue
        length, number = shortest_way(field, 0.31), len(worlds)
        name = f"world_{number:03}"
        write_map(options.folder / "maps", name, map(post_center, posts))
        worlds.append({"world": number, "start": [*START, 1.57], "goal": [*GOAL, 1.57],
                       "goal_radius": 1.0, "timeout_s": 100.0, "path_length": round(length, 4),
                       "OT": round(length / 2.0, 4), "map": f"maps/{name}.yaml",
                       "bottleneck_clearance": round(clearance, 3)})
    (options.folder / "barn.json").write_text(json.dumps({"worlds": worlds}, indent=1) + "\n")


if __name__ == "__main__":
    main()
