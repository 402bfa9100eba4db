# SPDX-License-Identifier: Apache-2.0
"""Scenarios, callbacks, recordings and benchmarks."""

import math
import os
import pathlib

import numpy as np
import pytest

import fairway

ROOT = pathlib.Path(__file__).resolve().parents[2]


def crossing() -> fairway.Scenario:
    scenario = fairway.Scenario(fairway.Map.from_array(np.zeros((160, 200)), 0.05))
    scenario.add_robot((1, 4, 0), (9, 4), name="amr")
    scenario.add_obstacle([(0, 5, 7.5), (7, 5, 0.5)])
    return scenario


def test_a_robot_crosses_a_hall():
    episode = fairway.simulate(crossing())
    robot = episode.robots[0]
    assert episode.success and robot.reached and not robot.collided
    assert robot.name == "amr" and robot.min_separation > 0 and robot.length >= 7.9
    assert sum(robot.status_counts.values()) == robot.cycles == len(episode.trace)
    assert fairway.NavigationStatus.GoalReached in robot.status_counts
    assert len(robot.cycle_seconds) == robot.cycles
    np.testing.assert_allclose(np.diff(episode.trace["time"]), 0.1)
    assert episode.trace["x"][0] == 1 and abs(episode.trace["x"][-1] - 9) < 0.1


def test_equal_scenarios_give_equal_bits():
    first, second = (fairway.simulate(crossing()).trace for _ in range(2))
    assert first.tobytes() == second.tobytes()


def test_callbacks_see_the_run():
    times, plans, steps = [], [], []
    episode = fairway.simulate(
        crossing(), on_cycle=times.append, on_plan=lambda *event: plans.append(event),
        on_step=lambda *event: steps.append(event))
    assert len(steps) == episode.robots[0].cycles
    assert len(times) == len(steps) - 1
    assert plans[0][1] == 0 and plans[0][2].usable
    time, robot, pose, twist, step = steps[5]
    assert (robot, len(pose), len(twist)) == (0, 3, 2)
    assert time == pytest.approx(0.5) and step.poses.shape[1] == 3
    assert step.linear == episode.trace["command_linear"][5]


@pytest.mark.parametrize("kind", [bool, np.bool_, int])
def test_a_callback_ends_the_run(kind):
    episode = fairway.simulate(crossing(), on_cycle=lambda time: kind(time < 1))
    assert not episode.success and episode.time == pytest.approx(1.0, abs=0.11)


@pytest.mark.parametrize("name", ["on_cycle", "on_plan", "on_step", "play"])
def test_an_exception_of_a_callback_is_passed_on(name):
    calls = []

    def fail(*_):
        calls.append(1)
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        fairway.simulate(crossing(), **{name: fail})
    assert len(calls) == 1


def test_play_changes_the_run():
    kept = []

    def play(control):
        kept.append(control)
        if control.time > 0.95 and len(control.obstacles) == 1:
            control.set_goal(0, (1, 7))
            control.set_obstacle(1, [(0, 9, 1)])
            control.set_cells([(80, 100), (9999, 0)], True)
        return not (control.time > 1 and math.dist(control.poses[0][:2], (1, 7)) < 0.2)

    scenario = crossing()
    scenario.robots  # a copy: the run does not change the scenario
    fairway.simulate(scenario, play=play)
    assert scenario.robots[0][2] == (9, 4)
    with pytest.raises(ValueError, match="inside the callback"):
        kept[0].time


def test_play_refuses_what_does_not_exist():
    def play(control):
        for wrong in (lambda: control.set_goal(1, (1, 7)), lambda: control.remove_obstacle(1),
                      lambda: control.set_obstacle(2, [(0, 1, 1)]),
                      lambda: control.set_obstacle(0, [])):
            with pytest.raises(ValueError, match="expected"):
                wrong()
        return False

    fairway.simulate(crossing(), play=play)


def test_a_lidar_and_its_noise():
    scenario = crossing()
    scenario.sensing, scenario.noise = "lidar", "standard"
    assert (scenario.sensing, scenario.noise) == ("lidar", "standard")
    assert fairway.simulate(scenario).success
    with pytest.raises(ValueError, match="sensing: expected map or lidar, found"):
        scenario.sensing = "sonar"


def test_a_recording_is_the_same_to_the_bit(tmp_path):
    log, page = tmp_path / "run.mcap", tmp_path / "run.html"
    episode = fairway.simulate(crossing(), log=log, report=page)
    plans = []
    replay = fairway.replay(log, on_plan=lambda *event: plans.append(event))
    assert replay.same and replay.first_difference is None
    assert replay.cycles == episode.robots[0].cycles
    assert plans
    assert "<html" in page.read_text()
    log.write_bytes(log.read_bytes()[:100])
    with pytest.raises(ValueError, match="run.mcap"):
        fairway.replay(log)


@pytest.mark.parametrize("change, text", [
    (lambda s: s.add_obstacle([]), "key_frames: expected at least one row"),
    (lambda s: s.add_obstacle([(1, 0, 0), (0, 1, 1)]), "key_frames: expected finite numbers and"),
    (lambda s: fairway.simulate(fairway.Scenario(s.map)), "robots: expected at least one"),
    (lambda s: fairway.simulate(s, log="/none/run.mcap"), "/none/run.mcap"),
    (lambda s: fairway.simulate(s, report="/none/run.html"), "/none/run.html"),
    (lambda s: fairway.Scenario.read("none.yaml"), "none.yaml"),
])
def test_wrong_inputs_are_refused(change, text):
    with pytest.raises(ValueError, match=text):
        change(crossing())


def test_a_scenario_from_a_file_and_its_settings():
    scenario = fairway.Scenario.read(ROOT / "scenarios/workshop.yaml")
    scenario.settings.robot.linear_max = 0.8
    assert scenario.settings.robot.linear_max == 0.8
    episode = fairway.simulate(scenario)
    assert episode.success
    assert episode.trace["command_linear"].max() <= 0.8 + 1e-9


def test_worlds_of_barn():
    folder = pathlib.Path(os.environ.get("FAIRWAY_SHARED_DATA", "")) / "barn"
    if not folder.is_dir():
        pytest.skip("the worlds of BARN are not here")
    worlds = fairway.read_barn(folder)
    world = worlds[0]
    score = world.score(0, fairway.simulate(world.scenario()))
    assert len(worlds) > 10 and score.world == world.number
    assert score.success and 0 < score.score <= 0.5
