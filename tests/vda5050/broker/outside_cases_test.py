# SPDX-License-Identifier: Apache-2.0
"""Twelve cases of an outside fleet control in the workshop: outside_cases_test.py BIN SCENARIOS DATA.

They need mosquitto. The messages are checked against the schemas where the shared data has them.
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

SKIPPED = 77
BIN, SCENARIOS, DATA = (pathlib.Path(argument) for argument in sys.argv[1:4])
MAP = SCENARIOS / "maps" / "workshop.yaml"

try:
    from fleet_master import Broker, Fleet, Vehicle, wait_until
    from order_builder import (StripCheck, corridor, curve, order, position_of, zone, zone_set)
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(SKIPPED)

LANE = [(1.0, 11.0), (4.0, 11.0), (8.0, 11.0), (12.0, 11.0), (15.0, 11.0)]  # free on both sides


def has_error(kind):
    return lambda s: any(error["errorType"] == kind for error in s["errors"])


def at_end(name, node):
    return lambda s: (s["orderId"] == name and s["lastNodeId"] == node and not s["nodeStates"]
                      and not s["driving"])


class OutsideCases(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.broker = Broker(self.folder.name)
        self.addCleanup(self.broker.stop)

    def start(self, version, start="1.0,11.0,0.0", second=None):
        """The fleet controls of one or two robots of one process."""
        serials = ["amr1"] if second is None else ["amr1", "amr2"]
        data = DATA if (DATA / "vda5050").exists() else None
        fleets = [Fleet(self.broker.port, version, data, serial=serial) for serial in serials]
        extra = ()
        if second is not None:
            file = pathlib.Path(self.folder.name) / "fleet.yaml"
            file.write_text("robots:\n" + "".join(
                f"  - {{serial: {serial}, start: [{place}]}}\n"
                for serial, place in zip(serials, (start, second))))
            extra = ("--fleet", str(file))
        vehicle = Vehicle(BIN / "fairway_vda5050", self.broker.port, version, MAP,
                          start=start if second is None else None, extra=extra)
        self.addCleanup(self.end, vehicle, fleets)
        for fleet in fleets:
            wait_until(lambda: (fleet.last("connection") or {}).get("connectionState") == "ONLINE",
                       30, "ONLINE")
            fleet.wait(lambda s: True, 10)
        return fleets[0] if second is None else fleets

    def end(self, vehicle, fleets):
        self.assertIsNone(vehicle.process.poll())
        self.assertEqual(vehicle.stop(), 0)
        for fleet in fleets:
            fleet.close()
            self.assertEqual(fleet.schema_errors, [])
            self.check_headers(fleet)

    def check_headers(self, fleet):
        for topic in ("state", "visualization"):
            numbers = [m["headerId"] for m in fleet.all(topic)]
            self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))), topic)

    def check_strips(self, fleet, name, *orders):
        self.assertLessEqual(StripCheck(*orders).worst(fleet.messages, name), 0.03)

    def stops(self, fleet):
        states = fleet.all("state")
        return [b["lastNodeId"] for a, b in zip(states, states[1:])
                if a["driving"] and not b["driving"]]

    def test_01_straight_edges_with_both_reference_points(self):
        for version in ("2.1.0", "3.0.0"):
            fleet = self.start(version, start="2.0,4.4,0.0")
            lanes = order(version, "straight", [(2, 4.4), (5.6, 4.9), (8.2, 4.9), (10.6, 6.4)],
                          edges={0: {"corridor": corridor(version, 0.5, 0.5)},
                                 1: {"corridor": corridor(version, 0.5, 0.5, contour=True)},
                                 2: {"corridor": corridor(version, 0.3, 0.4)}})
            fleet.send("order", lanes)
            state = fleet.wait(at_end("straight", "n3"), 90)
            self.assertEqual(state["errors"], [])
            self.assertEqual(self.stops(fleet), ["n3"])
            self.check_strips(fleet, "straight", lanes)

    def test_02_curved_edges(self):
        for version in ("2.1.0", "3.0.0"):
            fleet = self.start(version)
            bends = order(version, "curves", [LANE[0], (6.0, 11.4), (9.0, 11.0)],
                          edges={0: {"trajectory": curve(LANE[0], (4.0, 10.3), (6.0, 11.4)),
                                     "corridor": corridor(version, 0.2, 0.2)},
                                 1: {"trajectory": curve((6.0, 11.4), (7.4, 12.2), (9.0, 11.0))}})
            fleet.send("order", bends)
            fleet.wait(at_end("curves", "n2"), 90)
            self.check_strips(fleet, "curves", bends)

    def test_03_an_obstacle_in_a_corridor_of_the_contour(self):
        for version in ("2.1.0", "3.0.0"):
            fleet = self.start(version, start="2.6,4.6,1.57")
            past = order(version, "past", [(2.6, 4.6), (2.6, 8.6)],
                         edges={0: {"corridor": corridor(version, 0.4, 2.0, contour=True)}})
            fleet.send("order", past)
            fleet.wait(at_end("past", "n1"), 90)
            self.check_strips(fleet, "past", past)

    def test_04_a_corridor_that_another_vehicle_closes_for_a_while(self):
        version = "2.1.0"
        fleet, other = self.start(version, second="6.0, 11.0, 0.0")
        narrow = {i: {"corridor": corridor(version, 0.3, 0.3)} for i in range(4)}
        lanes = order(version, "wait", LANE, edges=narrow)
        fleet.send("order", lanes)
        fleet.wait(has_error("corridorClosed"), 60)
        away = order(version, "away", [(6.0, 11.0), (9.0, 11.6), (12.0, 10.4), (15.0, 12.4)])
        other.send("order", away)
        state = fleet.wait(at_end("wait", "n4"), 120)
        self.assertEqual(state["errors"], [])
        self.check_strips(fleet, "wait", lanes)

    def test_05_a_corridor_that_stays_closed(self):
        version = "3.0.0"
        fleet, _ = self.start(version, second="6.0, 11.0, 0.0")
        lanes = order(version, "closed", LANE,
                      edges={i: {"corridor": corridor(version, 0.3, 0.3)} for i in range(4)})
        fleet.send("order", lanes)
        state = fleet.wait(has_error("NODE_UNREACHABLE"), 90)
        self.assertFalse(state["driving"])
        self.assertTrue(state["nodeStates"])
        fleet.act("cancelOrder", "c")
        fleet.wait(lambda s: fleet.action(s, "c") == "FINISHED" and not s["nodeStates"], 20)
        place = position_of(fleet.last())
        home = order(version, "home", [(place["x"], place["y"]), LANE[0]],
                     edges={0: {"corridor": corridor(version, 0.5, 0.5)}})
        fleet.send("order", home)
        state = fleet.wait(at_end("home", "n1"), 90)
        self.assertEqual(state["errors"], [])
        self.check_strips(fleet, "closed", lanes)
        self.check_strips(fleet, "home", home)

    def enable(self, fleet, *zones):
        fleet.send("zoneSet", zone_set("z", *zones))
        fleet.wait(lambda s: any(each["zoneSetId"] == "z" for each in s["zoneSets"]), 10)
        fleet.act("enableZoneSet", "enable", zoneSetId="z")
        fleet.wait(lambda s: fleet.action(s, "enable") == "FINISHED", 10)

    def test_06_a_blocked_zone_that_comes_on_the_way(self):
        version = "3.0.0"
        fleet = self.start(version)
        lanes = order(version, "stopped", LANE,
                      edges={i: {"corridor": corridor(version, 0.5, 0.5)} for i in range(4)})
        fleet.send("order", lanes)
        fleet.wait(lambda s: s["lastNodeId"] == "n1", 30)
        self.enable(fleet, zone("BLOCKED", (9.5, 10.0, 10.5, 12.0)))
        fleet.wait(has_error("NODE_UNREACHABLE"), 90)
        self.assertLess(max(position_of(m)["x"] for m in fleet.all("visualization")), 9.5 - 0.24)
        self.check_strips(fleet, "stopped", lanes)

    def test_07_a_zone_with_a_speed_limit(self):
        fleet = self.start("3.0.0")
        self.enable(fleet, zone("SPEED_LIMIT", (5.0, 10.0, 9.0, 12.0), maximumSpeed=0.3))
        fleet.send("order", order("3.0.0", "slow", LANE))
        fleet.wait(at_end("slow", "n4"), 120)
        moves = fleet.all("visualization")
        inside = [m["velocity"]["vx"] for m in moves
                  if 5.0 - 0.2 < position_of(m)["x"] < 9.0 + 0.2]
        self.assertTrue(inside)
        self.assertLess(max(inside), 0.3 + 0.02)
        self.assertGreater(max(m["velocity"]["vx"] for m in moves), 0.7)

    def test_08_zones_with_a_penalty_and_with_priority(self):
        # The straight line leads through the penalty; beside it is a free lane.
        fleet = self.start("3.0.0")
        self.enable(fleet, zone("PENALTY", (4.0, 10.4, 8.0, 12.0), penaltyFactor=0.9),
                    zone("PRIORITY", (11.0, 10.4, 14.0, 11.2), priorityFactor=0.5))
        fleet.send("order", order("3.0.0", "around", [LANE[0], LANE[4]]))
        state = fleet.wait(at_end("around", "n1"), 120)
        self.assertEqual(state["errors"], [])
        centre = [p for p in map(position_of, fleet.all("visualization"))
                  if 4.0 < p["x"] < 8.0 and 10.4 < p["y"] < 12.0]
        self.assertEqual(centre, [])

    def test_09_a_line_guided_zone(self):
        version = "3.0.0"
        fleet = self.start(version)
        self.enable(fleet, zone("LINE_GUIDED", (4.0, 9.7, 8.0, 15.9)))
        fleet.send("order", order(version, "free", [LANE[0], LANE[4]],
                                  edges={0: {"corridor": corridor(version, 0.5, 0.5)}}))
        fleet.wait(has_error("NO_ROUTE_TO_TARGET"), 20)
        guided = order(version, "guided", [LANE[0], LANE[4]],
                       edges={0: {"trajectory": curve(LANE[0], LANE[4])}})
        fleet.send("order", guided)
        fleet.wait(at_end("guided", "n1"), 120)
        self.check_strips(fleet, "guided", guided)

    def test_10_updates_in_time_late_and_wrong(self):
        for version, wrong in (("2.1.0", "orderUpdateError"), ("3.0.0", "VALIDATION_FAILURE")):
            fleet = self.start(version)
            strips = {i: {"corridor": corridor(version, 0.4, 0.4)} for i in range(4)}
            first = order(version, "grow", LANE, released=3, edges=strips)
            fleet.send("order", first)
            fleet.wait(lambda s: s["lastNodeId"] == "n1", 60)
            fleet.send("order", order(version, "grow", LANE[3:], update=1, first=3, edges=strips))
            fleet.wait(has_error(wrong), 10)
            in_time = order(version, "grow", LANE[2:], update=1, first=2, released=2, edges=strips)
            fleet.send("order", in_time)
            fleet.send("order", in_time)
            state = fleet.wait(lambda s: s["lastNodeId"] == "n3" and not s["driving"], 60)
            self.assertEqual(self.stops(fleet), ["n3"])
            self.assertTrue(state["newBaseRequest"])
            late = order(version, "grow", LANE[3:], update=2, first=3, edges=strips)
            fleet.send("order", late)
            state = fleet.wait(at_end("grow", "n4"), 60)
            self.assertEqual(self.stops(fleet), ["n3", "n4"])
            self.assertEqual(state["errors"], [])
            self.check_strips(fleet, "grow", first, in_time, late)

    def test_11_pause_with_an_update_on_the_way(self):
        for version in ("2.1.0", "3.0.0"):
            fleet = self.start(version)
            strips = {i: {"corridor": corridor(version, 0.4, 0.4)} for i in range(4)}
            first = order(version, "pause", LANE[:3], edges=strips)
            fleet.send("order", first)
            fleet.wait(lambda s: s["lastNodeId"] == "n1", 60)
            fleet.act("startPause", "p")
            state = fleet.wait(lambda s: fleet.action(s, "p") == "FINISHED", 20)
            self.assertTrue(state["paused"])
            here = position_of(state)["x"]
            more = order(version, "pause", LANE[2:], update=1, first=2, edges=strips)
            fleet.send("order", more)
            state = fleet.wait(lambda s: s["orderUpdateId"] == 1, 10)
            self.assertFalse(state["driving"])
            self.assertAlmostEqual(position_of(state)["x"], here, delta=0.02)
            fleet.act("stopPause", "q")
            fleet.wait(at_end("pause", "n4"), 90)
            self.assertEqual(len(self.stops(fleet)), 2)
            self.check_strips(fleet, "pause", first, more)

    def test_12_cancel_and_turn_back(self):
        for version in ("2.1.0", "3.0.0"):
            fleet = self.start(version)
            lanes = order(version, "there", LANE,
                          edges={i: {"corridor": corridor(version, 0.4, 0.6)} for i in range(4)})
            fleet.send("order", lanes)
            fleet.wait(lambda s: s["lastNodeId"] == "n2", 60)
            fleet.act("cancelOrder", "c")
            state = fleet.wait(lambda s: fleet.action(s, "c") == "FINISHED", 20)
            self.assertEqual((state["nodeStates"], state["edgeStates"]), ([], []))
            fleet.send("order", order(version, "there", LANE[3:], update=1, first=3))
            fleet.wait(has_error("ORDER_UPDATE_FOLLOWING_CANCEL" if version[0] == "3"
                                 else "orderUpdateError"), 10)
            place = position_of(fleet.last())
            back = order(version, "back", [(place["x"], place["y"]), LANE[2], LANE[1], LANE[0]],
                         edges={i: {"corridor": corridor(version, 0.3, 0.5)} for i in range(3)})
            fleet.send("order", back)
            state = fleet.wait(at_end("back", "n3"), 90)
            self.assertEqual(state["errors"], [])
            self.check_strips(fleet, "there", lanes)
            self.check_strips(fleet, "back", back)


if __name__ == "__main__":
    if not shutil.which("/usr/sbin/mosquitto"):
        print("skipped: no mosquitto")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
