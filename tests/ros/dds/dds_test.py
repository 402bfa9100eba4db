# SPDX-License-Identifier: Apache-2.0
"""Robots that communicate over DDS in network namespaces: dds_test.py BIN SCENARIOS.

Each robot has a network namespace with its base and its navigation node; a bridge in one more
namespace connects them. The test is skipped where namespaces cannot be made (no root).
"""

import math
import signal
import sys
import unittest

from dds_system import SCENARIOS, SKIPPED, DdsTest, why_no_networks


class FleetTest(DdsTest):
    """Robots in an open hall that know each other only by their messages."""

    def begin(self, starts):
        self.prepare(list(starts))
        self.write_map()
        for name, pose in starts.items():
            start = ",".join(str(value) for value in pose)
            self.start(name, "fairway_dds_simulator", self.path("hall.yaml"), "--namespace", name,
                       f"--start={start}", "--track", self.path(f"{name}.csv"))
        nodes = {name: self.start(name, "fairway_dds_node", "--namespace", name, "--name", name,
                                  "--base-frame", f"{name}/base_link", "--no-scan",
                                  "--patience", "60")
                 for name in starts}
        self.wait_for(lambda: all(self.track(name) for name in self.names), 30, "the simulators")
        self.wait_for(lambda: all(f"receives robot {other}\n" in self.output(nodes[name])
                                  for name in starts for other in starts if other != name),
                      30, "the robots to receive each other's messages")

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

    def test_a_goal_of_the_action_is_reached_cancelled_and_refused(self):
        self.start("solo", "fairway_dds_node")
        goal = f"--goal={self.GOAL[0]},{self.GOAL[1]}"
        client = self.act("--action", goal)
        self.wait_for(lambda: self.track("solo") and self.speed("solo") > 0.3, 20,
                      "the robot to drive")
        client.send_signal(signal.SIGINT)
        code, text = self.result(client)
        self.assertEqual(code, 1)
        self.assertIn("goal accepted", text)
        self.assertIn("status 5", text)  # cancelled
        self.assertLess(self.speed("solo"), 0.05)
        code, text = self.result(self.act("--action", "--goal=900,0"))
        self.assertEqual(code, 1)
        self.assertIn("status 6, error code 204", text)
        first = self.act("--action", goal)
        self.wait_for(lambda: self.speed("solo") > 0.1, 20, "the robot to drive")
        code, text = self.result(self.act("--action", goal))
        self.assertEqual(code, 0, text)
        self.assertIn("m left", text)
        self.assertIn("status 4, error code 0", text)
        self.assertLess(self.distance("solo", self.GOAL), 0.15)
        code, text = self.result(first)
        self.assertEqual(code, 1)
        self.assertIn("status 6, error code 0: replaced by a new goal", text)

    def test_the_action_follow_path_drives_out_and_back(self):
        self.start("solo", "fairway_dds_node")
        points = [(-5.0, -3.0), (-5.0, -1.0), (-5.0, -3.0)]
        path = ",".join(f"{x},{y}" for x, y in points)
        code, text = self.result(self.act(f"--path={path}"))
        self.assertEqual(code, 0, text)
        furthest = max(y for _, _, y in self.track("solo"))
        self.assertGreater(furthest, -1.3)
        self.assertLess(self.distance("solo", points[-1]), 0.2)

    def test_a_goal_is_reached_with_simulated_time_and_stamped_commands(self):
        self.processes[0].send_signal(signal.SIGINT)
        self.processes[0].wait(10)
        options = ("--sim-time", "--stamped")
        self.start("solo", "fairway_dds_simulator", SCENARIOS / "maps" / "doorways.yaml",
                   "--start=-5,-3,1.57", "--track", self.path("simulated.csv"), *options)
        self.drive(*options)
        self.wait_for(lambda: self.track("simulated")
                      and self.distance("simulated", self.GOAL) < 0.15, 40, "the robot to arrive")
        self.assertLess(self.track("simulated")[-1][0], 1100.0)  # [s], on the simulated clock

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

    def test_a_car_follows_a_path_within_a_bound(self):
        self.prepare(["solo"])
        robot = SCENARIOS / "robots" / "car.yaml"
        self.start("solo", "fairway_dds_simulator", SCENARIOS / "maps" / "doorways.yaml", "--start=-5,-3,1.57", "--body", robot,
                   "--track", self.path("solo.csv"))
        self.start("solo", "fairway_dds_node", "--body", robot, "--max-deviation", "0.3")
        code, text = self.result(self.act("--path=-5,-3,-5,-1"))
        self.assertEqual(code, 0, text)
        self.assertLess(max(abs(x + 5.0) for _, x, _ in self.track("solo")), 0.35)
        self.assertLess(self.distance("solo", (-5.0, -1.0)), 0.2)


if __name__ == "__main__":
    if REASON := why_no_networks():
        print(f"skipped: no network namespaces here: {REASON}")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2, warnings="ignore")
