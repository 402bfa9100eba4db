#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a film of a run among recorded people: an animated SVG that browsers play.

    tools/people_film.py FOLDER TRACE.csv CASE FILM.svg

FOLDER has cases.csv and tracks_SCENE.csv, TRACE.csv is from `fairway people recorded --trace`. The
film runs in real time and repeats. The robot is blue, its path grey, the goal a circle of 1 m; people
are orange, those nearer than 1 m to the robot red.
"""
import argparse
import csv
import math
import pathlib

EVERY = 2  # frames of 0.1 s from one picture to the next
SCALE = 40  # pixels per metre
CONTACT, NEAR = 0.5, 1.0  # m, between the centres


def read(folder, trace, number):
    with open(folder / "cases.csv", encoding="utf-8", newline="") as file:
        case = next((row for row in csv.DictReader(file) if int(row["case"]) == number), None)
    if case is None:
        raise SystemExit(f"people_film.py: {folder / 'cases.csv'}: no case {number}")
    with open(trace, encoding="utf-8", newline="") as file:
        poses = [tuple(float(row[k]) for k in ("x", "y", "heading"))
                 for row in csv.DictReader(file) if int(row["case"]) == number]
    if not poses:
        raise SystemExit(f"people_film.py: {trace}: no run of case {number}")
    first = int(case["start_frame"])
    people = {}
    with open(folder / f"tracks_{case['scene'].lower()}.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            frame = int(row["frame"]) - first
            if 0 <= frame < len(poses):
                people.setdefault(row["id"], {})[frame] = (float(row["x"]), float(row["y"]))
    return case, poses, people


def animate(attribute, values, duration, mode=""):
    return (f'<animate attributeName="{attribute}" dur="{duration}s" repeatCount="indefinite"{mode} '
            f'values="{";".join(values)}"/>')


def person(track, poses, frames, duration, pixel):
    places, colours, shown = [], [], []
    known = min(track)
    for frame in frames:
        known = frame if frame in track else known
        place = track[known]
        places.append(pixel(place))
        colours.append("#c22" if math.dist(place, poses[frame][:2]) < NEAR else "#e8862e")
        shown.append("1" if frame in track else "0")
    discrete = ' calcMode="discrete"'
    return (f'<circle r="{CONTACT / 2 * SCALE:.1f}">'
            + animate("cx", [f"{x:.0f}" for x, _ in places], duration)
            + animate("cy", [f"{y:.0f}" for _, y in places], duration)
            + animate("fill", colours, duration, discrete)
            + animate("opacity", shown, duration, discrete) + "</circle>")


def film(case, poses, people):
    frames = list(range(0, len(poses), EVERY))
    duration = round(len(frames) * EVERY / 10, 1)
    goal = float(case["goal_x"]), float(case["goal_y"])
    xs, ys = [x for x, _, _ in poses] + [goal[0]], [y for _, y, _ in poses] + [goal[1]]
    left, top = min(xs) - 4, max(ys) + 4
    width, height = max(xs) + 4 - left, top - min(ys) + 4
    pixel = lambda place: ((place[0] - left) * SCALE, (top - place[1]) * SCALE)
    path = " ".join(f"{x:.0f},{y:.0f}" for x, y in (pixel(p[:2]) for p in poses))
    gx, gy = pixel(goal)
    places = [pixel(poses[f][:2]) for f in frames]
    turns = [-math.degrees(poses[f][2]) for f in frames]
    for k in range(1, len(turns)):  # the shorter way round
        turns[k] -= 360 * round((turns[k] - turns[k - 1]) / 360)
    def transform(kind, values):
        return (f'<animateTransform attributeName="transform" type="{kind}" dur="{duration}s" '
                f'repeatCount="indefinite" values="{";".join(values)}"/>')
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width * SCALE:.0f} {height * SCALE:.0f}">',
             f'<rect width="{width * SCALE:.0f}" height="{height * SCALE:.0f}" fill="#fafafa"/>',
             f'<polyline points="{path}" fill="none" stroke="#bbb" stroke-width="3"/>',
             f'<circle cx="{gx:.0f}" cy="{gy:.0f}" r="{SCALE}" fill="none" stroke="#393" stroke-width="3"/>']
    parts += [person(track, poses, frames, duration, pixel) for track in people.values()]
    radius = CONTACT / 2 * SCALE
    parts.append("<g>" + transform("translate", [f"{x:.0f} {y:.0f}" for x, y in places])
                 + "<g>" + transform("rotate", [f"{turn:.0f}" for turn in turns])
                 + f'<circle r="{radius:.1f}" fill="#1b6ca8"/><path d="M0 0h{radius:.1f}" '
                 'stroke="white" stroke-width="3"/></g></g></svg>')
    return "\n".join(parts) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("trace", type=pathlib.Path)
    parser.add_argument("case", type=int)
    parser.add_argument("film", type=pathlib.Path)
    options = parser.parse_args()
    text = film(*read(options.folder, options.trace, options.case))
    options.film.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
