#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sends hostile data to `fairway serve`: hostile_client.py FAIRWAY [SECONDS [SEED]].

Random commands, broken frames, broken requests, uploads, clients that stop reading and clients
that leave. Every ten of them a well-behaved client must still receive records of the running world.
Exit code 1 if it does not, if the server ends or needs more than 2 GB, or if it ends with an error
after its signal.
"""
import base64
import json
import os
import random
import re
import signal
import socket
import struct
import subprocess
import sys
import time
import zlib

PATIENCE = 120.0  # [s]; the machine may be slow
MOST_MEMORY = 2e9  # bytes
ODD_NUMBERS = [0, -1, 1, 0.5, 3, 1e-300, 1e5, 1e6, -1e6, 1e16, 1e308, -1e308, 2**31, 2**32, 2**63, None, True, "1", [], {}]
ODD_TEXTS = ["", "lidar", "map", "none", "standard", "\0", "a" * 5000, "\ud800", "mpc.horizon=1", "robot.radius=3",
             "robot.linear_delay=0.6", "navigation.control_period=0.02", "path.margin=10", "safety.stop_margin=1",
             "robot.angular_acceleration_max=0.01", "mpc.step_length=nan", "robot.linear_max=1e308", "=", "mpc.horizon"]
KEYS = ["paused", "factor", "robot", "x", "y", "heading", "halted", "from", "to", "radius", "blocked", "body", "target",
        "assignment", "assignments", "sensing", "noise", "index"]
COMMANDS = ["pause", "step", "speed", "restart", "goal", "cancel", "pose", "reset_robot", "halt", "undo", "redo", "revert",
            "add_robot", "remove_robot", "paint", "walk", "remove_body", "set", "sense", "map", "fly", ""]


class Server:
    def __init__(self, program):
        self.process = subprocess.Popen([program, "serve", "--port", "0"], stdout=subprocess.PIPE)
        line = self.process.stdout.readline().decode()
        while line and not (found := re.search(r"http://127\.0\.0\.1:(\d+)/", line)):
            line = self.process.stdout.readline().decode()
        if not line:
            sys.exit("hostile_client: the server did not start")
        self.port = int(found[1])

    def connect(self):
        return socket.create_connection(("127.0.0.1", self.port), timeout=PATIENCE)

    def memory(self):
        with open(f"/proc/{self.process.pid}/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(PATIENCE)


def frame(payload, opcode=1, mask=True, first=0x80, length=None):
    """One WebSocket frame; `first` are its flags, `length` what it claims."""
    claimed = len(payload) if length is None else length
    head = bytes([first | opcode])
    flag = 0x80 if mask else 0
    if claimed < 126:
        head += bytes([flag | claimed])
    elif claimed < 65536:
        head += bytes([flag | 126]) + struct.pack(">H", claimed)
    else:
        head += bytes([flag | 127]) + struct.pack(">Q", claimed)
    return head + (b"\0\0\0\0" if mask else b"") + payload


def upgraded(server):
    """A WebSocket whose handshake was accepted; raises ConnectionError where it was not."""
    s = server.connect()
    s.sendall(f"GET /live HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
              "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n".encode())
    head = b""
    while b"\r\n\r\n" not in head:
        if not (got := s.recv(4096)):
            break
        head += got
    if b" 101 " in head.split(b"\r\n")[0]:
        return s
    s.close()
    raise ConnectionRefusedError("the handshake was refused")


def png(width, height, claimed=None):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    lines = b"".join(b"\0" + b"\xff" * width for _ in range(height))
    w, h = claimed or (width, height)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w, h, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


class HostileClient:
    def __init__(self, server, seed):
        self.server = server
        self.random = random.Random(seed)
        self.kept = []  # sockets that are left open

    def odd_value(self):
        r = self.random
        kind = r.randrange(4)
        if kind == 0:
            return {"x": r.choice(ODD_NUMBERS), "y": r.choice(ODD_NUMBERS)}
        if kind == 1:
            return r.choice(ODD_TEXTS)
        if kind == 2:
            return r.uniform(-10, 20)
        return r.choice(ODD_NUMBERS)

    def command(self):
        r = self.random
        message = {"do": r.choice(COMMANDS)}
        for key in KEYS:
            if r.random() < 0.5:
                message[key] = self.odd_value()
        if r.random() < 0.5:  # nearly right
            message.update(robot=r.randrange(3), x=r.uniform(-1, 12), y=r.uniform(-1, 12), heading=r.uniform(-9, 9),
                           paused=r.random() < 0.3, halted=r.random() < 0.3, factor=r.choice([0.01, 1, 100]),
                           radius=r.choice([0.1, 1, 100, 1e6]), blocked=r.random() < 0.5, index=r.randrange(9),
                           sensing=r.choice(["map", "lidar"]), noise=r.choice(["none", "standard"]),
                           assignment=r.choice(ODD_TEXTS))
            message["from"] = {"x": r.uniform(-1, 12), "y": r.uniform(-1, 12)}
            message["to"] = {"x": r.uniform(-1, 12), "y": r.choice([5.0, 1e6, -1e300])}
        text = json.dumps(message)
        if r.random() < 0.2:
            cut = r.randrange(len(text))
            text = text[:cut] + r.choice(["", "1e999", "[" * 2000, "\\u0000", "}"]) + text[cut + 1:]
        return text.encode()

    def commands(self):
        with upgraded(self.server) as s:
            for _ in range(self.random.randrange(1, 60)):
                s.sendall(frame(self.command()))

    def broken_frames(self):
        r = self.random
        with upgraded(self.server) as s:
            for _ in range(r.randrange(1, 8)):
                s.sendall(frame(r.randbytes(r.randrange(200)), opcode=r.randrange(16), mask=r.random() < 0.8,
                                first=r.choice([0x80, 0, 0x40, 0xf0]),
                                length=r.choice([None, None, 3, 70000, 2**40, 2**63 - 1])))

    def broken_requests(self):
        r = self.random
        lines = [b"GET / HTTP/1.1", b"POST /map HTTP/1.1", b"GET /live HTTP/1.1", b"GET /scenario.zip HTTP/1.1",
                 b"GET /report.html HTTP/1.1", b"BREW / HTTP/9.9", r.randbytes(50), b"", b"GET /" + b"a" * 50000 + b" HTTP/1.1"]
        fields = [b"Host: 127.0.0.1:%d" % self.server.port, b"Content-Length: 99999999999999999999", b"Content-Length: -1",
                  b"Transfer-Encoding: chunked", b"Content-Type: application/json", b"Upgrade: websocket", r.randbytes(30),
                  b"X: " + b"y" * 30000, b"Sec-WebSocket-Version: 7", b"Connection: Upgrade"]
        with self.server.connect() as s:
            s.sendall(b"\r\n".join([r.choice(lines)] + r.sample(fields, r.randrange(len(fields)))) +
                      r.choice([b"", b"\r\n\r\n", b"\r\n\r\n" + r.randbytes(500)]))

    def upload(self):
        r = self.random
        size = r.choice([1, 30, 60, 200])
        image = r.choice([png(size, size), png(4, 4, (2**31 - 1, 2**31 - 1)), png(4, 4, (60000, 60000)), r.randbytes(300),
                          b"P5\n%d 3\n%d\n" % (r.choice([1, 3, 10**9]), r.choice([0, 1, 255, 70000])) + r.randbytes(9)])
        origin = r.choice(["[0, 0, 0]", "[-1e308, 1e308, 0]", "[0, 0, .nan]", "[" * 500])
        yaml = (f"image: m.png\nresolution: {r.choice([0.1, 0.0001, 1e-300, -1, '.inf', 'a'])}\norigin: {origin}\nnegate: 0\n"
                f"occupied_thresh: {r.choice([0.65, 2, '.nan'])}\nfree_thresh: 0.196\n")
        body = json.dumps({"name": r.choice(ODD_TEXTS[:6]) or "m", "image": base64.b64encode(image).decode(), "yaml": yaml}).encode()
        if r.random() < 0.2:
            body = body[:r.randrange(len(body))]
        with self.server.connect() as s:
            s.sendall(b"POST /map HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n" %
                      (self.server.port, len(body)) + body)
            if r.random() < 0.7:
                s.recv(4096)

    def leave_open(self):
        """One that never reads, or never ends its request."""
        self.kept.append(upgraded(self.server) if self.random.random() < 0.5 else self.server.connect())
        if len(self.kept) > 12:
            self.kept.pop(0).close()

    def download_and_leave(self):
        path = self.random.choice(["/recording.mcap", "/report.html", "/scenario.zip", "/"])
        with self.server.connect() as s:
            s.sendall(f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\n\r\n".encode())
            s.recv(self.random.choice([1, 4096]))

    def act(self):
        deed = self.random.choice([self.commands, self.commands, self.commands, self.broken_frames, self.broken_requests,
                                   self.upload, self.leave_open, self.download_and_leave])
        try:
            deed()
        except ConnectionError:  # refused or cut off, which is right
            pass
        return deed.__name__


def still_serves(server):
    """Whether a new client that lets the world run receives three binary records."""
    end = time.monotonic() + PATIENCE
    received = b""
    while time.monotonic() < end:
        try:
            s = upgraded(server)
        except ConnectionError:  # too many clients; the odd ones are dropped by and by
            continue
        with s:
            for command in ('{"do":"revert"}', '{"do":"halt","halted":false}', '{"do":"speed","factor":1}',
                            '{"do":"pause","paused":false}', '{"do":"restart"}'):
                s.sendall(frame(command.encode()))
            s.settimeout(1.0)
            while time.monotonic() < end:
                try:
                    got = s.recv(1 << 16)
                except TimeoutError:
                    continue
                except ConnectionError:
                    break
                if not got:
                    break
                received += got
                if binary_frames(received) >= 3:
                    return True
            received = b""
    return False


def binary_frames(data):
    count = 0
    at = 0
    while at + 2 <= len(data):
        length = data[at + 1] & 0x7f
        head = 2
        if length == 126:
            length, head = int.from_bytes(data[at + 2:at + 4], "big"), 4
        elif length == 127:
            length, head = int.from_bytes(data[at + 2:at + 10], "big"), 10
        count += (data[at] & 0xf) == 2 and at + head + length <= len(data)
        at += head + length
    return count


def main():
    program = sys.argv[1]
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 600.0
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    server = Server(program)
    client = HostileClient(server, seed)
    end = time.monotonic() + seconds
    deeds = {}
    checks = 0
    most = 0
    failure = ""
    while time.monotonic() < end and not failure:
        try:
            for _ in range(10):
                name = client.act()
                deeds[name] = deeds.get(name, 0) + 1
        except TimeoutError:
            failure = "a connection was neither served nor ended"
        if failure:
            break
        if server.process.poll() is not None:
            failure = f"the server ended with {server.process.returncode}"
        elif not still_serves(server):
            failure = "a well-behaved client was not served"
        elif (most := max(most, server.memory())) > MOST_MEMORY:
            failure = f"the server needs {most / 1e6:.0f} MB"
        checks += 1
    if server.process.poll() is None:
        try:
            if (status := server.stop()) != 0 and not failure:
                failure = f"after its signal the server ended with {status}"
        except subprocess.TimeoutExpired:
            server.process.kill()
            failure = failure or "the server did not end after its signal"
    print(f"seed {seed}, {sum(deeds.values())} deeds: {deeds}, {checks} checks, at most {most / 1e6:.0f} MB")
    if failure:
        sys.exit(f"hostile_client: {failure}")


if __name__ == "__main__":
    main()
