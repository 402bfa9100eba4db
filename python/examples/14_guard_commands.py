# SPDX-License-Identifier: Apache-2.0
"""A monitor behind a controller that sees no obstacle: the robot stops before the wall."""

import fairway

body = [(-0.35, -0.25), (0.35, -0.25), (0.35, 0.25), (-0.35, 0.25)]
around = [(-0.4, -0.6), (1.2, -0.6), (1.2, 0.6), (-0.4, 0.6)]
monitor = fairway.SafetyMonitor(
    [body], slow_zone=around, slow_speed=0.4, linear_acceleration=1.0, linear_braking=0.8, delay=0.2, ramp=0.1)

period = 0.1  # [s]
wall = [(3.0, 0.02 * i) for i in range(-50, 51)]
pose, sent, on_their_way = (0.0, 0.0, 0.0), (0.0, 0.0), [(0.0, 0.0)] * 2
reasons = set()
for cycle in range(120):
    monitor.see(cycle * period, wall)
    wanted = (min(1.0, sent[0] + 0.1), 0.0)  # a controller that only knows its acceleration
    verdict = monitor.check(cycle * period, pose, sent, wanted)
    reasons.add(verdict.reason)
    sent = verdict.command
    on_their_way.append(sent)
    pose = fairway.step(pose, on_their_way.pop(0), period)

left = 3.0 - 0.35 - pose[0]
print(f"stopped {left:.2f} m before the wall; reasons: {', '.join(sorted(reasons))}")
assert 0.0 < left < 0.6
assert {"none", "slow zone"} <= reasons
