#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws other worlds from the discs of DynaBARN, for `fairway dynabarn`.

Half of the worlds are given ones, mirrored or turned, where all discs begin at another time of
their loops. The other half draws as many discs of the same difficulty from all given worlds.

    benchmarks/cases/make_dynabarn_worlds.py dynabarn.json build/drawn.json --count 60 --seed 1
    build/release/bin/fairway dynabarn build/drawn.json
"""
import argparse
import json
import math
import random

JUMP = 1e-4  # [s]


def symmetry(rng):
    """One of the eight symmetries of the square of the worlds."""
    turns, mirrored = rng.randrange(4), rng.random() < 0.5

    def apply(x, y):
        x = -x if mirrored else x
        for _ in range(turns):
            x, y = -y, x
        return x, y

    return apply


def later(keys, shift):
    """A loop of key frames that begins `shift` later; its end jumps to its start within JUMP."""
    period = keys[-1][0]
    shift = math.fmod(shift, period)
    after = [k for k in keys if k[0] > shift]
    before = [k for k in keys if k[0] < shift]
    at = place(keys, shift)
    loop = [[0.0, *at]] + [[k[0] - shift, k[1], k[2]] for k in after]
    jump = [[k[0] + period - shift + JUMP, k[1], k[2]] for k in before]
    return loop + jump + [[period + JUMP, *at]]


def place(keys, time):
    for a, b in zip(keys, keys[1:]):
        if a[0] <= time <= b[0]:
            share = (time - a[0]) / (b[0] - a[0])
            return [a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])]
    return keys[-1][1:]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("given")
    parser.add_argument("out")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    with open(options.given, encoding="utf-8") as file:
        data = json.load(file)
    given = sorted(data["worlds"], key=lambda w: w["world"])
    pools = {}
    for world in given:
        pool = pools.setdefault(world["difficulty"], {})
        for disc in world["obstacles"]:
            pool[disc["name"]] = disc
    worlds = []
    for number in range(options.count):
        world = given[number // 2 * 7 % len(given)]
        turned = symmetry(rng)
        discs = world["obstacles"]
        if number % 2 == 0:
            shift = rng.uniform(3.0, 60.0)
        else:
            pool = pools[world["difficulty"]]
            discs = [pool[name] for name in rng.sample(sorted(pool), len(discs))]
            shift = 0.0
        drawn = []
        for disc in discs:
            keys = [[k[0] - disc["keys"][0][0], *turned(k[1], k[2])] for k in disc["keys"]]
            if shift > 0.0:
                keys = later(keys, shift)
            keys = [[round(v, 5) for v in k] for k in keys]
            drawn.append({"name": disc["name"], "radius": disc["radius"], "keys": keys})
        worlds.append({"world": number, "difficulty": world["difficulty"], "obstacles": drawn})
    with open(options.out, "w", encoding="utf-8") as file:
        json.dump({key: data[key] for key in ("start", "goal", "goal_radius", "timeout_s")} |
                  {"source": f"drawn from {data['source']}", "worlds": worlds}, file)


if __name__ == "__main__":
    main()
