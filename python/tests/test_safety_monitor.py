# SPDX-License-Identifier: Apache-2.0
"""The safety monitor."""

import numpy as np
import pytest

import fairway

BODY = [(-0.3, -0.2), (0.3, -0.2), (0.3, 0.2), (-0.3, 0.2)]


def test_a_command_passes_in_the_open_and_is_reduced_before_a_wall():
    assert fairway.SafetyMonitor([BODY]).check(0.0, (0, 0, 0), (1, 0), (1, 0)).reason == "no new points"
    monitor = fairway.SafetyMonitor([BODY])
    assert monitor.see(0.0, [])
    assert monitor.check(0.0, (0, 0, 0), (1, 0), (1, 0)).fraction == 1.0
    assert monitor.see(0.1, np.array([[0.8, 0.0]]))
    verdict = monitor.check(0.1, (0, 0, 0), (1, 0), (1, 0.5))
    assert verdict.reason == "obstacle"
    assert verdict.command == (verdict.fraction, 0.5 * verdict.fraction)
    assert 0.0 <= verdict.fraction < 1.0


def test_zones_stop_the_robot_or_slow_it_down():
    zone = [(0.3, -1.0), (2.0, -1.0), (2.0, 1.0), (0.3, 1.0)]
    slow = fairway.SafetyMonitor([BODY], slow_zone=zone, slow_speed=0.25)
    stop = fairway.SafetyMonitor([BODY], stop_zone=zone)
    for monitor in (slow, stop):
        assert monitor.see(0.0, [(1.5, 0.9)])
    assert slow.check(0.0, (0, 0, 0), (0, 0), (-1, 0)).command == (-0.25, 0.0)
    assert stop.check(0.0, (0, 0, 0), (0, 0), (-1, 0)).reason == "stop zone"


def test_it_remembers_what_is_on_its_way_until_it_is_reset():
    monitor = fairway.SafetyMonitor([BODY], delay=0.6, linear_acceleration=10.0)
    monitor.see(0.0, [(0.7, 0.0)])
    assert monitor.check(0.0, (0, 0, 0), (1, 0), (0, 0)).fraction == 0.0
    monitor.reset()
    assert monitor.check(0.1, (0, 0, 0), (0, 0), (0, 0)).fraction == 1.0


def test_points_that_are_not_finite_are_refused():
    monitor = fairway.SafetyMonitor([BODY])
    assert not monitor.see(0.0, [(float("nan"), 0.0)])
    assert not monitor.see(0.0, np.zeros((8193, 2)))


@pytest.mark.parametrize("settings", [{"delay": -1.0}, {"linear_acceleration": 0.0}, {"margin": float("nan")},
                                      {"stop_zone": [(0, 0), (1, 1)]}])
def test_bad_settings_are_value_errors(settings):
    with pytest.raises(ValueError, match="monitor: expected"):
        fairway.SafetyMonitor([BODY], **settings)
    with pytest.raises(ValueError, match="monitor: expected"):
        fairway.SafetyMonitor([])
