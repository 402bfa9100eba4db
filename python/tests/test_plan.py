# SPDX-License-Identifier: Apache-2.0
"""Paths and corridors."""

import concurrent.futures
import math
import pathlib

import numpy as np
import pytest

import fairway

ROOT = pathlib.Path(__file__).resolve().parents[2]


def wall() -> np.ndarray:
    cells = np.zeros((80, 120), np.int8)
    cells[:60, 60] = 100
    return cells


def test_finds_a_path_and_a_free_corridor():
    cells = wall()
    grid = fairway.Map.from_array(cells, 0.1)
    plan = fairway.plan(grid, (1, 1), (11, 1))
    assert plan.usable and plan.path_status == fairway.PathStatus.Found
    np.testing.assert_allclose(plan.path[[0, -1]], [(1, 1), (11, 1)])
    assert plan.length == pytest.approx(np.linalg.norm(np.diff(plan.path, axis=0), axis=1).sum())
    occupied = 0.1 * (np.argwhere(cells)[:, ::-1] + 0.5)
    for rectangle in plan.rectangles:
        assert not any(rectangle.contains(point) for point in occupied)
    first, last = plan.rectangles[0], plan.rectangles[-1]
    assert first.contains((1, 1), 1e-9) and last.contains((11, 1), 1e-9)


def test_says_why_there_is_no_plan():
    grid = fairway.Map.from_array(wall(), 0.1)
    blocked = fairway.plan(grid, (1, 1), (6.05, 3))
    assert not blocked.usable
    assert blocked.path_status == fairway.PathStatus.GoalBlocked
    assert blocked.reason == fairway.PathStatus.GoalBlocked.text
    assert fairway.plan(grid, (-1, 1), (11, 1)).path_status == fairway.PathStatus.StartOutsideMap
    assert fairway.plan(grid, (math.nan, 1), (11, 1)).path_status == fairway.PathStatus.StartOutsideMap


def test_settings_count():
    grid = fairway.Map.from_array(wall(), 0.1)
    settings = fairway.Settings()
    settings.robot.radius = 2.0
    assert not fairway.plan(grid, (3, 3), (9, 3), settings).usable
    settings.robot.radius, settings.corridor.space = 0.3, "workspace"
    assert fairway.plan(grid, (3, 3), (9, 3), settings).corridor.space == "workspace"


def test_a_planner_serves_several_threads():
    planner = fairway.Planner(fairway.Map.from_array(wall(), 0.1))
    goals = [(11, 1 + 0.1 * i) for i in range(16)]
    alone = [planner.plan((1, 1), goal).path for goal in goals]
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda goal: planner.plan((1, 1), goal).path, goals))
    for a, b in zip(alone, together):
        np.testing.assert_array_equal(a, b)


def test_a_corridor_along_a_path_of_ones_own():
    grid = fairway.Map.from_array(wall(), 0.1)
    result = fairway.build_corridor(grid, [(1, 1), (4, 7), (8, 7), (11, 1)])
    assert result.built and result.status == fairway.CorridorStatus.Built
    assert len(result.corridor) == len(result.corridor.rectangles) > 1
    assert result.corridor.spans.shape == (len(result.corridor), 2)
    assert result.corridor.admissible(0).area <= result.corridor.rectangles[0].area
    with pytest.raises(IndexError):
        result.corridor.admissible(len(result.corridor))
    through = fairway.build_corridor(grid, [(1, 1), (11, 1)])
    assert through.status == fairway.CorridorStatus.SeedBlocked
    assert 4 < through.stuck_at < 6
    with pytest.raises(ValueError, match="path: expected an array with 2 columns"):
        fairway.build_corridor(grid, [1, 2, 3])


def test_a_corridor_is_updated_with_the_map():
    cells = wall()
    builder = fairway.CorridorBuilder()
    before = builder.build(fairway.Map.from_array(cells, 0.1), [(1, 1), (4, 7), (8, 7), (11, 1)])
    assert before.built
    cells[74:79, 58:63] = 100
    after = builder.update(fairway.Map.from_array(cells, 0.1), (74, 58), (78, 62))
    assert after.built
    new = 0.1 * (np.argwhere(cells[74:79, 58:63])[:, ::-1] + (58.5, 74.5))
    assert not any(r.contains(point) for r in after.corridor.rectangles for point in new)


def test_a_rectangle_is_turned_about_its_seed():
    rectangle = fairway.Rectangle(seed=(1, 2), orientation=math.pi / 2, min=(-1, -1), max=(3, 1))
    assert rectangle.area == pytest.approx(8)
    np.testing.assert_allclose(rectangle.center, (1, 3))
    np.testing.assert_allclose(rectangle.to_world((3, 0)), (1, 5))
    np.testing.assert_allclose(rectangle.to_local((1, 5)), (3, 0), atol=1e-12)
    np.testing.assert_allclose(rectangle.corners, [(2, 1), (2, 5), (0, 5), (0, 1)], atol=1e-12)
    assert rectangle.contains((2, 5), 1e-9) and not rectangle.contains((2.1, 3))
    assert rectangle.shrunk(1.5).is_empty
    rectangle.max = (5, 1)
    assert rectangle.area == pytest.approx(12)


def test_plans_on_a_map_from_a_file():
    grid = fairway.Map.read(ROOT / "scenarios/maps/workshop.yaml")
    assert fairway.plan(grid, (2, 4.4), (22.2, 14.6)).usable


def test_why_there_is_no_path_has_a_place_and_widths():
    cells = np.zeros((100, 200), np.int8)
    cells[:, 100] = 100
    cells[40:48, 100] = 0  # a gap of 0.4 m, around y = 2.2 m
    planner = fairway.Planner(fairway.Map.from_array(cells, resolution=0.05))
    start = (1, 2.2)
    plan = planner.plan(start, (9, 2.2))
    assert not plan.usable
    found = planner.find_obstruction(start, plan)
    assert found.kind == "narrow gap"
    assert np.hypot(*(np.array(found.position) - (5.025, 2.2))) < 0.1
    assert 0.3 < found.found <= 0.4 < found.needed
    assert f"{found.needed:.2f}" in planner.explain(start, plan)
    free = planner.plan(start, (2, 2.2))
    assert planner.find_obstruction(start, free) is None
    assert planner.explain(start, free) == ""


def test_a_navigator_explains_why_it_has_no_path():
    cells = np.zeros((100, 200), np.int8)
    cells[:, 100] = 100
    settings = fairway.Settings()
    settings.planning.background = True
    navigator = fairway.MapNavigator(settings, fairway.Map.from_array(cells, resolution=0.05))
    navigator.set_goal(9, 2.2)
    for cycle in range(4):
        step = navigator.update(0.1 * cycle, (1, 2.2, 0))
        navigator.wait_for_plan()
    assert step.status.label == "No path"
    assert "5.0" in navigator.explanation
