#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what a call of `update` costs in Python beyond the library's own time.

    PYTHONPATH=build/release/python python3 benchmarks/python_overhead.py

A navigator without a map answers at once, so the time of its calls is the cost of the binding: reading
the arguments, releasing and taking Python's lock, and making the answer. A drive is timed beside it.
"""

import statistics
import time

import numpy as np

import fairway


def median_us(call, repeats: int = 7, calls: int = 20_000) -> float:
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        for _ in range(calls):
            call()
        times.append((time.perf_counter() - start) / calls * 1e6)
    return statistics.median(times)


def main() -> None:
    settings = fairway.Settings()
    empty = fairway.MapNavigator(settings)
    people = np.array([[5.0, 5.0, 0.0, 0.0, 0.3]] * 8)

    def nothing() -> None:
        pass

    def update() -> None:
        empty.update(1.0, (1.0, 1.0, 0.0))

    def update_and_read() -> None:
        step = empty.update(1.0, (1.0, 1.0, 0.0))
        step.linear, step.angular, step.status

    def update_with_people() -> None:
        empty.update(1.0, (1.0, 1.0, 0.0), obstacles=people)

    base = median_us(nothing)
    print("cost of a call in Python [us], median of 7 x 20000")
    for name, call in (("update(time, pose)", update), ("with .linear, .angular, .status", update_and_read),
                       ("with an array of 8 obstacles", update_with_people)):
        print(f"  {name:<34} {median_us(call) - base:6.2f}")

    grid = fairway.Map.from_array(np.zeros((120, 200), np.int8), 0.05, (0, 0))
    navigator = fairway.MapNavigator(settings, grid)
    navigator.set_goal(9, 1)
    robot, times = (1.0, 1.0, 0.0), []
    for cycle in range(600):
        start = time.perf_counter()
        step = navigator.update(0.1 * cycle, robot)
        times.append((time.perf_counter() - start) * 1e6)
        if step.status == fairway.NavigationStatus.GoalReached:
            break
        robot = fairway.step(robot, (step.linear, step.angular), 0.1)
    print(f"a drive of {len(times)} cycles: median {statistics.median(times):.1f} us a cycle, plan included")


if __name__ == "__main__":
    main()
