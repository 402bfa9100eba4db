#!/usr/bin/env python3
"""Draws the project's own maps into scenarios/maps (PNG and map_server YAML). Standard library only.

Run it again after a change; the files are committed, so users need not run it.
"""

import math
import pathlib
import random
import struct
import zlib

RESOLUTION = 0.05
FREE, OCCUPIED = 254, 0
OUT = pathlib.Path(__file__).resolve().parent.parent / "scenarios" / "maps"


class Canvas:
    """A map in metres: draws shapes into cells whose centre they cover."""

    def __init__(self, width, height):
        self.columns = round(width / RESOLUTION)
        self.rows = round(height / RESOLUTION)
        self.cells = [bytearray([FREE] * self.columns) for _ in range(self.rows)]

    def fill(self, covers, box):
        low_x, low_y, high_x, high_y = box
        for j in range(max(0, int(low_y / RESOLUTION)), min(self.rows, int(high_y / RESOLUTION) + 2)):
            for i in range(max(0, int(low_x / RESOLUTION)), min(self.columns, int(high_x / RESOLUTION) + 2)):
                if covers((i + 0.5) * RESOLUTION, (j + 0.5) * RESOLUTION):
                    self.cells[j][i] = OCCUPIED

    def box(self, x, y, width, height, turn_deg=0.0):
        """A box with its centre at x, y, turned about it."""
        c, s = math.cos(math.radians(turn_deg)), math.sin(math.radians(turn_deg))
        reach = math.hypot(width, height) / 2

        def covers(px, py):
            u, v = (px - x) * c + (py - y) * s, -(px - x) * s + (py - y) * c
            return abs(u) <= width / 2 and abs(v) <= height / 2

        self.fill(covers, (x - reach, y - reach, x + reach, y + reach))

    def disc(self, x, y, radius):
        self.fill(lambda px, py: math.hypot(px - x, py - y) <= radius,
                  (x - radius, y - radius, x + radius, y + radius))

    def wall(self, x0, y0, x1, y1, thickness=0.15):
        length = math.hypot(x1 - x0, y1 - y0)
        self.box((x0 + x1) / 2, (y0 + y1) / 2, length + thickness, thickness,
                 math.degrees(math.atan2(y1 - y0, x1 - x0)))

    def frame(self):
        width, height = self.columns * RESOLUTION, self.rows * RESOLUTION
        for x0, y0, x1, y1 in ((0, 0, width, 0), (0, height, width, height), (0, 0, 0, height),
                               (width, 0, width, height)):
            self.wall(x0, y0, x1, y1, 0.3)

    def save(self, name, origin=(0.0, 0.0, 0.0)):
        raw = b"".join(b"\0" + bytes(row) for row in reversed(self.cells))

        def chunk(kind, data):
            body = kind + data
            return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

        header = struct.pack(">IIBBBBB", self.columns, self.rows, 8, 0, 0, 0, 0)
        OUT.mkdir(parents=True, exist_ok=True)
        (OUT / f"{name}.png").write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                                          chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))
        (OUT / f"{name}.yaml").write_text(
            f"image: {name}.png\nmode: trinary\nresolution: {RESOLUTION}\n"
            f"origin: [{origin[0]}, {origin[1]}, {origin[2]}]\n"
            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")


def workshop():
    """24 m x 16 m: two rooms, a hall with turned shelves, round pillars, and clutter."""
    m = Canvas(24, 16)
    m.frame()
    m.wall(7, 0, 7, 4.2)
    m.wall(7, 5.6, 7, 9.6)
    m.wall(0, 9.6, 3.6, 9.6)
    m.wall(5.0, 9.6, 7, 9.6)
    m.wall(17.2, 16, 17.2, 11.4)
    m.wall(17.2, 10.0, 17.2, 7.4)
    m.wall(17.2, 7.4, 20.6, 7.4)
    m.wall(22.2, 7.4, 24, 7.4)
    for x, y, turn in ((10.2, 4.0, 35), (12.4, 6.2, 35), (14.6, 8.4, 35), (10.6, 9.4, -30), (12.6, 12.6, -30)):
        m.box(x, y, 2.6, 0.6, turn)
    for x, y in ((9.0, 12.9), (15.2, 4.4), (19.6, 4.6), (3.2, 12.4)):
        m.disc(x, y, 0.35)
    for x, y, w, h, turn in ((2.6, 6.4, 1.6, 0.8, 15), (4.8, 2.6, 1.4, 0.7, -40), (18.4, 2.2, 1.8, 0.7, 60),
                             (21.4, 5.4, 0.9, 0.9, 45), (20.4, 10.6, 1.6, 0.8, 20), (21.4, 13.4, 0.7, 0.7, 30),
                             (5.6, 13.6, 1.8, 0.7, -20), (13.2, 2.0, 0.8, 0.8, 10), (15.6, 13.8, 0.9, 0.5, 0)):
        m.box(x, y, w, h, turn)
    rng = random.Random(7)
    for _ in range(14):
        x, y = rng.uniform(8, 16.5), rng.uniform(1, 15)
        m.box(x, y, 0.25, 0.25, rng.uniform(0, 90))
    m.save("workshop")


def doorways():
    """12 m x 8 m: three rooms in a row, joined by doors of 1.1 m."""
    m = Canvas(12, 8)
    m.frame()
    for x, door in ((4, 5.4), (8, 2.6)):
        m.wall(x, 0, x, door - 0.55)
        m.wall(x, door + 0.55, x, 8)
    m.box(2.2, 3.0, 1.2, 0.6, 30)
    m.box(6.0, 4.0, 1.0, 1.0, 45)
    m.disc(10.2, 5.4, 0.4)
    m.save("doorways", origin=(-6.0, -4.0, 0.0))


def long_passage():
    """24 m x 6 m: two rooms joined by a passage of 0.8 m, 16 m long."""
    m = Canvas(24, 6)
    m.frame()
    for y in (1.3, 4.7):
        m.box(12, y, 16, 2.6)
    m.save("long_passage")


def dead_end():
    """16 m x 6 m: a room, and a passage of 0.8 m that ends after 10 m."""
    m = Canvas(16, 6)
    m.frame()
    for y in (1.3, 4.7):
        m.box(10.5, y, 11, 2.6)
    m.box(15.5, 3, 1, 6)
    m.save("dead_end")


def square():
    """22 m x 22 m of open ground, where the people of ucy_zara01 walk."""
    m = Canvas(22, 22)
    m.save("square", origin=(-11.5, 2.0, 0.0))


if __name__ == "__main__":
    workshop()
    doorways()
    long_passage()
    dead_end()
    square()
