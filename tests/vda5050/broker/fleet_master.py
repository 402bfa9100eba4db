# SPDX-License-Identifier: Apache-2.0
"""A broker, a fairway_vda5050 process and a fleet control, for tests on a free loopback port."""

import json
import pathlib
import signal
import socket
import ssl
import subprocess
import threading
import time

import jsonschema
import paho.mqtt.client as mqtt

SCHEMAS = {"2.0.0": "2.1.0", "2.1.0": "2.1.0", "3.0.0": "3.0.0"}  # the schemas of a version


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Broker:
    """A mosquitto of this test alone."""

    def __init__(self, folder, extra="allow_anonymous true\n"):
        self.port = free_port()
        self.config = pathlib.Path(folder) / f"mosquitto_{self.port}.conf"
        self.config.write_text(f"listener {self.port} 127.0.0.1\npersistence false\nlog_type none\n"
                               + extra)
        self.process = None
        self.start()

    def start(self):
        self.process = subprocess.Popen(["/usr/sbin/mosquitto", "-c", str(self.config)],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_until(self.answers, 10, "the broker answers")

    def answers(self):
        try:
            socket.create_connection(("127.0.0.1", self.port), timeout=1).close()
            return True
        except OSError:
            return False

    def stop(self):
        self.process.terminate()
        self.process.wait(10)


def wait_until(holds, seconds, what):
    """Polls a condition; the deadline only ends a test that hangs."""
    pause = threading.Event()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        result = holds()
        if result:
            return result
        pause.wait(0.01)
    raise AssertionError(f"not within {seconds} s: {what}")


class Fleet:
    """A fleet control that checks every message of the vehicle against its schema."""

    def __init__(self, port, version, data=None, serial="amr1", interface=None, ca=None, login=None):
        self.version, self.serial = version, serial
        major = "v3" if version.startswith("3") else "v2"
        interface = interface or ("vda5050" if major == "v3" else "uagv")
        self.base = f"{interface}/{major}/Fairway/{serial}/"
        self.messages = []       # (topic, message, retained)
        self.schema_errors = []
        self.schemas = {}
        if data:
            for path in (pathlib.Path(data) / "vda5050/schemas" / SCHEMAS[version]).glob("*.schema"):
                schema = json.loads(path.read_text())
                self.schemas[path.stem] = jsonschema.Draft202012Validator(schema)
        self.lock = threading.Lock()
        self.client = mqtt.Client()
        self.client.on_connect = lambda client, *_: client.subscribe(self.base + "#", 1)
        self.client.on_message = self.take
        self.client.reconnect_delay_set(1, 1)
        if ca:
            self.client.tls_set(str(ca), tls_version=ssl.PROTOCOL_TLS_CLIENT)
            self.client.username_pw_set(*login)
        self.client.connect("127.0.0.1", port)
        self.client.loop_start()
        self.header = 0

    def take(self, _client, _data, message):
        topic = message.topic[len(self.base):]
        if topic in ("order", "instantActions", "zoneSet", "responses"):
            return
        body = json.loads(message.payload)
        errors = []
        if topic in self.schemas:
            errors = [f"{topic}: {error.json_path}: {error.message}"
                      for error in self.schemas[topic].iter_errors(body)]
        with self.lock:
            self.messages.append((topic, body, message.retain))
            self.schema_errors += errors

    def all(self, topic):
        with self.lock:
            return [body for name, body, _ in self.messages if name == topic]

    def last(self, topic="state"):
        found = self.all(topic)
        return found[-1] if found else None

    def wait(self, holds, seconds=60, what="a state"):
        """Waits for a state for which `holds` is true, among those from now on or the last one."""
        def check():
            state = self.last()
            return state if state is not None and holds(state) else None
        try:
            return wait_until(check, seconds, what)
        except AssertionError as error:
            raise AssertionError(f"{error}; last state: {json.dumps(self.last())[:1500]}") from None

    def send(self, topic, body):
        self.header += 1
        now = time.strftime("%Y-%m-%dT%H:%M:%S.00Z", time.gmtime())
        message = dict(body, headerId=self.header, timestamp=now, version=self.version,
                       manufacturer="Fairway", serialNumber=self.serial)
        self.client.publish(self.base + topic, json.dumps(message))

    def act(self, kind, name, **parameters):
        blocking = "NONE" if self.version.startswith("3") else "HARD"
        listed = [{"key": key, "value": value} for key, value in parameters.items()]
        self.send("instantActions", {"actions": [{"actionType": kind, "actionId": name,
                                                  "blockingType": blocking,
                                                  "actionParameters": listed}]})

    def action(self, state, name):
        for action in state.get("actionStates", []) + state.get("instantActionStates", []):
            if action["actionId"] == name:
                return action["actionStatus"]
        return None

    def close(self):
        self.client.loop_stop()
        self.client.disconnect()


class Vehicle:
    """A fairway_vda5050 process."""

    def __init__(self, program, port, version, map_file, start="2.0,4.4,0.0", speed=5, extra=()):
        command = [str(program), "--broker", "127.0.0.1", "--port", str(port), "--version", version,
                   "--map", str(map_file), "--simulate", "--speed", str(speed), *extra]
        if start:
            command += ["--start", start]
        self.process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)

    def stop(self, signal_number=signal.SIGTERM):
        self.process.send_signal(signal_number)
        self.process.wait(10)
        self.process.stderr.close()
        return self.process.returncode
