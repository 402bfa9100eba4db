#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Classifies the failures of `fairway people recorded`.

    tools/people_failures.py FOLDER RESULT.json TRACE.csv

FOLDER has cases.csv and tracks_SCENE.csv; the other files are from --json and --trace. Per failure
the output has the case, the scene, the time and its kind, the first of these that holds:

    appeared    the person was first seen within the last second, nearer than the robot needs to stop
    turned      a second before, the person's velocity led more than 0.4 m past the place of contact
    surrounded  a second before, three people or more were within 1.5 m of the robot
    overtaken   the person came from behind the robot, or beside it
    driven      the robot drove towards a person whose place was predicted within 0.4 m
    too late    there was no contact
"""
import argparse
import collections
import csv
import json
import math
import pathlib

ACCELERATION = 2.0  # of the robot of the benchmark, m/s^2


def read_tracks(path):
    frames = collections.defaultdict(dict)
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            frames[int(row["frame"])][row["id"]] = (float(row["x"]), float(row["y"]))
    return frames


def read_runs(path):
    runs = collections.defaultdict(list)
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            runs[int(row["case"])].append(tuple(float(row[k]) for k in ("x", "y", "heading")))
    return runs


def classify(frames, start, poses):
    """Kind of a contact at the last pose; frames and poses are 0.1 s apart."""
    last = len(poses) - 1
    people = frames.get(start + last, {})
    if not people:
        return "too late"
    robot = poses[last][:2]
    person = min(people, key=lambda who: math.dist(people[who], robot))
    seen = [f for f in range(start + last - 10, start + last + 1) if person in frames.get(f, {})]
    first = max(0, seen[0] - start)
    if len(seen) <= 10:
        speed = math.dist(poses[first][:2], poses[max(0, first - 1)][:2]) * 10
        needed = 0.5 + 0.1 * speed + speed * speed / (2 * ACCELERATION)
        distance = math.dist(frames[seen[0]][person], poses[first][:2])
        closing = 1.75 * (len(seen) - 1) / 10
        if distance < needed + closing or len(seen) <= 3:
            return "appeared"
    before = seen[0]
    back = frames.get(before - 3, {}).get(person, frames[before][person])
    now = frames[before][person]
    ahead = (start + last - before) / 3
    aim = [now[i] + (now[i] - back[i]) * ahead for i in range(2)]
    if math.dist(aim, people[person]) > 0.4:
        return "turned"
    x, y, heading = poses[max(0, last - 10)]
    near = frames.get(start + last - 10, {}).values()
    if sum(math.dist(place, (x, y)) < 1.5 for place in near) >= 3:
        return "surrounded"
    side = math.cos(heading) * (now[0] - x) + math.sin(heading) * (now[1] - y)
    return "overtaken" if side < 0.25 else "driven"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("result")
    parser.add_argument("trace")
    options = parser.parse_args()
    with open(options.folder / "cases.csv", encoding="utf-8", newline="") as file:
        cases = {int(row["case"]): row for row in csv.DictReader(file)}
    with open(options.result, encoding="utf-8") as file:
        results = json.load(file)["cases"]
    runs = read_runs(options.trace)
    tracks = {}
    counts = collections.Counter()
    for result in results:
        if result["outcome"] == "success":
            continue
        case = cases[result["case"]]
        scene = case["scene"]
        if scene not in tracks:
            tracks[scene] = read_tracks(options.folder / f"tracks_{scene.lower()}.csv")
        kind = "too late"
        if result["outcome"] == "contact":
            kind = classify(tracks[scene], int(case["start_frame"]), runs[result["case"]])
        counts[kind] += 1
        print(f"case {result['case']}, {scene}, {result['time']:.1f} s: {kind}")
    print(f"{len(results)} runs, failures: "
          + (", ".join(f"{kind} {count}" for kind, count in counts.most_common()) or "none"))


if __name__ == "__main__":
    main()
