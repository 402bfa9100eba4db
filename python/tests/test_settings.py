# SPDX-License-Identifier: Apache-2.0
"""Settings as validated attributes."""

import copy
import pickle
import re

import numpy as np
import pytest

import fairway


def names():
    """Every setting, as the settings file has them."""
    group = ""
    for line in fairway.Settings().yaml().splitlines():
        if found := re.match(r"([a-z_]+):$", line):
            group = found.group(1)
        elif found := re.match(r"  ([a-z_]+): ", line):
            yield group, found.group(1)


def test_every_setting_of_the_file_is_an_attribute_with_its_documentation():
    settings = fairway.Settings()
    all_names = list(names())
    assert len(all_names) > 60
    for group, name in all_names:
        value = getattr(getattr(settings, group), name)
        setattr(getattr(settings, group), name, value)
        assert "default" in getattr(type(getattr(settings, group)), name).__doc__
    assert settings == fairway.Settings()


def test_an_assignment_changes_the_settings():
    settings = fairway.Settings()
    settings.robot.radius = 0.3
    settings.mpc.horizon = np.int64(15)
    settings.robot.linear_max = np.float32(0.5)
    settings.corridor.method = "mdsrc"
    settings.planning.background = True
    assert settings.changed() == {"robot.radius": "0.3", "mpc.horizon": "15", "robot.linear_max": "0.5",
                                  "corridor.method": "mdsrc", "planning.background": "true"}


def test_discs_are_an_array():
    settings = fairway.Settings()
    settings.robot.discs = np.array([[0.2, 0, 0.25], [-0.2, 0, 0.25]])
    np.testing.assert_allclose(settings.robot.discs, [[0.2, 0, 0.25], [-0.2, 0, 0.25]])
    settings.robot.discs = []
    assert settings.robot.discs.shape == (0, 3)


@pytest.mark.parametrize("group, name, value, text", [
    ("robot", "radius", 20, "robot.radius: expected a number from 0.01 to 10, found '20'"),
    ("robot", "radius", float("nan"), "robot.radius: expected a number from 0.01 to 10, found 'nan'"),
    ("robot", "radius", "wide", "robot.radius: expected a number from 0.01 to 10, found 'wide'"),
    ("robot", "radius", None, "robot.radius: expected a number from 0.01 to 10, found 'None'"),
    ("robot", "radius", True, "robot.radius: expected a number from 0.01 to 10, found 'true'"),
    ("mpc", "horizon", 10.5, "mpc.horizon: expected an integer"),
    ("planning", "background", 1, "planning.background: expected true or false, found '1'"),
    ("corridor", "method", "none", "corridor.method: expected mdsrc or fewest, found 'none'"),
    ("robot", "discs", [[0, 0, -1]], "robot.discs: expected up to 8 of"),
])
def test_other_values_are_refused_with_the_text_of_the_tool(group, name, value, text):
    settings = fairway.Settings()
    with pytest.raises(ValueError, match="^" + re.escape(text)):
        setattr(getattr(settings, group), name, value)
    assert settings == fairway.Settings()


def test_an_unknown_name_is_refused():
    settings = fairway.Settings()
    with pytest.raises(AttributeError):
        settings.robot.radus = 0.3
    with pytest.raises(AttributeError):
        settings.robots = 0.3
    with pytest.raises(ValueError, match="expected one of radius, length"):
        settings.assign("robot.radus=0.3")


def test_groups_that_contradict_each_other_are_found():
    settings = fairway.Settings()
    settings.robot.linear_min = 0.5
    settings.robot.linear_max = 0.3
    with pytest.raises(ValueError, match="robot.linear_m"):
        settings.validate()


def test_files_and_presets(tmp_path):
    file = tmp_path / "robot.yaml"
    file.write_text("robot: {radius: 0.31}\n")
    assert fairway.Settings.read(file).robot.radius == 0.31
    file.write_text("robot:\n  radius: 31\n")
    with pytest.raises(ValueError, match=r"robot.yaml:2: robot.radius: expected .*, found"):
        fairway.Settings.read(file)
    paper = fairway.Settings("paper")
    assert paper.changed() and fairway.Settings.parse(paper.yaml()) == paper
    assert len(paper.yaml(essential=True)) < len(paper.yaml())
    with pytest.raises(ValueError, match="preset: expected default or paper"):
        fairway.Settings("best")


def test_copies_are_independent():
    settings = fairway.Settings("paper")
    for other in (settings.copy(), copy.copy(settings), copy.deepcopy(settings),
                  pickle.loads(pickle.dumps(settings))):
        assert other == settings
        other.robot.radius = 1.0
        assert other != settings


def test_a_group_keeps_its_settings_alive():
    group = fairway.Settings("paper").robot
    group.radius = 0.4
    assert group.radius == 0.4
