#!/usr/bin/env python3
"""Writes tasks for bodies into a folder: make_body_tasks.py FOLDER [--random N --seed S]. Standard library only.

Passages as rectangles of free space, mirrored, turned by any angle and drawn again as cells; bodies and
bases of other sizes than the shared tasks have. Every task leaves several centimetres.
"""

import argparse
import json
import math
import pathlib
import random


def corner(width, length=6.0):
    return [(0, 0, length, width), (length - width, 0, length, length)]


def aisle(width):
    middle = 2.0
    return [(0, 0, 3, 4), (3, middle - width / 2, 8, middle + width / 2), (8, 0, 11, 4)]


def chicane(opening, between):
    second = 4.2 + between
    return [(0, 0, 4, 3), (4, 0, 4.2, opening), (4.2, 0, second, 3), (second, 3 - opening, second + 0.2, 3), (second + 0.2, 0, second + 4, 3)]


def bay(lane, width, depth, at=4.5):
    return [(0, 0, 9, lane), (at - width / 2, -depth, at + width / 2, 0)]


def door(corridor, width):
    return [(0, 0, 8, corridor), (4 - width / 2, corridor, 4 + width / 2, corridor + 0.2), (1, corridor + 0.2, 7, corridor + 3.5)]


def limits(**changes):
    base = {"linear_min": -0.6, "linear_max": 1.0, "angular_max": 1.2, "linear_acceleration": 0.8, "angular_acceleration": 2.0}
    return {**base, **changes}


def unicycle(length, width, front, track=0.6):
    return {"kind": "unicycle", "length": length, "width": width, "reference_to_front": front, **limits(),
            "wheels": {"type": "differential", "track": track, "speed_max": 1.2}}


def car(length=1.6, width=0.7, front=1.3):
    return {"kind": "car", "length": length, "width": width, "reference_to_front": front, "wheelbase": 1.0, "steering_max": 0.6,
            "steering_rate_max": 0.8, **limits(linear_max=1.2, angular_max=1.5, angular_acceleration=3.0)}


def tricycle(steering=1.2):
    return {"kind": "tricycle", "length": 1.7, "width": 0.75, "reference_to_front": 1.4, "wheelbase": 1.2, "steering_max": steering,
            "steering_rate_max": 1.0, **limits(linear_acceleration=0.6, angular_max=1.0), "wheels": {"type": "steered", "speed_max": 1.5}}


def omni(length, width, wheels):
    return {"kind": "omni", "length": length, "width": width, "reference_to_front": length / 2, "lateral_max": 0.6,
            "lateral_acceleration": 0.8, **limits(linear_min=-1.0), "wheels": wheels}


MECANUM = {"type": "mecanum", "half_sum": 0.9, "speed_max": 1.2}
SWERVE = {"type": "swerve", "speed_max": 1.0, "positions": [[0.7, 0.25], [0.7, -0.25], [-0.7, 0.25], [-0.7, -0.25]]}
HEXAGON = {**unicycle(1.0, 0.6, 0.5), "footprint": [[0.8, -0.2], [0.8, 0.2], [0.4, 0.4], [-0.6, 0.35], [-0.6, -0.35], [0.4, -0.4]]}
UP = math.pi / 2

# name: rectangles, robot, start, goal, mirrored, turned by [rad]; "yaw": the map's frame is turned instead
TASKS = {
    "corner_unicycle_turned": (corner(1.4), unicycle(1.7, 0.8, 0.85), (1.2, 0.7, 0), (5.3, 4.7, UP), False, 0.35),
    "corner_unicycle_yaw": (corner(1.4), unicycle(1.7, 0.8, 0.85), (1.2, 0.7, 0), (5.3, 4.7, UP), False, "yaw"),
    "corner_car_mirrored": (corner(1.6), car(), (0.8, 0.8, 0), (5.2, 4.2, UP), True, 0.0),
    "corner_swerve_turned": (corner(1.35), omni(1.9, 0.6, SWERVE), (1.3, 0.675, 0), (5.325, 4.6, UP), False, 0.58),
    "corner_polygon_mirrored": (corner(1.3), HEXAGON, (1.0, 0.65, 0), (5.35, 4.7, UP), True, -0.4),
    "aisle_front_axle_turned": (aisle(1.0), unicycle(1.6, 0.75, 0.35), (1.2, 1.4, UP), (9.4, 1.6, -UP), False, 0.8),
    "chicane_unicycle_mirrored": (chicane(1.25, 2.1), unicycle(1.7, 0.8, 0.85), (1.2, 1.5, 0), (8.8, 1.5, 0), True, 0.2),
    "chicane_car_turned": (chicane(1.45, 2.8), car(), (0.8, 1.5, 0), (9.0, 1.5, 0), False, -1.0),
    "dock_tricycle_mirrored": (bay(2.5, 0.98, 1.9), tricycle(), (1.2, 1.25, 0), (4.5, -1.5, UP), True, 1.3),
    "dock_unicycle_turned": (bay(1.5, 0.95, 1.4), unicycle(1.2, 0.7, 0.9), (1.0, 0.75, 0), (4.5, -1.05, UP), False, -0.52),
    "dock_front_axle_mirrored": (bay(1.9, 1.0, 1.6), unicycle(1.3, 0.7, 0.3), (1.6, 0.95, 0), (4.5, -0.4, UP), True, 0.0),
    "parallel_car_mirrored": (bay(2.2, 2.6, 0.92), car(), (2.0, 0.8, 0), (4.0, -0.45, 0), True, 0.15),
    "slot_mecanum_turned": (bay(1.05, 1.38, 1.0), omni(1.2, 0.8, MECANUM), (1.0, 0.52, 0), (4.5, -0.5, 0), False, 1.05),
    "door_car_turned": (door(2.6, 1.15), car(), (1.0, 1.3, 0), (4.0, 4.2, UP), False, 2.1),
    "uturn_tricycle_mirrored": ([(0, 0, 9, 2.45)], tricycle(0.9), (2.0, 0.8, 0), (2.4, 1.65, math.pi), True, 0.0),
}


def moved(pose, mirrored, angle):
    x, y, heading = pose
    if mirrored:
        y, heading = -y, -heading
    c, s = math.cos(angle), math.sin(angle)
    return [c * x - s * y, s * x + c * y, math.remainder(heading + angle, 2 * math.pi)]


def write(folder, name, task):
    rectangles, robot, start, goal, mirrored, angle = task
    yaw = 0.35 if angle == "yaw" else 0.0
    angle = 0.0 if angle == "yaw" else angle
    resolution = 0.05 if angle == 0.0 else 0.025
    corners = [moved((x, y, 0), mirrored, angle)[:2] for a, b, c, d in rectangles for x, y in ((a, b), (c, b), (c, d), (a, d))]
    low = [min(p[i] for p in corners) - 0.2 for i in (0, 1)]
    high = [max(p[i] for p in corners) + 0.2 for i in (0, 1)]
    width, height = (math.ceil((h - l) / resolution) for l, h in zip(low, high))
    pixels = bytearray()
    for row in range(height - 1, -1, -1):
        for column in range(width):
            x, y, _ = moved((low[0] + (column + 0.5) * resolution, low[1] + (row + 0.5) * resolution, 0), False, -angle)
            if mirrored:
                y = -y
            free = any(a <= x <= c and b <= y <= d for a, b, c, d in rectangles)
            pixels.append(254 if free else 0)
    (folder / f"{name}.pgm").write_bytes(f"P5\n{width} {height}\n255\n".encode() + pixels)
    origin = moved((low[0], low[1], 0), False, yaw)
    (folder / f"{name}.yaml").write_text(
        f"image: {name}.pgm\nmode: trinary\nresolution: {resolution}\norigin: [{origin[0]}, {origin[1]}, {yaw}]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"
    )
    ends = [moved(moved(pose, mirrored, angle), False, yaw) for pose in (start, goal)]
    content = {"map": f"{name}.yaml", "robot": robot, "start": ends[0], "goal": ends[1],
               "tolerances": {"position": 0.01, "heading": 0.0175, "linear": 0.02, "angular": 0.02}, "time_limit": 60.0}
    (folder / f"{name}.json").write_text(json.dumps(content, indent=1) + "\n")


def corner_width(length, width, clearance):
    """The narrowest L-corner that a body passes with a clearance, however it moves; and both corridors."""
    return max((length / 2 + width + clearance * (1 + math.sqrt(2))) / math.sqrt(2), width + 2 * clearance + 0.1)


KINDS = ["corner_unicycle", "corner_omni", "corner_car", "aisle", "chicane", "dock_unicycle", "dock_tricycle", "slot", "door", "parallel",
         "uturn"]


def random_task(draw, kinds):
    """A passage of one of the kinds for a random body, with 5 to 10 cm of clearance. @return kind and task"""
    clearance, length = draw.uniform(0.05, 0.1), draw.uniform(0.8, 2.4)
    width = draw.uniform(0.4, 0.9) * min(1.0, length / 1.2)
    base = omni(length, width, draw.choice([MECANUM, SWERVE]))
    turned = draw.random() < 0.5, draw.choice([0.0, draw.uniform(-3.0, 3.0)])
    kind = draw.choice(kinds)
    if kind in ("corner_unicycle", "corner_omni"):
        robot = base if kind == "corner_omni" else unicycle(length, width, length / 2)
        opening, reach = corner_width(length, width, clearance), max(5.0, 3.0 * length)
        ends = (length / 2 + 0.3, opening / 2, 0), (reach - opening / 2, reach - length / 2 - 0.3, UP)
        return kind, (corner(opening, reach), robot, *ends, *turned)
    if kind == "corner_car":
        return kind, (corner(draw.uniform(1.45, 1.7)), car(), (0.8, 0.8, 0), (5.2, 4.2, UP), *turned)
    if kind == "aisle":
        length = min(length, 1.9)
        robot = unicycle(length, width, draw.uniform(0.3, 0.7) * length)
        return kind, (aisle(width + 2 * clearance + 0.04), robot, (1.2, 1.8, UP), (9.4, 1.8, -UP), *turned)
    if kind == "chicane":
        length = min(length, 1.9)
        walls = chicane(1.25 * width + 2 * clearance + 0.25, length + 0.4)
        return kind, (walls, unicycle(length, width, length / 2), (1.4, 1.5, 0), (6.6 + length, 1.5, 0), *turned)
    if kind == "dock_unicycle":
        length = min(length, 1.6)
        front = draw.uniform(0.6, 0.85) * length
        lane = math.hypot(front, width / 2) + width / 2 + 2 * clearance + 0.3
        walls = bay(lane, width + 2 * clearance + 0.02, length + 0.4)
        return kind, (walls, unicycle(length, width, front), (1.2, lane / 2, 0), (4.5, -front - 0.15, UP), *turned)
    if kind == "dock_tricycle":
        walls = bay(draw.uniform(2.4, 2.8), 0.77 + 2 * clearance, 1.9)
        return kind, (walls, tricycle(draw.uniform(1.0, 1.3)), (1.2, 1.25, 0), (4.5, -1.5, UP), *turned)
    if kind == "slot":
        length = min(length, 1.5)
        robot = omni(length, width, draw.choice([MECANUM, SWERVE]))
        walls = bay(width + 2 * clearance + 0.1, length + 2 * clearance + 0.03, width + 0.15)
        return kind, (walls, robot, (length / 2 + 0.3, width / 2 + clearance + 0.05, 0), (4.5, -width / 2 - 0.07, 0), *turned)
    if kind == "door":
        return kind, (door(2.6, 0.95 + 2 * clearance), car(), (1.0, 1.3, 0), (4.0, 4.2, UP), *turned)
    if kind == "parallel":
        walls = bay(2.2, draw.uniform(2.45, 2.7), 0.75 + 2 * clearance)
        return kind, (walls, car(), (2.0, 0.8, 0), (4.0, -0.45, 0), *turned)
    lane = [(0, 0, 9, draw.uniform(2.35, 2.6))]
    return kind, (lane, tricycle(draw.uniform(0.85, 1.2)), (2.0, 0.7, 0), (2.4, 1.6, math.pi), *turned)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--random", type=int, default=0, help="as many random tasks instead")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", type=lambda text: text.split(","), default=KINDS, help="of random tasks, such as dock_unicycle,slot")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    draw = random.Random(given.seed)
    tasks = dict(TASKS)
    if given.random:
        drawn = [random_task(draw, given.kinds) for _ in range(given.random)]
        tasks = {f"{i:03}_{kind}": task for i, (kind, task) in enumerate(drawn)}
    for name, task in tasks.items():
        write(given.folder, name, task)


if __name__ == "__main__":
    main()
