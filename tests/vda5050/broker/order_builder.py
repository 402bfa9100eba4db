# SPDX-License-Identifier: Apache-2.0
"""Orders and zone sets in the words of a version, and the check that a fleet control makes."""

import math


def third(version):
    return version.startswith("3")


def corridor(version, left, right, contour=False, release=False):
    made = {"leftWidth": left, "rightWidth": right}
    if contour:
        made["corridorReferencePoint" if third(version) else "corridorRefPoint"] = "CONTOUR"
    if release:
        made["releaseRequired"] = True
    return made


def curve(*points):
    """A NURBS of degree 2 or less through the first and the last point."""
    degree = min(2, len(points) - 1)
    inner = len(points) - degree - 1
    knots = ([0.0] * (degree + 1) + [(i + 1) / (inner + 1) for i in range(inner)]
             + [1.0] * (degree + 1))
    return {"degree": degree, "knotVector": knots,
            "controlPoints": [{"x": x, "y": y} for x, y in points]}


def order(version, name, places, update=0, first=0, released=None, deviation=0.4, edges=None):
    """An order through places. `edges` maps the number of an edge to its further keys."""
    released = len(places) if released is None else released
    wide = {"a": deviation, "b": deviation, "theta": 0.0} if third(version) else deviation
    nodes, lanes = [], []
    for i, (x, y) in enumerate(places):
        number = first + i
        nodes.append({"nodeId": f"n{number}", "sequenceId": 2 * number, "released": i < released,
                      "nodePosition": {"x": x, "y": y, "mapId": "workshop",
                                       "allowedDeviationXY": wide}, "actions": []})
        if i == 0:
            continue
        lane = {"edgeId": f"e{number - 1}", "sequenceId": 2 * number - 1, "released": i < released,
                "actions": []}
        if not third(version):
            lane.update(startNodeId=f"n{number - 1}", endNodeId=f"n{number}")
        lane.update((edges or {}).get(i - 1, {}))
        lanes.append(lane)
    return {"orderId": name, "orderUpdateId": update, "nodes": nodes, "edges": lanes}


def zone(kind, box, **keys):
    x0, y0, x1, y1 = box
    return {"zoneId": kind.lower(), "zoneType": kind, **keys,
            "vertices": [{"x": x0, "y": y0}, {"x": x1, "y": y0}, {"x": x1, "y": y1},
                         {"x": x0, "y": y1}]}


def zone_set(name, *zones):
    return {"zoneSet": {"mapId": "workshop", "zoneSetId": name, "zones": list(zones)}}


def position_of(message):
    return message.get("agvPosition") or message.get("mobileRobotPosition")


class Strip:
    """The strip of an edge: along its line, and straight beyond both nodes by their deviation."""

    def __init__(self, start, end, edge, body):
        self.line = self.points(start, end, edge.get("trajectory"))
        self.widths = edge.get("corridor")
        self.free = self.widths is None and "trajectory" not in edge
        if self.widths is None:
            self.widths = {"leftWidth": 0.15, "rightWidth": 0.15}
        contour = "CONTOUR" in (self.widths.get("corridorRefPoint"),
                                self.widths.get("corridorReferencePoint"))
        self.body = body if contour else 0.0
        self.before, self.after = self.reach(start), self.reach(end)
        self.end = end["nodePosition"]

    @staticmethod
    def reach(node):
        deviation = node["nodePosition"].get("allowedDeviationXY", 0.0)
        return max(deviation["a"], deviation["b"]) if isinstance(deviation, dict) else deviation

    @staticmethod
    def points(start, end, trajectory):
        a, b = start["nodePosition"], end["nodePosition"]
        if trajectory is None:
            return [(a["x"], a["y"]), (b["x"], b["y"])]
        controls = [(p["x"], p["y"]) for p in trajectory["controlPoints"]]
        if len(controls) == 2:
            return controls
        assert len(controls) == 3, "this check knows curves of three points"
        (ax, ay), (bx, by), (cx, cy) = controls
        shares = [i / 100 for i in range(101)]
        return [((1 - t) ** 2 * ax + 2 * t * (1 - t) * bx + t * t * cx,
                 (1 - t) ** 2 * ay + 2 * t * (1 - t) * by + t * t * cy) for t in shares]

    def outside(self, x, y):
        if self.free:
            return 0.0
        best = (math.inf, math.inf)
        last = len(self.line) - 2
        for i, ((ax, ay), (bx, by)) in enumerate(zip(self.line, self.line[1:])):
            length = math.hypot(bx - ax, by - ay)
            ux, uy = (bx - ax) / length, (by - ay) / length
            along = (x - ax) * ux + (y - ay) * uy
            side = -(x - ax) * uy + (y - ay) * ux
            inside = min(max(along, 0.0), length)
            far = math.hypot(x - ax - inside * ux, y - ay - inside * uy)
            beside = max(side - self.widths["leftWidth"], -side - self.widths["rightWidth"])
            beyond = max(-along - self.before if i == 0 else -math.inf,
                         along - length - self.after if i == last else -math.inf)
            best = min(best, (far, max(0.0, beside + self.body, beyond)))
        return best[1]


class StripCheck:
    """Follows the messages of a vehicle and measures how far it is outside the strip of its edge."""

    near = 0.4  # of a node, where the strip of either edge counts [m]

    def __init__(self, *orders, body=0.25):
        self.strips = {}
        for each in orders:
            for a, b, edge in zip(each["nodes"], each["nodes"][1:], each["edges"]):
                if edge["released"]:
                    self.strips[edge["sequenceId"]] = Strip(a, b, edge, body)

    def worst(self, messages, name):
        """The greatest distance outside [m], while the order with this name is driven."""
        worst, sequence = 0.0, None
        for topic, message, _ in messages:
            if topic == "state":
                ours = message["orderId"] == name
                sequence = message["lastNodeSequenceId"] if ours else None
            if topic not in ("state", "visualization") or sequence is None:
                continue
            place = position_of(message)
            worst = max(worst, self.outside(sequence, place["x"], place["y"]))
        return worst

    def outside(self, sequence, x, y):
        present = self.strips.get(sequence + 1)
        before = self.strips.get(sequence - 1)
        after = self.strips.get(sequence + 3)
        allowed = [present] if present else []
        if before and (not present or self.is_near(before, x, y)):
            allowed.append(before)
        if present and after and self.is_near(present, x, y):
            allowed.append(after)
        return min((strip.outside(x, y) for strip in allowed), default=0.0)

    def is_near(self, strip, x, y):
        return math.hypot(x - strip.end["x"], y - strip.end["y"]) < self.near
