#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how well simple predictions match the motion of pedestrians.

    tools/prediction_study.py OBSMAT

OBSMAT has rows of frame, id, x, z, y, vx, vz, vy, as in the UCY and ETH tracks, 0.4 s apart. Every
window of 8 observed and 12 predicted positions of one person counts. The output is, per method, the
mean distance over the 12 steps (ADE) and at the last one (FDE) in metres.
"""
import math
import sys

SEEN, AHEAD = 8, 12


def read_tracks(path):
    tracks = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            row = [float(word) for word in line.split()]
            if len(row) >= 5:
                tracks.setdefault(int(row[1]), []).append((row[0], row[2], row[4]))
    return [sorted(track) for track in tracks.values()]


def windows(tracks):
    for track in tracks:
        step = min((b[0] - a[0] for a, b in zip(track, track[1:])), default=0)
        for i in range(len(track) - SEEN - AHEAD + 1):
            part = track[i:i + SEEN + AHEAD]
            if part[-1][0] - part[0][0] == step * (SEEN + AHEAD - 1):
                points = [(x, y) for _, x, y in part]
                yield points[:SEEN], points[SEEN:]


def mean_displacement(count):
    """Keeps the mean displacement of the last `count` steps."""
    def predict(seen):
        dx = (seen[-1][0] - seen[-1 - count][0]) / count
        dy = (seen[-1][1] - seen[-1 - count][1]) / count
        return [(seen[-1][0] + k * dx, seen[-1][1] + k * dy) for k in range(1, AHEAD + 1)]
    return predict


def damped(factor):
    """Keeps the last displacement, each step times `factor` of the one before."""
    def predict(seen):
        dx, dy = seen[-1][0] - seen[-2][0], seen[-1][1] - seen[-2][1]
        x, y = seen[-1]
        result = []
        for _ in range(AHEAD):
            dx, dy = factor * dx, factor * dy
            x, y = x + dx, y + dy
            result.append((x, y))
        return result
    return predict


def turning(share):
    """Keeps the last displacement and `share` of the last turn in every step."""
    def predict(seen):
        dx, dy = seen[-1][0] - seen[-2][0], seen[-1][1] - seen[-2][1]
        ex, ey = seen[-2][0] - seen[-3][0], seen[-2][1] - seen[-3][1]
        turn = share * math.atan2(ex * dy - ey * dx, ex * dx + ey * dy)
        c, s = math.cos(turn), math.sin(turn)
        x, y = seen[-1]
        result = []
        for _ in range(AHEAD):
            dx, dy = c * dx - s * dy, s * dx + c * dy
            x, y = x + dx, y + dy
            result.append((x, y))
        return result
    return predict


METHODS = {
    "at standstill": damped(0.0),
    "last displacement": mean_displacement(1),
    "mean of the last 2": mean_displacement(2),
    "mean of the last 4": mean_displacement(4),
    "mean of the last 7": mean_displacement(7),
    "last, damped by 0.98 a step": damped(0.98),
    "last, damped by 0.95 a step": damped(0.95),
    "last, and a tenth of the turn": turning(0.1),
    "last, and the whole turn": turning(1.0),
}


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    cases = list(windows(read_tracks(sys.argv[1])))
    if not cases:
        print(f"{sys.argv[1]}: expected tracks of at least {SEEN + AHEAD} steps", file=sys.stderr)
        return 2
    print(f"{len(cases)} windows")
    for name, predict in METHODS.items():
        average = final = 0.0
        for seen, truth in cases:
            errors = [math.dist(a, b) for a, b in zip(predict(seen), truth)]
            average += sum(errors) / AHEAD
            final += errors[-1]
        print(f"{name:32} ADE {average / len(cases):.3f} m  FDE {final / len(cases):.3f} m")
    return 0


if __name__ == "__main__":
    sys.exit(main())
