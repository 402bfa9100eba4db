# SPDX-License-Identifier: Apache-2.0
"""The solver alone."""

import os
import pathlib

import numpy as np
import pytest

import fairway


def straight_on(horizon: int = 20) -> fairway.Problem:
    problem = fairway.Problem(horizon=horizon, dt=0.1)
    problem.max_change = (0.2, 0.4)
    problem.targets = np.column_stack([0.1 * np.arange(1, horizon + 1), np.zeros(horizon),
                                       np.zeros(horizon)])
    problem.target_weights = (20, 20, 0.5)
    problem.set_corridor(fairway.Rectangle(min=(-1, -1), max=(6, 1.5)))
    return problem


def test_the_solution_follows_the_model_and_keeps_the_limits():
    problem = straight_on()
    solution = fairway.solve(problem)
    assert solution.status == fairway.SolveStatus.Solved
    assert solution.commands.shape == (20, 2) and solution.poses.shape == (21, 3)
    pose = problem.start
    changes = np.diff(np.vstack([[0, 0], solution.commands]), axis=0)
    assert np.all(np.abs(changes) <= np.array([0.2, 0.4]) + 1e-9)
    for command, expected in zip(solution.commands, solution.poses[1:]):
        pose = fairway.step(pose, command, 0.1)
        np.testing.assert_allclose(pose, expected, atol=1e-9)


def test_an_obstacle_is_kept_away_from():
    problem = straight_on()
    centers = np.column_stack([2.5 - 0.05 * np.arange(21), np.full(21, 0.2)])
    problem.add_obstacle(centers, 0.6)
    assert problem.num_obstacles == 1
    solution = fairway.solve(problem)
    assert solution.max_violation < 1e-6
    gaps = np.linalg.norm(solution.poses[:, :2] - centers, axis=1)
    assert gaps.min() > 0.6 - 1e-6


def test_a_guess_saves_iterations():
    problem, solver = straight_on(), fairway.Solver()
    cold = solver.solve(problem)
    problem.start = cold.poses[1]
    problem.previous_command = cold.commands[0]
    again = solver.solve(problem, cold.commands[1:])
    assert again.status == fairway.SolveStatus.Solved
    assert again.iterations <= cold.iterations


def test_tables_come_back():
    problem = straight_on(5)
    np.testing.assert_allclose(problem.targets[:, 0], [0.1, 0.2, 0.3, 0.4, 0.5])
    np.testing.assert_allclose(problem.target_weights, np.tile((20, 20, 0.5), (5, 1)))
    problem.command_weight = (0.3, 0.4)
    assert problem.command_weight == (0.3, 0.4)
    assert problem.integration == "midpoint"


@pytest.mark.parametrize("change, text", [
    (lambda p: setattr(p, "targets", np.zeros((4, 3))), "targets: expected an array of 5 x 3"),
    (lambda p: setattr(p, "integration", "rk4"), "integration: expected euler or midpoint, found"),
    (lambda p: p.set_region(6, []), "step: expected an integer from 1 to 5, found '6'"),
    (lambda p: p.set_region(1, [fairway.Rectangle()] * 3), "rectangles: expected at most two"),
    (lambda p: p.add_obstacle(np.zeros((5, 2)), 0.5), "positions: expected an array of 6 x 2"),
    (lambda p: [p.add_obstacle((0, 9), 0.5) for _ in range(17)], "obstacles: expected at most 16"),
    (lambda p: setattr(p, "start", (0, 0)), "pose: expected x, y, heading"),
    (lambda p: fairway.Problem(horizon=51), "horizon: expected an integer from 1 to 50, found '51'"),
])
def test_other_shapes_are_refused(change, text):
    with pytest.raises(ValueError, match=text):
        change(straight_on(5))


def test_a_problem_that_is_none_has_a_status():
    problem = straight_on()
    problem.start = (np.nan, 0, 0)
    solution = fairway.solve(problem)
    assert solution.status == fairway.SolveStatus.InvalidProblem
    assert not solution.commands.any()


def test_settings_give_a_problem():
    settings = fairway.Settings("paper")
    problem = fairway.Problem.from_settings(settings, (0.2, 0))
    assert problem.horizon == settings.mpc.horizon
    assert problem.command_max[0] == settings.robot.linear_max
    assert problem.previous_command == (0.2, 0)


def test_reads_shared_instances():
    file = pathlib.Path(os.environ.get("FAIRWAY_SHARED_DATA", "")) / "ocp" / "inst.txt"
    if not file.is_file():
        pytest.skip("the shared instances are not here")
    problems = fairway.read_problems(file)
    solver = fairway.Solver(fairway.Settings("paper"))
    statuses = [solver.solve(problem).status for problem in problems]
    assert statuses.count(fairway.SolveStatus.Solved) > 0.8 * len(statuses)
