#!/usr/bin/env python3
"""The checker of traces finds each kind of fault: drives that are sound but for one thing."""

import json
import math
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks/cases"))
import check_trace
import make_body_tasks as make_tasks

DT = 0.02


def straight_drive(length, speed, acceleration):
    """Commands that accelerate, cruise and brake along the heading."""
    ramp = round(speed / acceleration / DT)
    cruise = round((length - speed * ramp * DT) / speed / DT)
    speeds = [acceleration * DT * (i + 0.5) for i in range(ramp)] + [speed] * cruise
    return speeds + [acceleration * DT * (i + 0.5) for i in reversed(range(ramp))]


def rows_of(start, commands):
    pose, rows = tuple(start), []
    for i, (u, v, r) in enumerate(commands + [(0.0, 0.0, 0.0)]):
        rows.append((i * DT, pose, (u, v, r)))
        pose = check_trace.moved(pose, (u, v, r), DT)
    return rows


class Checker(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)
        commands = [(u, 0.0, 0.0) for u in straight_drive(3.0, 0.5, 0.5)]
        self.rows = rows_of((1.0, 0.7, 0.0), commands)
        self.robot = make_tasks.unicycle(1.0, 0.6, 0.5)
        self.goal = self.rows[-1][1]

    def tearDown(self):
        self.scratch.cleanup()

    def reasons(self, rows=None, **changes):
        robot = {**self.robot, **changes}
        task = ([(0, 0, 6, 1.4)], robot, (1.0, 0.7, 0.0), self.goal, False, 0.0)
        make_tasks.write(self.folder, "task", task)
        lines = ["time,robot,x,y,heading,linear,angular,lateral"]
        for time, (x, y, h), (u, v, r) in rows or self.rows:
            lines.append(f"{time:.2f},robot,{x:.9f},{y:.9f},{h:.9f},{u:.9f},{r:.9f},{v:.9f}")
        (self.folder / "task.csv").write_text("\n".join(lines) + "\n")
        return " ".join(check_trace.judge(self.folder / "task.json", self.folder / "task.csv")[0])

    def test_a_sound_drive_has_no_faults(self):
        self.assertEqual(self.reasons(), "")

    def test_speed_and_acceleration(self):
        self.assertIn("linear", self.reasons(linear_max=0.45))
        self.assertIn("change of linear", self.reasons(linear_acceleration=0.4))

    def test_wheels(self):
        self.assertIn("wheel", self.reasons(wheels={"type": "differential", "track": 0.5, "speed_max": 0.45}))

    def test_contact_between_poses(self):
        # Wider than the corridor of 1.4 m; and longer than what is left behind the goal.
        self.assertIn("touches", self.reasons(width=1.41))
        self.assertIn("touches", self.reasons(reference_to_front=3.1, length=3.6))

    def test_a_pose_that_the_command_does_not_lead_to(self):
        rows = list(self.rows)
        time, (x, y, h), twist = rows[50]
        rows[50] = (time, (x + 1e-5, y, h), twist)
        self.assertIn("does not lead", self.reasons(rows))

    def test_steering(self):
        car = make_tasks.car(1.0, 0.6, 0.5)
        speeds = straight_drive(3.0, 0.5, 0.5)
        bend = [(u, 0.0, u * math.tan(min(0.3, 0.8 * DT * i)) / 1.0) for i, u in enumerate(speeds)]
        quick = [(u, 0.0, u * math.tan(min(0.3, 1.2 * DT * i)) / 1.0) for i, u in enumerate(speeds)]
        tight = [(u, 0.0, u * math.tan(0.7) / 1.0) for u in speeds]
        for commands, fault in ((bend, ""), (quick, "change of steering"), (tight, "steering angle")):
            rows = rows_of((1.0, 0.7, 0.0), commands)
            found = []
            check_trace.check_limits(car, rows, found.append)
            self.assertEqual(any("steering" in f for f in found), bool(fault), found[:2])
            self.assertTrue(not fault or any(fault in f for f in found))

    def test_distance_of_polygons(self):
        square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        self.assertEqual(check_trace.polygons_distance(square, [(1, 1), (2, 1), (2, 2), (1, 2)]), 0.0)
        self.assertAlmostEqual(check_trace.polygons_distance(square, [(2, 2), (3, 2), (3, 3), (2, 3)]), math.sqrt(2))
        cross = [(0.4, -1), (0.6, -1), (0.6, 2), (0.4, 2)]
        self.assertEqual(check_trace.polygons_distance(square, cross), 0.0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
