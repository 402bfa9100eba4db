#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how often recorded people stay within the uncertainty of their forecast.

    tools/forecast_coverage.py TRACKS... [--growth G] [--svg FILE]

TRACKS are files with the columns frame,id,x,y and 0.1 s between frames, as `fairway people recorded`
reads. The forecast is that of the space-time plan: the velocity over the last 0.3 s is kept, and the
standard deviation of a coordinate is as in src/fairway/prediction/forecast.cpp with G for
`prediction.deviation_growth`. The output is, per file, speed and time ahead, the share of coordinates
within 1, 1.5 and 2 deviations; a calibrated normal distribution has 0.683, 0.866 and 0.954. The
picture shows the shares within 1.5 deviations, the width that the plan uses.
"""
import argparse
import csv
import math
import pathlib

BACK = 3  # frames over which the velocity is estimated
AHEAD = [5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60]  # frames
WIDTHS = [1.0, 1.5, 2.0]
WALKING = 0.8  # m/s
COLOURS = ["#1b6ca8", "#c8501e", "#3a7d44", "#7b4fa3", "#8a6d1f"]


def read_tracks(path):
    tracks = {}
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            place = (float(row["x"]), float(row["y"]))
            tracks.setdefault(row["id"], {})[int(row["frame"])] = place
    return tracks.values()


def deviation(speed, time, growth):
    """As forecast_deviation in src/fairway/prediction/forecast.cpp."""
    share = 0.25 + 0.75 * min(1.0, speed / WALKING)
    return min(0.03 + share * growth * time, 1.0)


def coverage(tracks, growth):
    """Counts by (is walking, frames ahead): coordinates, and those within each of WIDTHS."""
    counts = {}
    for track in tracks:
        for frame, (x, y) in track.items():
            if frame - BACK not in track:
                continue
            before = track[frame - BACK]
            vx, vy = (x - before[0]) * 10 / BACK, (y - before[1]) * 10 / BACK
            speed = math.hypot(vx, vy)
            for ahead in AHEAD:
                there = track.get(frame + ahead)
                if there is None:
                    continue
                time = ahead / 10
                allowed = deviation(speed, time, growth)
                count = counts.setdefault((speed >= WALKING, ahead), [0] * (1 + len(WIDTHS)))
                for error in (there[0] - x - vx * time, there[1] - y - vy * time):
                    count[0] += 1
                    for k, width in enumerate(WIDTHS):
                        count[1 + k] += abs(error) <= width * allowed
    return counts


def picture(results):
    """One panel per speed, one line per file, and the normal distribution as a dashed line."""
    width, height, left, top = 300, 220, 50, 30
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 740 330" '
             'font-family="sans-serif" font-size="12">',
             '<rect width="740" height="330" fill="white"/>']
    for panel, (walking, title) in enumerate(((True, "walking (from 0.8 m/s)"), (False, "slower"))):
        x0 = left + panel * (width + 60)
        at = lambda time, share: (x0 + width * time / 6, top + height * (1 - share))
        parts.append(f'<rect x="{x0}" y="{top}" width="{width}" height="{height}" fill="none" stroke="#888"/>')
        parts.append(f'<text x="{x0 + width / 2}" y="{top - 10}" text-anchor="middle">{title}</text>')
        for share in (0, 0.25, 0.5, 0.75, 1):
            parts.append(f'<text x="{x0 - 6}" y="{at(0, share)[1] + 4:.1f}" text-anchor="end">{share:g}</text>')
        for time in range(7):
            parts.append(f'<text x="{at(time, 0)[0]:.1f}" y="{top + height + 16}" text-anchor="middle">{time}</text>')
        y = at(0, 0.866)[1]
        parts.append(f'<path d="M{x0} {y:.1f}h{width}" stroke="#444" stroke-dasharray="5 4" fill="none"/>')
        for (name, counts), colour in zip(results.items(), COLOURS):
            points = [at(a / 10, counts[walking, a][2] / counts[walking, a][0])
                      for a in AHEAD if counts.get((walking, a), [0])[0] >= 100]
            line = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
            parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>')
    for k, (name, colour) in enumerate(zip(results, COLOURS)):
        x = left + 120 * k
        parts.append(f'<path d="M{x} 305h20" stroke="{colour}" stroke-width="2"/>'
                     f'<text x="{x + 26}" y="309">{name}</text>')
    parts.append('<text x="400" y="284" text-anchor="middle">time ahead [s]; '
                 'share within 1.5 standard deviations; dashed: normal distribution</text></svg>')
    return "\n".join(parts) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("tracks", nargs="+")
    parser.add_argument("--growth", type=float, default=0.18)
    parser.add_argument("--svg")
    options = parser.parse_args()
    results = {}
    for path in options.tracks:
        name = pathlib.Path(path).stem.removeprefix("tracks_")
        results[name] = coverage(read_tracks(path), options.growth)
        for walking in (True, False):
            print(f"{name}, {'walking' if walking else 'slower'}: time ahead, shares within "
                  + ", ".join(f"{width:g}" for width in WIDTHS) + " deviations, coordinates")
            for ahead in AHEAD[1::2]:
                count = results[name].get((walking, ahead))
                if count:
                    shares = "  ".join(f"{within / count[0]:.3f}" for within in count[1:])
                    print(f"  {ahead / 10:.0f} s  {shares}  {count[0]}")
    if options.svg:
        pathlib.Path(options.svg).write_text(picture(results), encoding="utf-8")


if __name__ == "__main__":
    main()
