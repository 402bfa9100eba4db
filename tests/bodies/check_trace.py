#!/usr/bin/env python3
"""Judges a drive: check_trace.py TASK.json TRACE.csv. Shares nothing with what it judges.

Prints one line and exits with 0 when the drive keeps every limit of the task, touches nothing and ends
at the goal; else the first reasons, and 1. Standard library only.
"""

import csv
import json
import math
import pathlib
import sys

SPACING = 0.02  # greatest time between rows [s]
STEP = 0.001  # greatest way of any point of the body between two poses that are tested near obstacles [m]
PRINTED = 2e-9  # what the digits of a number may be off by


def read_map(path):
    """Cells of a trinary map: its frame, and whether a cell is occupied."""
    header = {}
    for line in path.read_text().splitlines():
        key, _, value = line.partition(":")
        header[key.strip()] = value.strip()
    data = (path.parent / header["image"]).read_bytes()
    fields, at = [], 0
    while len(fields) < 4:
        end = at
        while data[end : end + 1] not in (b" ", b"\n", b"\t", b"\r"):
            end += 1
        if data[at:end].startswith(b"#"):
            end = data.index(b"\n", at)
        elif end > at:
            fields.append(data[at:end])
        at = end + 1
    assert fields[0] == b"P5" and int(fields[3]) == 255
    width, height = int(fields[1]), int(fields[2])
    dark = float(header["occupied_thresh"])
    pixels = data[at : at + width * height]
    occupied = [[1.0 - pixels[(height - 1 - y) * width + x] / 255.0 > dark for x in range(width)] for y in range(height)]
    origin = [float(v) for v in header["origin"].strip("[]").split(",")]
    return {"cells": occupied, "width": width, "height": height, "resolution": float(header["resolution"]), "origin": origin}


def body_of(robot):
    """Vertices of the body, counter-clockwise, in its own frame."""
    if "footprint" in robot:
        points = [tuple(p) for p in robot["footprint"]]
        area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1]))
        return points if area > 0.0 else points[::-1]
    front, side = robot["reference_to_front"], robot["width"] / 2.0
    back = front - robot["length"]
    return [(back, -side), (front, -side), (front, side), (back, side)]


def segment_distance(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    share = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)
    share = min(1.0, max(0.0, share))
    return math.hypot(p[0] - a[0] - share * dx, p[1] - a[1] - share * dy)


def inside(p, polygon):
    return all(
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) >= 0.0
        for a, b in zip(polygon, polygon[1:] + polygon[:1])
    )


def polygons_distance(p, q):
    """Distance between two convex polygons, both counter-clockwise and closed; 0 when they meet."""
    if any(inside(v, q) for v in p) or any(inside(v, p) for v in q):
        return 0.0
    edges_p, edges_q = list(zip(p, p[1:] + p[:1])), list(zip(q, q[1:] + q[:1]))
    for a, b in edges_p:  # edges that cross although no vertex lies in the other
        for c, d in edges_q:
            side = lambda u, v, w: (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0])
            if side(a, b, c) * side(a, b, d) < 0.0 and side(c, d, a) * side(c, d, b) < 0.0:
                return 0.0
    return min(
        min(segment_distance(v, a, b) for v in p for a, b in edges_q),
        min(segment_distance(v, a, b) for v in q for a, b in edges_p),
    )


class World:
    """Distances from a body to the occupied cells of a map, in metres."""

    def __init__(self, grid, body):
        self.grid, self.body = grid, body
        self.reach = max(math.hypot(*v) for v in body)
        cells, w, h = grid["cells"], grid["width"], grid["height"]
        free = lambda x, y: 0 <= x < w and 0 <= y < h and not cells[y][x]
        # Cells inside a wall are never nearest; those that are touched first have a free neighbour.
        self.edge = [
            [cells[y][x] and (free(x - 1, y) or free(x + 1, y) or free(x, y - 1) or free(x, y + 1)) for x in range(w)]
            for y in range(h)
        ]

    def placed(self, pose):
        """The body in the map's own frame."""
        ox, oy, yaw = self.grid["origin"]
        c, s = math.cos(yaw), math.sin(yaw)
        dx, dy = pose[0] - ox, pose[1] - oy
        x, y = c * dx + s * dy, c * dy - s * dx
        c, s = math.cos(pose[2] - yaw), math.sin(pose[2] - yaw)
        return [(x + c * u - s * v, y + s * u + c * v) for u, v in self.body]

    def distance(self, pose, most, every_cell=False):
        """Distance to the nearest occupied cell or the outside of the map, at most `most`."""
        res, cells = self.grid["resolution"], self.grid["cells"] if every_cell else self.edge
        body = self.placed(pose)
        left, right = min(v[0] for v in body), max(v[0] for v in body)
        low, high = min(v[1] for v in body), max(v[1] for v in body)
        best = min(most, left, low, self.grid["width"] * res - right, self.grid["height"] * res - high)
        if best <= 0.0:
            return 0.0
        first_x, last_x = max(0, int((left - best) / res)), min(self.grid["width"] - 1, int((right + best) / res))
        first_y, last_y = max(0, int((low - best) / res)), min(self.grid["height"] - 1, int((high + best) / res))
        edges = list(zip(body, body[1:] + body[:1]))
        half = res * math.sqrt(0.5)
        for y in range(first_y, last_y + 1):
            row = cells[y]
            for x in range(first_x, last_x + 1):
                if not row[x]:
                    continue
                middle = ((x + 0.5) * res, (y + 0.5) * res)
                if not inside(middle, body) and min(segment_distance(middle, a, b) for a, b in edges) - half >= best:
                    continue
                square = [(x * res, y * res), ((x + 1) * res, y * res), ((x + 1) * res, (y + 1) * res), (x * res, (y + 1) * res)]
                best = min(best, polygons_distance(body, square))
                if best <= 0.0:
                    return 0.0
        return best


def moved(pose, twist, time):
    u, v, r = twist
    x, y, h = pose
    if abs(r * time) < 1e-9:
        h = pose[2] + 0.5 * r * time
        dx, dy = u * time, v * time
        return (x + dx * math.cos(h) - dy * math.sin(h), y + dx * math.sin(h) + dy * math.cos(h), pose[2] + r * time)
    # Around the fixed point of the motion, which lies at (-v / r, u / r) in the body.
    cx, cy = x - v / r * math.cos(h) - u / r * math.sin(h), y - v / r * math.sin(h) + u / r * math.cos(h)
    h += r * time
    return (cx + v / r * math.cos(h) + u / r * math.sin(h), cy + v / r * math.sin(h) - u / r * math.cos(h), h)


def turn(a, b):
    return math.remainder(b - a, 2.0 * math.pi)


def least_clearance(world, rows):
    """Whether anything is touched: from a pose with clearance d nothing is before a point has moved by d.

    Returns the least distance at the poses that were looked at, and the time of a contact, if any."""
    least, skip = 2.0, 0.0
    for (time, pose, twist), (after, _, _) in zip(rows, rows[1:]):
        speed = max(math.hypot(twist[0] - twist[2] * q[1], twist[1] + twist[2] * q[0]) for q in world.body)
        way, end = 0.0, speed * (after - time)
        while True:
            if skip > end - way:
                skip -= end - way
                break
            way += skip
            distance = world.distance(moved(pose, twist, way / speed if speed > 0.0 else 0.0), least + 0.3)
            if distance <= 0.0:
                return 0.0, time
            least = min(least, distance)
            skip = max(STEP, 0.9 * distance)
            if speed <= 0.0:
                break
    return least, None


def check_limits(robot, rows, complain):
    kind = robot["kind"]
    steered = kind in ("car", "tricycle")
    wheels = robot.get("wheels", {"type": None})
    before, angle, angle_time, last_error = (0.0, 0.0, 0.0), 0.0, 0.0, 0.0
    last_time = rows[0][0]
    for time, _, (u, v, r) in rows:
        def most(value, limit, what, slack=2 * PRINTED):
            if value > limit + slack:
                complain(f"{what} {value:.6f} above {limit:.6f} at {time:.2f} s")
        most(u, robot["linear_max"], "linear")
        most(-u, -robot["linear_min"], "backward")
        most(abs(r), robot["angular_max"], "angular")
        most(abs(v), robot["lateral_max"] if kind == "omni" else 0.0, "lateral")
        gap = time - last_time if time > last_time else SPACING
        slack = 4 * PRINTED + 1e-9
        most(abs(u - before[0]), robot["linear_acceleration"] * gap, "change of linear", slack)
        most(abs(r - before[2]), robot["angular_acceleration"] * gap, "change of angular", slack)
        if kind == "omni":
            most(abs(v - before[1]), robot["lateral_acceleration"] * gap, "change of lateral", slack)
        if wheels["type"] == "differential":
            most(abs(u) + wheels["track"] / 2.0 * abs(r), wheels["speed_max"], "wheel speed")
        elif wheels["type"] == "steered":
            most(math.hypot(u, robot["wheelbase"] * r), wheels["speed_max"], "wheel speed")
        elif wheels["type"] == "mecanum":
            most(abs(u) + abs(v) + wheels["half_sum"] * abs(r), wheels["speed_max"], "wheel speed")
        elif wheels["type"] == "swerve":
            for x, y in wheels["positions"]:
                most(math.hypot(u - r * y, v + r * x), wheels["speed_max"], "wheel speed")
        if steered and abs(u) < 1e-7:
            most(abs(r), 0.0, "angular at standstill")
        elif steered:
            error = PRINTED * robot["wheelbase"] / abs(u) * 4.0
            delta = math.atan(robot["wheelbase"] * r / u)
            most(abs(delta), robot["steering_max"], "steering angle", error)
            allowed = robot["steering_rate_max"] * (time - angle_time if time > angle_time else SPACING)
            most(abs(delta - angle), allowed, "change of steering", error + last_error)
            angle, angle_time, last_error = delta, time, error
        before, last_time = (u, v, r), time


def judge(task_file, trace_file):
    """The reasons why a drive fails, and its figures."""
    task = json.loads(task_file.read_text())
    reasons = []
    complain = lambda text: reasons.append(text) if len(reasons) < 5 else None
    with open(trace_file, newline="") as file:
        table = list(csv.DictReader(file))
    rows = [
        (float(t["time"]), (float(t["x"]), float(t["y"]), float(t["heading"])),
         (float(t["linear"]), float(t.get("lateral") or 0.0), float(t["angular"])))
        for t in table
    ]
    for (a, pose, twist), (b, after, _) in zip(rows, rows[1:]):
        if not 0.0 < b - a <= SPACING + 1e-9:
            complain(f"rows {b - a:.4f} s apart at {a:.2f} s")
        reached = moved(pose, twist, b - a)
        if math.dist(reached[:2], after[:2]) > 1e-7 or abs(turn(reached[2], after[2])) > 1e-7:
            complain(f"the command does not lead to the next pose at {a:.2f} s")
    start, goal, tolerance = task["start"], task["goal"], task["tolerances"]
    if rows[0][0] != 0.0 or math.dist(rows[0][1][:2], start[:2]) > 1e-6 or abs(turn(rows[0][1][2], start[2])) > 1e-6:
        complain("does not begin at the start")
    end, final = rows[-1][1], rows[-1][2]
    if math.dist(end[:2], goal[:2]) > tolerance["position"] or abs(turn(end[2], goal[2])) > tolerance["heading"]:
        complain(f"ends {math.dist(end[:2], goal[:2]):.3f} m and {abs(turn(end[2], goal[2])):.3f} rad from the goal")
    if final != (0.0, 0.0, 0.0):
        complain("does not stand at the end")
    if rows[-1][0] > task["time_limit"]:
        complain(f"takes {rows[-1][0]:.2f} s, the limit is {task['time_limit']} s")
    check_limits(task["robot"], rows, complain)
    world = World(read_map(task_file.parent / task["map"]), body_of(task["robot"]))
    if world.distance(rows[0][1], 0.1, every_cell=True) <= 0.0:
        complain("touches an obstacle at the start")
    clearance, contact = least_clearance(world, rows)
    if clearance <= 0.0:
        complain(f"touches an obstacle at {contact:.2f} s")
    return reasons, rows[-1][0], clearance, task.get("witness", {}).get("time")


def main():
    reasons, time, clearance, _ = judge(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
    print(f"{pathlib.Path(sys.argv[2]).stem}: {time:.2f} s, {clearance:.4f} m: " + ("; ".join(reasons) or "sound"))
    return 1 if reasons else 0


if __name__ == "__main__":
    sys.exit(main())
