# SPDX-License-Identifier: Apache-2.0
"""Maps from arrays and files."""

import pathlib

import numpy as np
import pytest

import fairway

ROOT = pathlib.Path(__file__).resolve().parents[2]
CELLS = np.array([[0, 100, -1], [0, 0, 100]])


@pytest.mark.parametrize("kind", [np.int8, np.int16, np.int64, np.float32, np.float64])
def test_an_array_of_any_type_comes_back(kind):
    grid = fairway.Map.from_array(CELLS.astype(kind), 0.5, (1, 2))
    assert grid.to_array().dtype == np.int8
    np.testing.assert_array_equal(grid.to_array(), CELLS)
    assert grid.shape == (2, 3)
    assert grid.resolution == 0.5
    assert grid.origin == (1, 2, 0)


def test_true_is_occupied():
    grid = fairway.Map.from_array(CELLS == 100, 0.5)
    np.testing.assert_array_equal(grid.to_array(), 100 * (CELLS == 100))


def test_lists_and_other_orders_of_memory_are_fine():
    for cells in (CELLS.tolist(), np.asfortranarray(CELLS), CELLS[::-1][::-1], CELLS.T.copy().T):
        np.testing.assert_array_equal(fairway.Map.from_array(cells, 1.0).to_array(), CELLS)


def test_row_zero_is_the_lowest():
    grid = fairway.Map.from_array(CELLS, 0.5, (1, 2))
    assert grid.center(0, 1) == (1.75, 2.25)
    assert grid.cell_at((1.75, 2.25)) == (0, 1)
    assert grid.cell_at((1.1, 2.9)) == (1, 0)


def test_an_origin_may_be_turned():
    grid = fairway.Map.from_array(CELLS, 1.0, (0, 0, np.pi / 2))
    np.testing.assert_allclose(grid.center(0, 1), (-0.5, 1.5))


@pytest.mark.parametrize("cells, text", [
    ([[0, 50]], r"cells\[0, 1\]: expected 0 \(free\), 100 \(occupied\) or -1 \(unknown\), found '50"),
    ([[0.5]], r"cells\[0, 0\]: expected 0"),
    ([[float("nan")]], r"cells\[0, 0\]: expected 0"),
    ([0, 0], "cells: expected an array of rows and columns"),
    ([], "cells: expected an array of rows and columns"),
    ([["a"]], "cells: expected an array of numbers"),
])
def test_other_cells_are_refused(cells, text):
    with pytest.raises(ValueError, match=text):
        fairway.Map.from_array(np.array(cells), 1.0)


@pytest.mark.parametrize("resolution, origin", [(0, (0, 0)), (-1, (0, 0)), (1, (np.inf, 0)), (1, (0,))])
def test_frames_that_are_none_are_refused(resolution, origin):
    with pytest.raises(ValueError, match="expected"):
        fairway.Map.from_array(CELLS, resolution, origin)


def test_reads_a_map_server_map():
    grid = fairway.Map.read(ROOT / "scenarios/maps/workshop.yaml")
    assert set(np.unique(grid.to_array())) <= {-1, 0, 100}
    assert grid.resolution > 0


def test_a_file_that_is_missing_or_wrong_is_named(tmp_path):
    with pytest.raises(ValueError, match="none.yaml"):
        fairway.Map.read(str(tmp_path / "none.yaml"))
    file = tmp_path / "map.yaml"
    file.write_text("image: map.pgm\nresolution: -1\n")
    with pytest.raises(ValueError, match=r"map.yaml:2: resolution: expected .*, found"):
        fairway.Map.read(file)
