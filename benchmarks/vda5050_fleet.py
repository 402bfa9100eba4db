# SPDX-License-Identifier: Apache-2.0
"""Many vehicles of one process under long orders: CPU use, delay of states, and wrong states.

    python3 benchmarks/vda5050_fleet.py build/release/bin/fairway_vda5050 --seconds 120

Each vehicle drives back and forth on a lane of its own, in orders of 200 nodes. The program sends a
stateRequest every 0.1 s to one vehicle after the other and measures the time until the state that
reports the action arrives, through a mosquitto on this machine. It needs mosquitto and paho-mqtt.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests" / "vda5050" / "broker"))

import paho.mqtt.client as mqtt  # noqa: E402
from fleet_master import Broker, wait_until  # noqa: E402
from order_builder import corridor, order  # noqa: E402

VERSION = "2.1.0"
SPACING = 1.5  # of lanes [m]


def write_map(folder, lanes, length, wider):
    """An empty hall with walls, as a PGM of 0.05 m cells, wider and higher than the lanes need."""
    width, height = int((length + 6 + wider) / 0.05), int(((lanes + 1) * SPACING + wider) / 0.05)
    rows = [bytes([0]) * width]
    rows += [bytes([0]) + bytes([254]) * (width - 2) + bytes([0])] * (height - 2)
    rows += [bytes([0]) * width]
    (folder / "hall.pgm").write_bytes(f"P5\n{width} {height}\n255\n".encode() + b"".join(rows))
    (folder / "workshop.yaml").write_text(
        "image: hall.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
    return folder / "workshop.yaml"


def long_order(name, lane, nodes, length, x):
    """There and back, a node each metre, from the node at `x`."""
    places, step = [], 1
    for _ in range(nodes):
        places.append((3.0 + x, SPACING * (lane + 1)))
        if not 0 <= x + step <= length:
            step = -step
        x += step
    strips = {i: {"corridor": corridor(VERSION, 0.4, 0.4)} for i in range(nodes - 1)}
    return order(VERSION, name, places, edges=strips)


class Watcher:
    """Sends orders to all vehicles, and judges their states."""

    def __init__(self, port, vehicles, nodes, length):
        self.nodes = nodes
        self.length = length
        self.last = {}       # state of each vehicle
        self.orders = dict.fromkeys(vehicles, 0)
        self.driven = 0      # orders
        self.states = 0
        self.wrong = []
        self.asked = {}      # time of each request
        self.delays = []
        self.header = 0
        self.lock = threading.Lock()
        self.client = mqtt.Client()
        self.client.on_message = self.take
        self.client.connect("127.0.0.1", port)
        self.client.subscribe("uagv/v2/Fairway/+/state", 0)
        self.client.loop_start()

    def send(self, vehicle, topic, body):
        with self.lock:
            self.header += 1
            message = dict(body, headerId=self.header, version=VERSION, manufacturer="Fairway",
                           timestamp=time.strftime("%Y-%m-%dT%H:%M:%S.00Z", time.gmtime()),
                           serialNumber=vehicle)
        self.client.publish(f"uagv/v2/Fairway/{vehicle}/{topic}", json.dumps(message))

    def ask(self, vehicle, number):
        name = f"ask{number}"
        self.asked[name] = time.monotonic()
        self.send(vehicle, "instantActions", {"actions": [
            {"actionType": "stateRequest", "actionId": name, "blockingType": "NONE"}]})

    def take(self, _client, _data, message):
        now = time.monotonic()
        vehicle = message.topic.split("/")[3]
        state = json.loads(message.payload)
        self.states += 1
        for action in state["actionStates"]:
            asked = self.asked.pop(action["actionId"], None)
            if asked is not None:
                self.delays.append(now - asked)
        self.judge(vehicle, self.last.get(vehicle), state)
        self.last[vehicle] = state
        if not state["nodeStates"] and not state["driving"]:
            self.next_order(vehicle, state)

    def judge(self, vehicle, before, state):
        def check(holds, what):
            if not holds:
                self.wrong.append(f"{vehicle}: {what}: {state['errors'] or json.dumps(state)[:400]}")
        check(not state["errors"], "an error")
        ahead = [node["sequenceId"] for node in state["nodeStates"]]
        check(ahead == list(range(state["lastNodeSequenceId"] + 2, 2 * self.nodes, 2)) or
              (not ahead and not state["orderId"]), "nodes are missing")
        check(len(state["edgeStates"]) == len(ahead), "edges are missing")
        if before is None:
            return
        check(state["headerId"] == before["headerId"] + 1, "a header is missing")
        if before["orderId"] == state["orderId"]:
            check(state["lastNodeSequenceId"] >= before["lastNodeSequenceId"], "a node came back")

    def next_order(self, vehicle, state):
        number = self.orders[vehicle]
        if number > 0 and state["orderId"] != f"{vehicle}-{number}":
            return  # the order is under way
        self.driven += number > 0
        self.orders[vehicle] = number + 1
        lane = int(vehicle[3:])
        x = round(state["agvPosition"]["x"] - 3.0)
        self.send(vehicle, "order",
                  long_order(f"{vehicle}-{number + 1}", lane, self.nodes, self.length, x))


def cpu_time(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--robots", type=int, default=20)
    parser.add_argument("--nodes", type=int, default=200)
    parser.add_argument("--length", type=int, default=20, help="of a lane [m]")
    parser.add_argument("--wider", type=int, default=0, help="by which the hall is too large [m]")
    parser.add_argument("--seconds", type=float, default=120.0)
    parser.add_argument("--speed", type=float, default=1.0, help="simulated seconds in a second")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        map_file = write_map(folder, options.robots, options.length, options.wider)
        vehicles = [f"amr{i}" for i in range(options.robots)]
        (folder / "fleet.yaml").write_text("robots:\n" + "".join(
            f"  - {{serial: amr{i}, start: [3.0, {SPACING * (i + 1)}, 0.0]}}\n"
            for i in range(options.robots)))
        broker = Broker(folder, "allow_anonymous true\nset_tcp_nodelay true\n")
        watcher = Watcher(broker.port, vehicles, options.nodes, options.length)
        process = subprocess.Popen([options.program, "--port", str(broker.port), "--map",
                                    str(map_file), "--simulate", "--speed", str(options.speed),
                                    "--fleet", str(folder / "fleet.yaml")])
        try:
            wait_until(lambda: len(watcher.last) == options.robots
                       and all(state["driving"] for state in watcher.last.values()), 60, "driving")
            watcher.delays.clear()
            begin, used, number = time.monotonic(), cpu_time(process), 0
            while time.monotonic() - begin < options.seconds:
                watcher.ask(vehicles[number % options.robots], number)
                number += 1
                time.sleep(0.1)
            seconds = time.monotonic() - begin
            used = cpu_time(process) - used
            status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
            memory = int(status.split("VmHWM:")[1].split()[0]) / 1024
            time.sleep(1.0)
        finally:
            process.terminate()
            process.wait(10)
            broker.stop()
    delays = sorted(watcher.delays)
    share = lambda p: 1e3 * delays[min(len(delays) - 1, int(p * len(delays)))]  # noqa: E731
    print(f"{options.robots} robots, orders of {options.nodes} nodes, {seconds:.0f} s at speed "
          f"{options.speed:g}, lanes of {options.length} m in a hall {options.wider} m wider: "
          f"{100 * used / seconds:.0f} % of one core, at most {memory:.0f} MB")
    print(f"{watcher.states} states, {watcher.driven} orders driven, {len(watcher.wrong)} wrong states")
    print(f"event to state over {len(delays)} of {number} requests: median {share(0.5):.1f} ms, "
          f"p99 {share(0.99):.1f} ms, greatest {delays[-1] * 1e3:.1f} ms")
    for text in watcher.wrong[:5]:
        print(text)
    return 1 if watcher.wrong else 0  # a new order empties the list of answers


if __name__ == "__main__":
    sys.exit(main())
