# SPDX-License-Identifier: Apache-2.0
"""Robots in network namespaces that a bridge connects, each with its own programs."""

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

    def output(self, process):
        """What the process has printed until now."""
        with open(process.log.name, encoding="utf-8") as log:
            return log.read()

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

    def act(self, *options):
        return self.start("solo", "fairway_dds_goal", *options)

    def result(self, process):
        """Exit code and output of a program that sends a goal of an action."""
        code = process.wait(60)
        process.log.seek(0)
        text = process.log.read()
        process.log.truncate(0)
        return code, text
