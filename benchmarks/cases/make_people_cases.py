#!/usr/bin/env python3
"""Writes cases for `fairway people` into a folder: make_people_cases.py FOLDER [--first N] [--count N]. Standard library only.

`cases.csv` and `tracks_park.csv` hold people who walk straight across a park; the other files hold starts of
CrowdNav, DS-RNN and CrowdNav++, drawn by their rules from the seeds of the case numbers.
"""

import argparse
import math
import pathlib
import random


class Numpy:
    """numpy.random.seed and numpy.random.random, to the bit."""

    def __init__(self, seed):
        state = [seed]
        for i in range(1, 624):
            state.append((1812433253 * (state[-1] ^ (state[-1] >> 30)) + i) & 0xFFFFFFFF)
        self.random = random.Random()
        self.random.setstate((3, (*state, 624), None))

    def unit(self):
        return self.random.random()

    def between(self, low, high):
        return low + (high - low) * self.unit()


def park(folder, first, count, rng):
    cases = ["scene,case,task,start_x,start_y,goal_x,goal_y,start_frame,start_time,time_limit"]
    for n in range(count):
        frame = 10 + 40 * n
        cases.append(f"PARK,{first + n},cross,0,{n % 3},10,{n % 3},{frame},{frame / 10},17.1")
    people = []
    for identity in range(1, 4 + 2 * count):
        begin = rng.randrange(0, 40 * count + 60)
        speed = rng.uniform(0.8, 1.5) * rng.choice((-1, 1))
        people.append((identity, begin, rng.uniform(3, 8), -9 if speed > 0 else 9, speed))
    tracks = ["frame,id,x,y,vx,vy"]
    for frame in range(40 * count + 200):
        for identity, begin, x, y, speed in people:
            at = y + speed * (frame - begin) / 10
            if frame >= begin and abs(at) <= 9:
                tracks.append(f"{frame},{identity},{x:.4f},{at:.4f},0,{speed:.3f}")
    (folder / "cases.csv").write_text("\n".join(cases) + "\n")
    (folder / "tracks_park.csv").write_text("\n".join(tracks) + "\n")


def circle(draw, radius, spread):
    angle = 2 * math.pi * draw.unit()
    x, y = (draw.unit() - 0.5) * spread, (draw.unit() - 0.5) * spread
    return radius * math.cos(angle) + x, radius * math.sin(angle) + y


def near(place, others, gap):
    """others: (place, radius); gap is added to each radius."""
    return any(math.dist(place, other) < radius + gap for other, radius in others)


def crowdnav(number):
    draw = Numpy(1000 + number)
    rows = [("", (0.0, -4.0), (0.0, 4.0), 0.3, 1)]
    while len(rows) < 6:
        place = circle(draw, 4, 1)
        if not near(place, [(p, 0.3) for _, a, b, _, _ in rows for p in (a, b)], 0.5):
            rows.append(("", place, (-place[0], -place[1]), 0.3, 1))
    return 1000 + number, rows


def dsrnn(number):
    draw = Numpy(1000 + number)
    angle = draw.between(0, 2 * math.pi)
    start = 6 * math.cos(angle), 6 * math.sin(angle)
    goal = draw.between(-6, 6), draw.between(-6, 6)
    while math.dist(start, goal) < 6:
        goal = draw.between(-6, 6), draw.between(-6, 6)
    rows = [(draw.between(0, 2 * math.pi), start, goal, 0.3, 1)]
    for _ in range(5):
        speed, radius = draw.between(0.5, 1.5), draw.between(0.3, 0.5)
        others = [(p, r) for _, a, b, r, _ in rows[1:] for p in (a, b)]
        place = circle(draw, 6, speed)
        while near(place, [(start, 0), (goal, 0)], 3) or near(place, others, radius + 0.25):
            place = circle(draw, 6, speed)
        rows.append(("", place, (-place[0], -place[1]), radius, speed))
    return 1000 + number, rows


def crowdnavpp(number):
    draw = Numpy(1425 + number)
    while True:
        start = draw.between(-6, 6), draw.between(-6, 6)
        goal = draw.between(-6, 6), draw.between(-6, 6)
        if math.dist(start, goal) >= 8:
            break
    rows = [("", start, goal, 0.3, 1)]
    for _ in range(20):
        draw.between(5, 10)
        speed, radius = draw.between(0.5, 1.5), draw.between(0.3, 0.5)
        others = [(p, r) for _, a, b, r, _ in rows for p in (a, b)]
        while True:
            angle = 2 * math.pi * draw.unit()
            x, y = 2 * draw.unit(), 2 * draw.unit()
            place = 72**0.5 * math.cos(angle) + x, 72**0.5 * math.sin(angle) + y
            if not near(place, others, radius + 0.25):
                break
        rows.append(("", place, (-place[0], -place[1]), radius, speed))
    return 1425 + number, rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--count", type=int, default=3, help="cases of each kind")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    park(options.folder, options.first, options.count, random.Random(options.first + 1))
    for name, make in (("crowdnav", crowdnav), ("dsrnn", dsrnn), ("crowdnavpp", crowdnavpp)):
        lines = ["case,seed,agent,x,y,heading,goal_x,goal_y,radius,v_pref"]
        for number in range(options.first, options.first + options.count):
            seed, rows = make(number)
            lines += [f"{number},{seed},{agent},{x!r},{y!r},{heading},{gx!r},{gy!r},{radius!r},{speed!r}"
                      for agent, (heading, (x, y), (gx, gy), radius, speed) in enumerate(rows)]
        (options.folder / f"{name}_cases.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
