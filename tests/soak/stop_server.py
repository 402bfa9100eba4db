#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Ends `fairway serve` by SIGTERM in awkward moments: stop_server.py FAIRWAY.

During half an upload, while a large map is decoded, and while the world is late. The server must end
with exit code 0 after at most 2 s of its own CPU time, however slow the machine is; one that waits
for a client never ends, which the patience finds.
"""
import base64
import json
import os
import signal
import sys
import time

from hostile_client import Server, frame, png, upgraded

PATIENCE = 60.0  # [s] of a loaded machine; an idle one needs far less than 2 s
MOST_CPU = 2.0  # [s] after the signal


def cpu_seconds(pid):
    with open(f"/proc/{pid}/stat") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def post(server, body, part):
    s = server.connect()
    s.sendall(b"POST /map HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n" %
              (server.port, len(body)) + body[:part])
    return s


def half_an_upload(server):
    return [post(server, b'{"name": "m", "image": "' + b"A" * 3_000_000, 1_000_000)]


def a_large_map(server):
    image = base64.b64encode(png(6000, 6000)).decode()
    body = json.dumps({"name": "m", "image": image, "yaml": "image: m.png\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                       "occupied_thresh: 0.65\nfree_thresh: 0.196\n"}).encode()
    return [post(server, body, len(body))]


def a_late_world(server):
    s = upgraded(server)
    for x in range(12):
        s.sendall(frame(json.dumps({"do": "add_robot", "x": 1.5 + 0.7 * x, "y": 1.5, "heading": 0.0}).encode()))
    for command in ('{"do":"halt","halted":false}', '{"do":"speed","factor":100}', '{"do":"pause","paused":false}'):
        s.sendall(frame(command.encode()))
    s.recv(1 << 16)  # it runs; from now on nothing is read
    return [s]


def ends_after(program, deed):
    server = Server(program)
    process = server.process
    kept = deed(server)
    process.send_signal(signal.SIGTERM)
    before = cpu_seconds(process.pid)
    end = time.monotonic() + PATIENCE
    while (ended := os.wait4(process.pid, os.WNOHANG))[0] == 0:
        if time.monotonic() > end:
            process.kill()
            print(f"{deed.__name__}: the server did not end")
            return False
        time.sleep(0.01)
    process.returncode = os.waitstatus_to_exitcode(ended[1])
    used = ended[2].ru_utime + ended[2].ru_stime - before
    for s in kept:
        s.close()
    good = process.returncode == 0 and used <= MOST_CPU
    print(f"{deed.__name__}: exit code {process.returncode} after {used:.2f} s of CPU time")
    return good


def main():
    if len(sys.argv) != 2:
        print("usage: stop_server.py FAIRWAY", file=sys.stderr)
        return 2
    return 0 if all([ends_after(sys.argv[1], deed) for deed in (half_an_upload, a_large_map, a_late_world)]) else 1


if __name__ == "__main__":
    sys.exit(main())
