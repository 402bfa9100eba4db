# SPDX-License-Identifier: Apache-2.0
"""fairway_vda5050 with a real broker: vda5050_test.py BIN SCENARIOS DATA.

Every message of the vehicle is checked against its schema. Skipped without mosquitto or the shared
data.
"""

import copy
import http.client
import json
import math
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77
BIN, SCENARIOS, DATA = (pathlib.Path(argument) for argument in sys.argv[1:4])
MAP = SCENARIOS / "maps" / "workshop.yaml"
EXAMPLES = DATA / "vda5050" / "examples"

try:
    from fleet_master import Broker, Fleet, Vehicle, free_port, wait_until
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(SKIPPED)


def example(version, name):
    folder = "3.0.0" if version.startswith("3") else "2.1.0"
    return json.loads((EXAMPLES / folder / f"{name}.json").read_text())


def finished(order_id):
    return lambda s: s["orderId"] == order_id and not s["nodeStates"] and not s["driving"]


def position_of(message):
    return message.get("agvPosition") or message.get("mobileRobotPosition")


def has_error(kind):
    return lambda s: any(error["errorType"] == kind for error in s["errors"])


class Lanes:
    """The strips of an order's straight edges, extended by the deviation of their nodes."""

    def __init__(self, order, radius=0.25):
        self.lanes = []
        nodes = [node["nodePosition"] for node in order["nodes"]]
        for a, b, edge in zip(nodes, nodes[1:], order["edges"]):
            if "corridor" in edge and "trajectory" not in edge:
                self.lanes.append((a, b, edge["corridor"], radius))

    @staticmethod
    def reach(node):
        deviation = node.get("allowedDeviationXY", 0.0)
        return max(deviation["a"], deviation["b"]) if isinstance(deviation, dict) else deviation

    def outside(self, x, y):
        """How far a point is outside all strips [m]."""
        least = math.inf
        for a, b, corridor, radius in self.lanes:
            length = math.hypot(b["x"] - a["x"], b["y"] - a["y"])
            ux, uy = (b["x"] - a["x"]) / length, (b["y"] - a["y"]) / length
            along = (x - a["x"]) * ux + (y - a["y"]) * uy
            side = -(x - a["x"]) * uy + (y - a["y"]) * ux
            less = radius if "CONTOUR" in (corridor.get("corridorRefPoint"),
                                           corridor.get("corridorReferencePoint")) else 0.0
            beside = max(side - corridor["leftWidth"] + less, -side - corridor["rightWidth"] + less)
            beyond = max(-along - self.reach(a), along - length - self.reach(b))
            least = min(least, max(0.0, beside, beyond))
        return least


class VehicleTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.broker = Broker(self.folder.name)
        self.addCleanup(self.broker.stop)

    def start(self, version, data=DATA, **options):
        fleet = Fleet(self.broker.port, version, data)
        self.addCleanup(fleet.close)
        vehicle = Vehicle(BIN / "fairway_vda5050", self.broker.port, version, MAP, **options)
        self.addCleanup(self.end, vehicle, fleet)
        wait_until(lambda: (fleet.last("connection") or {}).get("connectionState") == "ONLINE", 30,
                   "ONLINE")
        fleet.wait(lambda s: True, 10)
        return fleet, vehicle

    def end(self, vehicle, fleet):
        if vehicle.process.poll() is None:
            vehicle.stop()
        self.assertEqual(fleet.schema_errors, [])

    def check_inside(self, fleet, order, slack=0.03):
        lanes = Lanes(order)
        worst = max(lanes.outside(p["x"], p["y"])
                    for p in map(position_of, fleet.all("visualization") + fleet.all("state")))
        self.assertLessEqual(worst, slack)

    def test_drives_corridors_of_both_kinds(self):
        for version in ("2.1.0", "3.0.0"):
            with self.subTest(version=version):
                fleet, vehicle = self.start(version)
                order = example(version, "order_corridors")
                fleet.send("order", order)
                state = fleet.wait(finished("corridors"), 120, "the order is driven")
                self.assertEqual(state["lastNodeId"], "goal")
                self.assertEqual(state["errors"], [])
                self.assertLess(abs(position_of(state)["theta"]), 0.12)
                self.check_inside(fleet, order)
                passed = [s["lastNodeId"] for s in fleet.all("state") if s["lastNodeId"]]
                self.assertEqual(list(dict.fromkeys(passed)),
                                 [node["nodeId"] for node in order["nodes"]])
                # The vehicle flows through the nodes: it stops once, at the end.
                stops = [a for a, b in zip(fleet.all("state"), fleet.all("state")[1:])
                         if a["driving"] and not b["driving"]]
                self.assertEqual(len(stops), 1)
                self.assertEqual(vehicle.stop(), 0)

    def test_passes_an_obstacle_inside_its_corridor(self):
        fleet, _ = self.start("2.1.0")
        order = example("2.1.0", "order_corridor_round_obstacle")
        fleet.send("order", order)
        fleet.wait(finished("round"), 90, "the order is driven")
        self.check_inside(fleet, order)

    def test_refuses_what_cannot_be_driven(self):
        fleet, _ = self.start("3.0.0")
        fleet.send("order", example("3.0.0", "refused_corridor_blocked"))
        state = fleet.wait(has_error("NO_ROUTE_TO_TARGET"), 30)
        self.assertEqual(state["orderId"], "")

    def test_drives_curves(self):
        fleet, _ = self.start("2.1.0")
        fleet.send("order", example("2.1.0", "order_nurbs"))
        fleet.wait(finished("nurbs"), 90, "the order is driven")
        # On the quarter circle of radius 1 about (8.2, 5.9), the strip is 0.4 m wide to both sides.
        for p in map(position_of, fleet.all("visualization")):
            if p["x"] > 8.4 and p["y"] < 5.7:
                self.assertLess(abs(math.hypot(p["x"] - 8.2, p["y"] - 5.9) - 1.0), 0.43)

    def test_keeps_the_speed_of_edges(self):
        fleet, _ = self.start("2.1.0")
        fleet.send("order", example("2.1.0", "order_lanes"))
        fleet.wait(finished("lanes"), 120, "the order is driven")
        speeds = [m["velocity"]["vx"] for m in fleet.all("visualization")
                  if 5.6 < position_of(m)["x"] < 8.2]
        self.assertLess(max(speeds), 0.5 + 0.02)
        self.assertGreater(max(m["velocity"]["vx"] for m in fleet.all("visualization")), 0.7)

    def test_stops_at_the_end_of_the_base_and_continues(self):
        fleet, _ = self.start("2.1.0")
        fleet.send("order", example("2.1.0", "order_base_and_horizon"))
        state = fleet.wait(lambda s: s["lastNodeId"] == "hall" and not s["driving"], 60)
        self.assertTrue(state["newBaseRequest"])
        self.assertTrue(state["nodeStates"])
        far = max(position_of(m)["x"] for m in fleet.all("visualization"))
        self.assertLess(far, 8.2 + 0.4)
        fleet.send("order", example("2.1.0", "refused_update_stitch"))
        fleet.wait(has_error("orderUpdateError"), 10)
        fleet.send("order", example("2.1.0", "order_extension"))
        state = fleet.wait(lambda s: s["lastNodeId"] == "door_e" and not s["driving"], 60)
        self.assertEqual(state["errors"], [])

    def test_extends_a_base_without_a_stop(self):
        fleet, _ = self.start("2.1.0")
        fleet.send("order", example("2.1.0", "order_base_and_horizon"))
        fleet.wait(lambda s: s["driving"], 20)
        fleet.send("order", example("2.1.0", "order_extension"))
        fleet.wait(lambda s: s["lastNodeId"] == "door_e" and not s["driving"], 60)
        states = fleet.all("state")
        stops = [b for a, b in zip(states, states[1:]) if a["driving"] and not b["driving"]]
        self.assertEqual([s["lastNodeId"] for s in stops], ["door_e"])

    def test_pauses_and_cancels(self):
        fleet, _ = self.start("3.0.0")
        fleet.send("order", example("3.0.0", "order_free"))
        fleet.wait(lambda s: s["driving"], 30)
        fleet.act("startPause", "p1")
        state = fleet.wait(lambda s: fleet.action(s, "p1") == "FINISHED", 20)
        self.assertTrue(state["paused"])
        self.assertFalse(state["driving"])
        fleet.act("stopPause", "p2")
        fleet.wait(lambda s: s["driving"] and not s["paused"], 20)
        fleet.act("cancelOrder", "c1")
        state = fleet.wait(lambda s: fleet.action(s, "c1") == "FINISHED", 20)
        self.assertFalse(state["driving"])
        self.assertEqual((state["nodeStates"], state["edgeStates"]), ([], []))
        fleet.act("cancelOrder", "c2")
        state = fleet.wait(has_error("NO_ORDER_TO_CANCEL"), 10)
        self.assertEqual(fleet.action(state, "c2"), "FAILED")

    def test_obeys_zones(self):
        fleet, _ = self.start("3.0.0")
        fleet.send("zoneSet", example("3.0.0", "zoneSet_blocks_door"))
        fleet.wait(lambda s: s["zoneSets"], 10)
        fleet.act("enableZoneSet", "z", zoneSetId="night")
        fleet.wait(lambda s: fleet.action(s, "z") == "FINISHED", 10)
        fleet.send("order", example("3.0.0", "order_corridors"))
        fleet.wait(has_error("NO_ROUTE_TO_TARGET"), 20)
        fleet.send("order", example("3.0.0", "order_free"))
        fleet.wait(finished("free"), 120, "the order is driven around the closed door")
        for p in map(position_of, fleet.all("visualization")):
            self.assertFalse(16.9 - 0.24 < p["x"] < 17.5 + 0.24 and 9.9 < p["y"] < 11.4, p)

    def test_requests_leave_for_a_corridor(self):
        fleet, _ = self.start("3.0.0")
        order = example("3.0.0", "order_corridor_on_request")
        fleet.send("order", order)
        state = fleet.wait(lambda s: s["edgeRequests"] and s["lastNodeId"] == "foot"
                           and not s["driving"], 60)
        self.assertEqual(state["errors"], [])
        inside = [abs(position_of(m)["x"] - 2.6) for m in fleet.all("visualization")
                  if position_of(m)["y"] > 5.0]
        self.assertLess(max(inside, default=0.0), 0.2)
        request = state["edgeRequests"][0]["requestId"]
        fleet.send("responses", {"responses": [{"requestId": request, "grantType": "GRANTED"}]})
        fleet.wait(finished("ask"), 60, "the order is driven")

    def test_survives_the_broker(self):
        fleet, vehicle = self.start("2.1.0")
        fleet.send("order", example("2.1.0", "order_base_and_horizon"))
        fleet.wait(lambda s: s["driving"], 20)
        self.broker.stop()
        self.broker.start()
        before = len(fleet.all("connection"))
        wait_until(lambda: any(c["connectionState"] == "ONLINE"
                               for c in fleet.all("connection")[before:]), 30, "ONLINE again")
        state = fleet.wait(lambda s: s["lastNodeId"] == "hall" and not s["driving"], 60)
        self.assertEqual(state["orderId"], "grow")

    def test_leaves_a_will_and_says_good_bye(self):
        fleet, vehicle = self.start("2.1.0")
        vehicle.process.send_signal(signal.SIGKILL)
        wait_until(lambda: fleet.last("connection")["connectionState"] == "CONNECTIONBROKEN", 60,
                   "the will")
        vehicle.process.wait(10)
        vehicle.process.stderr.close()
        fleet, vehicle = self.start("2.1.0")
        self.assertEqual(vehicle.stop(), 0)
        wait_until(lambda: fleet.last("connection")["connectionState"] == "OFFLINE", 10, "OFFLINE")

    def test_uses_tls_and_a_password(self):
        if not shutil.which("openssl"):
            self.skipTest("no openssl")
        folder = pathlib.Path(self.folder.name)
        self.broker.stop()

        def openssl(*arguments):
            subprocess.run(["openssl", *arguments], check=True, capture_output=True, cwd=folder)

        openssl("req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=test ca",
                "-keyout", "ca.key", "-out", "ca.crt")
        openssl("req", "-newkey", "rsa:2048", "-nodes", "-subj", "/CN=127.0.0.1",
                "-keyout", "server.key", "-out", "server.csr")
        (folder / "names.cnf").write_text("subjectAltName=IP:127.0.0.1\n")
        openssl("x509", "-req", "-in", "server.csr", "-CA", "ca.crt", "-CAkey", "ca.key",
                "-CAcreateserial", "-days", "2", "-extfile", "names.cnf", "-out", "server.crt")
        (folder / "password").write_text("secret\n")
        subprocess.run(["mosquitto_passwd", "-b", "-c", str(folder / "users"), "amr", "secret"],
                       check=True, capture_output=True)
        for path in folder.iterdir():
            path.chmod(0o644)  # the broker gives up its rights
        folder.chmod(0o755)
        self.broker = Broker(folder, "allow_anonymous false\n"
                             f"password_file {folder}/users\ncafile {folder}/ca.crt\n"
                             f"certfile {folder}/server.crt\nkeyfile {folder}/server.key\n")
        self.addCleanup(self.broker.stop)
        fleet = Fleet(self.broker.port, "2.1.0", DATA, ca=folder / "ca.crt", login=("amr", "secret"))
        self.addCleanup(fleet.close)
        vehicle = Vehicle(BIN / "fairway_vda5050", self.broker.port, "2.1.0", MAP,
                          extra=("--ca", str(folder / "ca.crt"), "--user", "amr",
                                 "--password-file", str(folder / "password")))
        self.addCleanup(self.end, vehicle, fleet)
        wait_until(lambda: (fleet.last("connection") or {}).get("connectionState") == "ONLINE", 30,
                   "ONLINE over TLS")

    def test_drives_a_fleet(self):
        file = pathlib.Path(self.folder.name) / "fleet.yaml"
        file.write_text("robots:\n  - {serial: amr1, start: [2.0, 4.4, 0.0]}\n"
                        "  - {serial: amr2, start: [22.2, 14.6, 3.1]}\n")
        fleets = [Fleet(self.broker.port, "2.1.0", DATA, serial=serial) for serial in ("amr1", "amr2")]
        vehicle = Vehicle(BIN / "fairway_vda5050", self.broker.port, "2.1.0", MAP, start=None,
                          extra=("--fleet", str(file)))
        for fleet in fleets:
            self.addCleanup(fleet.close)
            wait_until(lambda: (fleet.last("connection") or {}).get("connectionState") == "ONLINE",
                       30, "ONLINE")
        self.addCleanup(self.end, vehicle, fleets[0])
        order = example("2.1.0", "order_lanes")
        fleets[0].send("order", order)
        back = copy.deepcopy(order)
        back["orderId"] = "back"
        places = [node["nodePosition"] for node in reversed(order["nodes"])]
        for node, place in zip(back["nodes"], places):
            place.pop("theta", None)
            place.pop("allowedDeviationTheta", None)
            node["nodePosition"] = dict(place, allowedDeviationXY=0.4)
        back["nodes"] = back["nodes"][:5]
        back["edges"] = back["edges"][:4]
        fleets[1].send("order", back)
        fleets[1].wait(finished("back"), 120, "the second robot has arrived")
        self.assertEqual(fleets[1].schema_errors, [])

    def test_shows_a_page(self):
        port = free_port()
        fleet, _ = self.start("2.1.0", extra=("--page", str(port)))
        fleet.send("order", example("2.1.0", "order_corridors"))
        fleet.wait(lambda s: s["driving"], 20)

        def get(path, host="127.0.0.1"):
            connection = http.client.HTTPConnection("127.0.0.1", port, timeout=10)
            connection.request("GET", path, headers={"Host": host})
            answer = connection.getresponse()
            return answer.status, answer.read().decode()

        self.assertIn("<canvas", get("/")[1])
        self.assertEqual(json.loads(get("/map")[1])["resolution"], 0.05)
        robot = wait_until(lambda: next((r for r in json.loads(get("/robots")[1])["robots"]
                                         if r["order"]), None), 10, "the order on the page")
        self.assertEqual(robot["serial"], "amr1")
        self.assertEqual(len(robot["legs"][0]["strip"]), 4)
        self.assertEqual(get("/robots", host="evil.example")[0], 403)
        self.assertEqual(get("/etc/passwd")[0], 404)

    def test_is_sent_orders_by_the_tool(self):
        self.start("2.1.0")
        command = [str(BIN / "fairway"), "order", "--broker", "127.0.0.1", "--port",
                   str(self.broker.port)]
        done = subprocess.run([*command, str(EXAMPLES / "2.1.0" / "order_corridor_round_obstacle.json")],
                              capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('at node "head"', done.stdout)
        refused = subprocess.run([*command, str(EXAMPLES / "2.1.0" / "bad_map.json")],
                                 capture_output=True, text=True, timeout=60)
        self.assertEqual(refused.returncode, 1, refused.stderr)
        self.assertIn("orderError", refused.stdout)


class BadInputTest(unittest.TestCase):
    def test_is_explained_in_a_line(self):
        table = [(["--map", "none.yaml", "--simulate", "--start", "2,4.4,0"], "none.yaml"),
                 (["--map", str(MAP), "--simulate", "--start", "2,4.4"], "--start"),
                 (["--map", str(MAP), "--simulate", "--start", "0,0,0"], "--start"),
                 (["--map", str(MAP), "--start", "2,4.4,0"], "--simulate"),
                 (["--map", str(MAP), "--version", "9"], "--version"),
                 (["--map", str(MAP), "--simulate", "--start", "2,4.4,0", "--serial", "a/b"],
                  "--serial")]
        for arguments, named in table:
            done = subprocess.run([str(BIN / "fairway_vda5050"), *arguments], capture_output=True,
                                  text=True, timeout=30)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(named, done.stderr)


if __name__ == "__main__":
    if not shutil.which("/usr/sbin/mosquitto"):
        print("skipped: no mosquitto")
        sys.exit(SKIPPED)
    if not EXAMPLES.exists():
        print("skipped: no shared data")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
