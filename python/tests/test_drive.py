# SPDX-License-Identifier: Apache-2.0
"""A robot drives with a map and without one; these tests also run from an installed wheel."""

import math
import threading

import numpy as np
import pytest

import fairway

PERIOD = 0.1  # [s]


def hall(rows: int = 60, columns: int = 100) -> fairway.Map:
    """A hall of 10 m x 6 m with a wall in the middle that leaves the upper third open."""
    cells = np.zeros((rows, columns), np.int8)
    cells[:40, 50] = 100
    return fairway.Map.from_array(cells, 0.1, (0, 0))


def drive(navigator, pose, goal, seconds=60.0, **more):
    navigator.set_goal(*goal)
    for cycle in range(int(seconds / PERIOD)):
        step = navigator.update(cycle * PERIOD, pose, **more)
        if step.status == fairway.NavigationStatus.GoalReached:
            return pose, cycle * PERIOD
        pose = fairway.step(pose, step.command, PERIOD)
    raise AssertionError(f"did not arrive: {pose}, {step.status}")


def test_reaches_a_goal_around_a_wall():
    navigator = fairway.MapNavigator(fairway.Settings(), hall())
    pose, time = drive(navigator, (1, 1, 0), (9, 1))
    assert math.dist(pose[:2], (9, 1)) <= 0.1
    assert 10 < time < 40
    assert navigator.plan.usable and navigator.plan_is_current


def test_zones_are_obeyed_and_a_hold_keeps_the_goal():
    navigator = fairway.MapNavigator(fairway.Settings(), hall())
    navigator.set_zones([
        {"kind": "keep_out", "polygon": [(2, -1), (3, -1), (3, 2.5), (2, 2.5)]},
        {"kind": "speed_limit", "polygon": [(6, 0), (8, 0), (8, 6), (6, 6)], "speed": 0.3},
    ])
    pose, time = drive(navigator, (1, 1, 0), (1, 5))
    navigator.set_goal(4, 1)
    navigator.hold()
    assert navigator.on_hold
    assert navigator.update(time + 0.1, pose).status == fairway.NavigationStatus.Holding
    navigator.resume()
    assert not navigator.on_hold
    with pytest.raises(ValueError, match=r"zones\[0\].polygon: expected 3 to 1000 corners"):
        navigator.set_zones([{"kind": "keep_out", "polygon": [(0, 0), (1, 1)]}])
    with pytest.raises(ValueError, match=r"zones\[0\].kind"):
        navigator.set_zones([{"kind": "keepout", "polygon": []}])


def test_reaches_the_heading_of_a_goal():
    pose, _ = drive(fairway.MapNavigator(fairway.Settings(), hall()), (1, 1, 0), (4, 1, 1.5))
    assert abs(pose[2] - 1.5) <= 0.1


def test_only_the_arrival_has_a_goal_in_its_name():
    for name, status in fairway.NavigationStatus.__members__.items():
        if name == "GoalReached":
            assert "GoalReached" in str(status)
        else:
            assert "goal" not in str(status).lower()


def test_a_step_has_commands_within_the_limits_and_a_prediction():
    settings = fairway.Settings()
    navigator = fairway.MapNavigator(settings, hall())
    navigator.set_goal(9, 1)
    step = navigator.update(0.0, np.array([1.0, 1.0, 0.0]))
    assert step.command == (step.linear, step.angular)
    assert 0 < step.linear <= settings.robot.linear_max
    assert step.poses.shape == (settings.mpc.horizon + 1, 3)
    assert step.commands.shape == (settings.mpc.horizon, 2)
    np.testing.assert_allclose(step.poses[0], (1, 1, 0))


def test_equal_inputs_give_equal_bits():
    runs = [drive(fairway.MapNavigator(fairway.Settings(), hall()), (1, 1, 0), (9, 1))
            for _ in range(2)]
    assert runs[0] == runs[1]


def test_stops_for_a_pose_that_is_not_finite_and_without_a_goal():
    navigator = fairway.MapNavigator(fairway.Settings(), hall())
    assert navigator.update(0, (1, 1, 0)).status == fairway.NavigationStatus.NoPlan
    navigator.set_goal(9, 1)
    step = navigator.update(0.1, (math.nan, 1, 0))
    assert step.command == (0, 0)
    assert step.status == fairway.NavigationStatus.BadInput
    assert step.limit == fairway.LimitingFactor.InvalidPose


def test_keeps_away_from_a_moving_obstacle():
    navigator = fairway.MapNavigator(fairway.Settings(), hall())
    navigator.set_goal(1, 5)
    pose, least = (1, 1, math.pi / 2), math.inf
    for cycle in range(300):
        person = np.array([[4 - 0.05 * cycle, 3, -0.5, 0, 0.3]])
        step = navigator.update(cycle * PERIOD, pose, obstacles=person)
        if step.status == fairway.NavigationStatus.GoalReached:
            break
        least = min(least, math.dist(pose[:2], person[0, :2]))
        pose = fairway.step(pose, step.command, PERIOD)
    assert step.status == fairway.NavigationStatus.GoalReached
    assert least > 0.3 + 0.25


def test_plans_again_when_the_map_changes():
    cells = np.zeros((60, 100), np.int8)
    cells[:, 50] = 100
    navigator = fairway.MapNavigator(fairway.Settings(), fairway.Map.from_array(cells, 0.1))
    navigator.set_goal(9, 1)
    assert navigator.update(0, (1, 1, 0)).status == fairway.NavigationStatus.NoPlan
    assert "no path" in navigator.plan.reason
    cells[45:, 50] = 0
    navigator.update_map(fairway.Map.from_array(cells, 0.1), (0, 50), (59, 50))
    assert not navigator.obstacles[50, 50] and navigator.obstacles[10, 50]
    navigator.update(1, (1, 1, 0))
    assert navigator.plan.usable


def test_follows_a_given_path():
    navigator = fairway.MapNavigator(fairway.Settings(), hall())
    path = np.array([[1, 1], [1, 3], [3, 5]])
    navigator.follow(path)
    navigator.update(0, (1, 1, 0))
    np.testing.assert_allclose(navigator.plan.path[-1], (3, 5))
    navigator.cancel()
    assert navigator.update(0.1, (1, 1, 0)).linear <= 0.2


def test_drives_without_a_map():
    navigator = fairway.MaplessNavigator(fairway.Settings(), (0, 0))
    angles = np.linspace(-math.pi, math.pi, 360, endpoint=False)
    pose = (0.0, 0.0, 0.0)
    navigator.set_goal(4, 0)
    for cycle in range(300):
        # The distance to the walls of a room of 12 m x 12 m around the origin.
        directions = np.column_stack([np.cos(angles + pose[2]), np.sin(angles + pose[2])])
        with np.errstate(divide="ignore", invalid="ignore"):
            walls = (6 * np.sign(directions) - np.array(pose[:2])) / directions
        navigator.observe(cycle * PERIOD, np.nanmin(walls, axis=1), pose, max_range=20.0)
        step = navigator.update(cycle * PERIOD, pose)
        if step.status == fairway.NavigationStatus.GoalReached:
            break
        pose = fairway.step(pose, step.command, PERIOD)
    assert step.status == fairway.NavigationStatus.GoalReached
    assert navigator.tracked.shape == (0, 5)


def test_robots_share_what_they_intend():
    ways = [((1, 3, 0), (9, 3)), ((9, 3.2, math.pi), (1, 3.2))]
    empty = fairway.Map.from_array(np.zeros((60, 100), np.int8), 0.1)
    robots = [fairway.MapNavigator(fairway.Settings(), empty) for _ in ways]
    poses = [start for start, _ in ways]
    for robot, (_, goal) in zip(robots, ways):
        robot.set_goal(*goal)
    messages = [robot.share(i, 0.0, poses[i]) for i, robot in enumerate(robots)]
    arrived, least = [False, False], math.inf
    for cycle in range(600):
        for i, robot in enumerate(robots):
            step = robot.update(cycle * PERIOD, poses[i], fleet=[messages[1 - i]], robot=i)
            messages[i] = robot.share(i, cycle * PERIOD, poses[i])
            arrived[i] = step.status == fairway.NavigationStatus.GoalReached
            poses[i] = fairway.step(poses[i], step.command, PERIOD)
        least = min(least, math.dist(poses[0][:2], poses[1][:2]))
        if all(arrived):
            break
    assert all(arrived)
    assert least > 0.5


def test_settings_can_change_while_driving():
    navigator = fairway.MapNavigator(fairway.Settings(), hall())
    changed = navigator.settings
    changed.robot.linear_max = 0.4
    assert navigator.settings.robot.linear_max == 1.0
    navigator.settings = changed
    assert navigator.settings.robot.linear_max == 0.4


def test_invalid_settings_are_refused():
    settings = fairway.Settings()
    settings.robot.linear_min = 0.5
    settings.robot.linear_max = 0.3
    with pytest.raises(ValueError, match="robot.linear"):
        fairway.MapNavigator(settings, hall())


@pytest.mark.parametrize("pose", [(1, 1), (1, 1, 0, 0), "abc", 3, (1, 1, "x"), None])
def test_a_pose_has_three_numbers(pose):
    navigator = fairway.MapNavigator(fairway.Settings(), hall())
    with pytest.raises(ValueError, match="pose: expected x, y, heading, found"):
        navigator.update(0, pose)


def test_other_threads_run_during_an_update():
    """A thread that plans holds no lock that others need."""
    navigator = fairway.MapNavigator(fairway.Settings(), hall())
    done = threading.Event()

    def turn() -> None:
        for cycle in range(200):
            navigator.set_goal(9, 1 + cycle % 2)
            navigator.update(cycle * PERIOD, (1, 1, 0))
        done.set()

    threads = [threading.Thread(target=turn) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert done.is_set()


CAR = {"kind": "car", "length": 1.6, "width": 0.7, "reference_to_front": 1.3, "wheelbase": 1.0, "steering_max": 0.6,
       "steering_rate_max": 0.8, "linear_min": -0.6, "linear_max": 1.2, "angular_max": 1.5, "linear_acceleration": 0.8,
       "angular_acceleration": 3.0}
MECANUM = {"kind": "omni", "length": 1.2, "width": 0.8, "linear_min": -1.0, "linear_max": 1.0, "lateral_max": 0.6,
           "angular_max": 1.2, "linear_acceleration": 0.8, "lateral_acceleration": 0.8, "angular_acceleration": 2.0,
           "wheels": {"type": "mecanum", "half_sum": 0.9, "speed_max": 1.2}}


def drive_body(navigator, pose, goal, seconds=60.0, **more):
    navigator.set_goal(*goal)
    for cycle in range(int(seconds / PERIOD)):
        step = navigator.update(cycle * PERIOD, pose, **more)
        if step.status == fairway.NavigationStatus.GoalReached:
            return pose
        pose = navigator.robot.moved(pose, (step.linear, step.lateral, step.angular), PERIOD)
    raise AssertionError(f"did not arrive: {pose}, {step.status} {step.limit}")


@pytest.mark.parametrize("keys", [CAR, MECANUM])
def test_a_body_reaches_a_pose_around_a_wall(keys):
    navigator = fairway.BodyNavigator(fairway.Settings(), fairway.RobotModel(keys), hall())
    pose = drive_body(navigator, (2.0, 1.0, 0.0), (8.0, 2.0, -1.5))
    assert math.dist(pose[:2], (8, 2)) <= 0.1
    assert abs(pose[2] + 1.5) <= 0.1
    assert navigator.plan.usable


def test_a_body_obeys_zones():
    navigator = fairway.BodyNavigator(fairway.Settings(), fairway.RobotModel(MECANUM), hall())
    navigator.set_zones([{"kind": "keep_out", "polygon": [(0, 0), (10, 0), (10, 10), (0, 10)]}])
    navigator.set_goal(2.0, 3.0)
    step = navigator.update(0, (2.0, 1.0, 0.0))
    assert step.command == (0, 0)
    assert not navigator.plan.usable


def test_bodies_share_their_motions():
    goals = [(8.0, 1.0), (2.0, 1.5)]
    poses = [(2.0, 1.0, 0.0), (8.0, 1.5, math.pi)]
    model = fairway.RobotModel({**MECANUM, "length": 0.6, "width": 0.5})
    open_hall = fairway.Map.from_array(np.zeros((60, 100), np.int8), 0.1, (0, 0))
    robots = [fairway.BodyNavigator(fairway.Settings(), model, open_hall) for _ in poses]
    for robot, goal in zip(robots, goals):
        robot.set_goal(*goal)
    shared = [None, None]
    arrived = [False, False]
    for cycle in range(600):
        for i, robot in enumerate(robots):
            others = [motion for j, motion in enumerate(shared) if j != i and motion is not None]
            step = robot.update(cycle * PERIOD, poses[i], fleet=others, robot=i)
            arrived[i] = step.status == fairway.NavigationStatus.GoalReached
            shared[i] = robot.share(i, cycle * PERIOD, poses[i])
            assert shared[i].robot == i
            poses[i] = model.moved(poses[i], (step.linear, step.lateral, step.angular), PERIOD)
        assert math.dist(poses[0][:2], poses[1][:2]) > 0.5
        if all(arrived):
            break
    assert all(arrived)


def test_a_body_drives_on_its_scans():
    navigator = fairway.BodyNavigator(fairway.Settings(), fairway.RobotModel(MECANUM))
    assert navigator.update(0, (0, 0, 0)).limit == fairway.LimitingFactor.StaleMap
    angles = np.linspace(-math.pi, math.pi, 360, endpoint=False)
    pose = (0.0, 0.0, 0.0)
    navigator.set_goal(3, 1)
    for cycle in range(300):
        directions = np.column_stack([np.cos(angles + pose[2]), np.sin(angles + pose[2])])
        with np.errstate(divide="ignore", invalid="ignore"):
            walls = (6 * np.sign(directions) - np.array(pose[:2])) / directions
        assert navigator.observe(cycle * PERIOD, np.nanmin(walls, axis=1), pose, max_range=20.0)
        step = navigator.update(cycle * PERIOD, pose)
        if step.status == fairway.NavigationStatus.GoalReached:
            break
        pose = navigator.robot.moved(pose, (step.linear, step.lateral, step.angular), PERIOD)
    assert step.status == fairway.NavigationStatus.GoalReached
    assert navigator.tracked.shape == (0, 5)


def test_a_robot_model_is_read_and_its_errors_name_the_key():
    model = fairway.RobotModel(CAR)
    assert model.kind == "car"
    assert model.outline.shape == (4, 2)
    assert model.outline[:, 0].max() == pytest.approx(1.3)
    with pytest.raises(ValueError, match="wheelbase: expected"):
        fairway.RobotModel({**CAR, "wheelbase": -1})
    with pytest.raises(ValueError, match="expected length and width, footprint or discs"):
        fairway.RobotModel({key: value for key, value in CAR.items() if key not in ("length", "width")})
    with pytest.raises(ValueError, match="no_such_file"):
        fairway.RobotModel.read("no_such_file.yaml")
