# SPDX-License-Identifier: Apache-2.0
"""Robots that communicate over DDS in network namespaces: dds_test.py BIN SCENARIOS.

Each robot has a network namespace with its base and its navigation node; a bridge in one more
namespace connects them. The test is skipped where namespaces cannot be made (no root).
"""

import csv
import itertools
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SKIPPED = 77
BIN, SCENARIOS = (pathlib.Path(argument) for argument in sys.argv[1:3])
RADIUS = 0.25        # [m], of every robot: the default setting
PREFIX = f"fw{os.getpid() % 10000}"


def run(*command, check=True):
    return subprocess.run(command, check=check, capture_output=True, text=True)


def why_no_networks():
    """Why network namespaces and bridges cannot be made; empty if they can."""
    space = f"{PREFIX}-probe"
    try:
        run("ip", "netns", "add", space)
        try:
            run("ip", "-n", space, "link", "add", "bridge", "type", "bridge")
        finally:
            run("ip", "netns", "del", space)
    except OSError as error:
        return str(error)
    except subprocess.CalledProcessError as error:
        return error.stderr.strip()
    return ""


class Network:
    """A bridge, and a namespace per robot that is connected to it."""

    def __init__(self, names):
        self.spaces = [f"{PREFIX}-switch"] + [f"{PREFIX}-{name}" for name in names]
        self.make(names)

    def make(self, names):
        for space in self.spaces:
            run("ip", "netns", "add", space)
        switch = self.spaces[0]
        run("ip", "-n", switch, "link", "add", "bridge", "type", "bridge", "forward_delay", "0",
            "mcast_snooping", "0")
        run("ip", "-n", switch, "link", "set", "bridge", "up")
        for number, name in enumerate(names, 1):
            space = f"{PREFIX}-{name}"
            run("ip", "-n", switch, "link", "add", name, "type", "veth", "peer", "name", "eth0",
                "netns", space)
            run("ip", "-n", switch, "link", "set", name, "master", "bridge", "up")
            run("ip", "-n", space, "addr", "add", f"10.77.0.{number}/24", "dev", "eth0")
            run("ip", "-n", space, "link", "set", "eth0", "up")
            run("ip", "-n", space, "link", "set", "lo", "up")

    def cut(self, name):
        run("ip", "-n", self.spaces[0], "link", "set", name, "nomaster")

    def join(self, name):
        run("ip", "-n", self.spaces[0], "link", "set", name, "master", "bridge")

    def close(self):
        for space in self.spaces:
            run("ip", "netns", "del", space, check=False)


class DdsTest(unittest.TestCase):
    """Robots by name in self.names, their goals in self.goals."""

    def prepare(self, names):
        self.names = names
        self.folder = tempfile.TemporaryDirectory(prefix="fairway-dds-")
        self.network = Network(names)
        self.processes = []

    def tearDown(self):
        for process in self.processes:
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
        for process in self.processes:
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            process.log.seek(0)
            text = process.log.read()
            if text:
                print(f"--- {process.args}\n{text[-2000:]}")
            process.log.close()
        self.network.close()
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write_map(self):
        width, height = 200, 200  # 10 m x 10 m, open
        with open(self.path("hall.pgm"), "wb") as image:
            image.write(f"P5\n{width} {height}\n255\n".encode() + b"\xfe" * (width * height))
        with open(self.path("hall.yaml"), "w", encoding="utf-8") as header:
            header.write("image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                         "occupied_thresh: 0.65\nfree_thresh: 0.25\n")

    def start(self, robot, program, *arguments):
        log = open(self.path(f"log{len(self.processes)}"), "w+", encoding="utf-8")
        process = subprocess.Popen(
            ["ip", "netns", "exec", f"{PREFIX}-{robot}", BIN / program,
             *[str(argument) for argument in arguments]],
            stdout=log, stderr=subprocess.STDOUT)
        process.log = log
        self.processes.append(process)
        return process

    def send_goal(self, name, goal):
        x, y = goal
        self.start(name, "fairway_dds_goal", "--namespace", name, f"--goal={x},{y}")

    def track(self, name):
        """The true track [(time, x, y)] from the robot's simulator."""
        rows = []
        if not os.path.exists(self.path(f"{name}.csv")):
            return rows
        with open(self.path(f"{name}.csv"), encoding="utf-8") as file:
            for row in csv.reader(file):
                try:
                    time_, x, y, _ = (float(value) for value in row)
                except ValueError:  # the header, or an incomplete line
                    continue
                rows.append((time_, x, y))
        return rows

    def distance(self, name, goal):
        _, x, y = self.track(name)[-1]
        return math.hypot(x - goal[0], y - goal[1])

    def wait_for(self, condition, seconds, what):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if condition():
                return
            time.sleep(0.1)
        self.fail(f"waited {seconds} s for {what}")

    def least_room(self):
        """The least distance between any two bodies over all tracks [m]; negative: contact."""
        tracks = [self.track(name) for name in self.names]
        least = math.inf
        for one, other in itertools.combinations(tracks, 2):
            j = 0
            for time_, x, y in one:
                while j + 1 < len(other) and other[j + 1][0] <= time_:
                    j += 1
                least = min(least, math.hypot(x - other[j][1], y - other[j][2]))
        return least - 2.0 * RADIUS

    def speed(self, name):
        rows = self.track(name)[-10:]
        (t0, x0, y0), (t1, x1, y1) = rows[0], rows[-1]
        return math.hypot(x1 - x0, y1 - y0) / max(t1 - t0, 1e-9)


class FleetTest(DdsTest):
    """Robots in an open hall that know each other only by their messages."""

    def begin(self, starts):
        self.prepare(list(starts))
        self.write_map()
        for name, pose in starts.items():
            start = ",".join(str(value) for value in pose)
            self.start(name, "fairway_dds_simulator", self.path("hall.yaml"), "--namespace", name,
                       f"--start={start}", "--track", self.path(f"{name}.csv"))
            self.start(name, "fairway_dds_node", "--namespace", name, "--name", name,
                       "--base-frame", f"{name}/base_link", "--no-scan", "--patience", "60")
        self.wait_for(lambda: all(self.track(name) for name in self.names), 30, "the simulators")
        time.sleep(2.0)  # until all robots have received each other's messages

    def finish(self, goals):
        for name, goal in goals.items():
            self.wait_for(lambda name=name, goal=goal: self.distance(name, goal) < 0.2, 90,
                          f"{name} to arrive")
        room = self.least_room()
        print(f"least distance between two bodies: {room:.2f} m")
        self.assertGreater(room, 0.0)

    def test_two_exchange_places_although_one_is_disconnected_for_a_while(self):
        goals = {"red": (8.0, 4.0), "blue": (2.0, 4.3)}
        self.begin({"red": (2.0, 4.0, 0.0), "blue": (8.0, 4.3, math.pi)})
        for name, goal in goals.items():
            self.send_goal(name, goal)
        self.wait_for(lambda: all(self.speed(name) > 0.4 for name in self.names), 20,
                      "both to drive")
        self.network.cut("blue")
        self.wait_for(lambda: all(self.speed(name) < 0.05 for name in self.names), 6,
                      "both to stop without messages")
        for name, goal in goals.items():
            self.assertGreater(self.distance(name, goal), 1.0, name)
        self.network.join("blue")
        self.finish(goals)

    def test_four_exchange_places(self):
        center, radius = (5.0, 5.0), 3.5
        starts, goals = {}, {}
        for number, name in enumerate(("east", "north", "west", "south")):
            angle = 0.5 * math.pi * number
            away = (radius * math.cos(angle), radius * math.sin(angle))
            starts[name] = (center[0] + away[0], center[1] + away[1], angle + math.pi)
            goals[name] = (center[0] - away[0], center[1] - away[1])
        self.begin(starts)
        for name, goal in goals.items():
            self.send_goal(name, goal)
        self.finish(goals)


class DriveTest(DdsTest):
    """One robot with a lidar in a map of the project, with ROS 2's default names."""

    GOAL = (-5.0, 0.0)

    def setUp(self):
        self.prepare(["solo"])
        self.simulator = self.start(
            "solo", "fairway_dds_simulator", SCENARIOS / "maps" / "doorways.yaml",
            "--start=-5,-3,1.57", "--track", self.path("solo.csv"))

    def drive(self, *options):
        node = self.start("solo", "fairway_dds_node", *options)
        self.start("solo", "fairway_dds_goal", f"--goal={self.GOAL[0]},{self.GOAL[1]}",
                   "--frame", "odom" if "--no-map" in options else "map")
        return node

    def test_a_goal_is_reached_with_map_and_scan(self):
        self.drive()
        self.wait_for(lambda: self.track("solo") and self.distance("solo", self.GOAL) < 0.15, 40,
                      "the robot to arrive")

    def test_the_robot_brakes_when_the_node_is_terminated(self):
        node = self.drive("--no-map")
        self.wait_for(lambda: self.track("solo") and self.speed("solo") > 0.5, 20,
                      "the robot to drive")
        node.send_signal(signal.SIGTERM)
        self.assertEqual(node.wait(10), 0)
        self.wait_for(lambda: self.speed("solo") < 0.01, 5, "the robot to stop")

    def test_bad_options_are_named(self):
        for options, message in (
                (["--set", "mpc.step_length=x"], "fairway: mpc.step_length: expected a number from"),
                (["--no-map", "--no-scan"], "fairway: use_map, use_scan: expected one of them"),
                (["--domain", "900"], "fairway: --domain: Value 900 not in range")):
            node = self.start("solo", "fairway_dds_node", *options)
            self.assertEqual(node.wait(10), 2)
            node.log.seek(0)
            text = node.log.read()
            self.assertTrue(text.startswith(message), text)
            self.assertEqual(text.count("\n"), 1, text)
            node.log.truncate(0)


class BodyTest(DdsTest):
    """Robots with their true outline: their commands are more than a twist."""

    def drive(self, body, goal):
        self.prepare(["solo"])
        robot = SCENARIOS / "robots" / f"{body}.yaml"
        self.start("solo", "fairway_dds_simulator", SCENARIOS / "maps" / "doorways.yaml", "--start=-5,-3,1.57", "--body", robot,
                   "--track", self.path("solo.csv"))
        self.start("solo", "fairway_dds_node", "--body", robot)
        self.start("solo", "fairway_dds_goal", f"--goal={goal[0]},{goal[1]},1.57")
        self.wait_for(lambda: self.track("solo") and self.distance("solo", goal) < 0.15, 60, "the robot to arrive")

    def test_a_car_reaches_its_goal(self):
        self.drive("car", (-4.8, 1.0))

    def test_a_mecanum_base_reaches_its_goal(self):
        self.drive("mecanum", (-5.0, -1.0))


if __name__ == "__main__":
    if REASON := why_no_networks():
        print(f"skipped: no network namespaces here: {REASON}")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings="ignore")
