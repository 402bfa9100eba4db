# SPDX-License-Identifier: Apache-2.0
"""Orders driven by robots of DDS and of ROS 1: linked_robots_test.py BIN SCENARIOS DATA ROS_PACKAGE.

The robots are the simulators of Fairway's nodes, in real time. Skipped without mosquitto.
"""

import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77
BIN, SCENARIOS, DATA, PACKAGE = (pathlib.Path(argument) for argument in sys.argv[1:5])
MAP = SCENARIOS / "maps" / "workshop.yaml"
LOOPBACK = ("<CycloneDDS><Domain><General><Interfaces><NetworkInterface name='lo'/></Interfaces>"
            "<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto"
            "</ParticipantIndex><Peers><Peer address='127.0.0.1'/></Peers></Discovery></Domain>"
            "</CycloneDDS>")

try:
    from fleet_master import Broker, Fleet, free_port, wait_until
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(SKIPPED)

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "ros" / "ros1"))


def lane(order_id, *points, width=0.4):
    """An order along a chain of straight edges with corridors."""
    nodes = [{"nodeId": f"n{i}", "sequenceId": 2 * i, "released": True, "actions": [],
              "nodePosition": {"x": x, "y": y, "mapId": MAP.stem, "allowedDeviationXY": 0.3}}
             for i, (x, y) in enumerate(points)]
    edges = [{"edgeId": f"e{i}", "sequenceId": 2 * i + 1, "released": True, "actions": [],
              "startNodeId": f"n{i}", "endNodeId": f"n{i + 1}",
              "corridor": {"leftWidth": width, "rightWidth": width,
                           "corridorRefPoint": "KINEMATICCENTER"}}
             for i in range(len(points) - 1)]
    return {"orderId": order_id, "orderUpdateId": 0, "nodes": nodes, "edges": edges}


def finished(order_id):
    return lambda s: s["orderId"] == order_id and not s["nodeStates"] and not s["driving"]


def position(state):
    return state["agvPosition"]["x"], state["agvPosition"]["y"]


class LinkedRobots(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.processes = []
        self.addCleanup(self.end_all)
        self.broker = Broker(self.folder.name)
        self.addCleanup(self.broker.stop)

    def start(self, program, *arguments):
        log = open(os.path.join(self.folder.name, f"{len(self.processes)}.txt"), "w+")
        process = subprocess.Popen([str(program), *map(str, arguments)], stdout=log,
                                   stderr=subprocess.STDOUT)
        process.log = log
        self.processes.append(process)
        return process

    def end_all(self):
        for process in reversed(self.processes):
            if process.poll() is None:
                process.send_signal(signal.SIGTERM)
                process.wait(15)
            process.log.close()

    def vehicle(self, program, *arguments):
        return self.start(BIN / program, "--broker", "127.0.0.1", "--port", self.broker.port,
                          "--map", MAP, *arguments)

    def fleet(self, serial="amr1"):
        data = DATA if DATA.is_dir() else None
        fleet = Fleet(self.broker.port, "2.1.0", data, serial=serial)
        self.addCleanup(fleet.close)
        wait_until(lambda: (fleet.last("connection") or {}).get("connectionState") == "ONLINE", 30,
                   "ONLINE")
        fleet.wait(lambda s: s.get("agvPosition", {}).get("positionInitialized"), 30,
                   "the robot knows where it is")
        return fleet

    def check_drive(self, fleet, vehicle):
        """An order is driven, another one is cancelled, and the program brakes when it ends."""
        start = position(fleet.last())
        there = (start[0] + 2.0, start[1])
        fleet.send("order", lane("there", start, there))
        state = fleet.wait(finished("there"), 60, "the order is driven")
        self.assertEqual(state["lastNodeId"], "n1")
        self.assertEqual(state["errors"], [])
        self.assertLess(math.dist(position(state), there), 0.3)
        for passed in fleet.all("state"):
            if not passed["agvPosition"]["positionInitialized"]:
                continue
            self.assertLess(abs(position(passed)[1] - start[1]), 0.43, "inside the strip")
        fleet.send("order", lane("back", there, start))
        fleet.wait(lambda s: s["orderId"] == "back" and s["driving"] and
                   math.hypot(s["velocity"]["vx"], s["velocity"]["vy"]) > 0.3, 30, "it drives back")
        vehicle.send_signal(signal.SIGTERM)
        self.assertEqual(vehicle.wait(5), 0)
        wait_until(lambda: fleet.last("connection")["connectionState"] == "OFFLINE", 5, "OFFLINE")
        self.assertEqual(fleet.schema_errors, [])


@unittest.skipUnless((BIN / "fairway_vda5050_dds").exists(), "the DDS program is not built")
class DdsTest(LinkedRobots):
    DOMAIN = str(100 + os.getpid() % 100)

    def setUp(self):
        super().setUp()
        os.environ["CYCLONEDDS_URI"] = LOOPBACK

    def robot(self, start, *arguments):
        return self.start(BIN / "fairway_dds_simulator", MAP, f"--start={start}", "--domain",
                          self.DOMAIN, *arguments)

    def test_drives_and_brakes(self):
        track = os.path.join(self.folder.name, "track.csv")
        self.robot("2.0,4.4,0.0", "--track", track)
        vehicle = self.vehicle("fairway_vda5050_dds", "--domain", self.DOMAIN)
        self.check_drive(self.fleet(), vehicle)

        def speeds():
            lines = pathlib.Path(track).read_text().splitlines()[1:-1]
            rows = [[float(value) for value in line.split(",")] for line in lines]
            return [math.dist(a[1:3], b[1:3]) / (b[0] - a[0]) for a, b in zip(rows, rows[1:])]
        self.assertGreater(max(speeds()), 0.3)
        wait_until(lambda: max(speeds()[-5:]) < 0.01, 5, "the robot stands")

    def test_a_robot_without_measurements_takes_no_order(self):
        self.vehicle("fairway_vda5050_dds", "--domain", self.DOMAIN)
        fleet = Fleet(self.broker.port, "2.1.0", serial="amr1")
        self.addCleanup(fleet.close)
        fleet.wait(lambda s: not s["agvPosition"]["positionInitialized"], 30, "not localised")
        fleet.send("order", lane("early", (2.0, 4.4), (4.0, 4.4)))
        fleet.wait(lambda s: any("outside" in str(e) or "position" in str(e) for e in s["errors"]),
                   30, "an error that names the position")
        self.assertNotEqual(fleet.last()["orderId"], "early")

    def test_two_robots_of_one_process_meet(self):
        file = pathlib.Path(self.folder.name) / "fleet.yaml"
        file.write_text("robots:\n"
                        "  - {serial: red, namespace: red, base_frame: red/base_link}\n"
                        "  - {serial: blue, namespace: blue, base_frame: blue/base_link}\n")
        self.robot("2.0,4.4,0.0", "--namespace", "red")
        self.robot("6.0,4.4,3.1416", "--namespace", "blue")
        self.vehicle("fairway_vda5050_dds", "--domain", self.DOMAIN, "--fleet", file)
        red, blue = self.fleet("red"), self.fleet("blue")
        red.send("order", lane("red", (2.0, 4.4), (6.0, 4.4), width=1.0))
        blue.send("order", lane("blue", (6.0, 4.4), (2.0, 4.4), width=1.0))
        least = math.inf

        def both_arrived():
            nonlocal least
            least = min(least, math.dist(position(red.last()), position(blue.last())))
            return finished("red")(red.last()) and finished("blue")(blue.last())
        wait_until(both_arrived, 90, "both pass each other")
        self.assertGreater(least, 0.5, "no contact")


@unittest.skipUnless((BIN / "fairway_vda5050_ros").exists(), "the ROS 1 program is not built")
class Ros1Test(LinkedRobots):
    def setUp(self):
        super().setUp()
        try:
            import rosgraph  # noqa: F401
        except ImportError as missing:
            self.skipTest(str(missing))
        from ros_system import RosSystem
        self.system = RosSystem(PACKAGE)
        self.addCleanup(self.system.close, False)

    def test_drives_and_brakes(self):
        self.system.node("fairway_ros_simulator", f"_map:={MAP}", "_start:=2.0,4.4,0.0")
        vehicle = self.vehicle("fairway_vda5050_ros")
        self.check_drive(self.fleet(), vehicle)


class RefusalTest(unittest.TestCase):
    def refused(self, program, *arguments, environment=None):
        done = subprocess.run([BIN / program, "--map", MAP, *arguments], capture_output=True,
                              text=True, env={**os.environ, **(environment or {})}, timeout=30)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done.stderr

    @unittest.skipUnless((BIN / "fairway_vda5050_dds").exists(), "the DDS program is not built")
    def test_a_wrong_fleet_file_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "fleet.yaml"
            file.write_text("robots:\n  - {serial: red, namespace: /red}\n")
            text = self.refused("fairway_vda5050_dds", "--fleet", str(file))
            self.assertIn("fleet.yaml:2: ", text)
            self.assertIn("namespace", text)

    @unittest.skipUnless((BIN / "fairway_vda5050_ros").exists(), "the ROS 1 program is not built")
    def test_a_missing_master_is_named(self):
        text = self.refused("fairway_vda5050_ros", environment={
            "ROS_MASTER_URI": f"http://127.0.0.1:{free_port()}"})
        self.assertIn("expected a ROS master at http://127.0.0.1", text)


if __name__ == "__main__":
    if not pathlib.Path("/usr/sbin/mosquitto").exists():
        print("skipped: no mosquitto")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], *sys.argv[5:]])
