# SPDX-License-Identifier: Apache-2.0
"""The type stubs match the module: classes, functions, attributes, names of arguments, settings."""

import ast
import importlib.util
import os
import pathlib
import re
import subprocess
import sys

import pytest

import fairway
from fairway import _fairway

PYTHON = pathlib.Path(__file__).resolve().parents[1]
ROOT = PYTHON.parent
# What every Python object or pybind11 enumeration has, and what only type checkers see.
USUAL = {"__init__", "__module__", "__doc__", "__new__", "__repr__", "__str__", "__setstate__",
         "__getstate__", "__slots__", "__ne__", "__hash__", "__pybind11_module_local", "__annotations__",
         "__dict__", "__weakref__", "__entries", "__members__", "__int__", "__index__", "__eq__",
         "__init_subclass__", "_settings"}


def stubs() -> dict:
    """Classes and functions of all stubs by name, with the members of their bases."""
    found = {}
    for path in sorted((PYTHON / "fairway").glob("*.pyi")):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                found[node.name] = node
    return found


STUBS = stubs()
PUBLIC = {name: value for name, value in vars(_fairway).items() if not name.startswith("_")}


def members_of(node: ast.ClassDef) -> dict:
    members = {}
    for base in node.bases:
        members.update(members_of(STUBS[base.id]))
    for item in node.body:
        if isinstance(item, ast.AnnAssign):
            members[item.target.id] = item
        elif isinstance(item, ast.FunctionDef):
            members.setdefault(item.name, item)
    return members


def arguments_of(node: ast.FunctionDef) -> list:
    """Names of the arguments but self; `*` precedes those that need a keyword."""
    names = [a.arg for a in node.args.args if a.arg != "self"]
    return names + (["*"] if node.args.kwonlyargs else []) + [a.arg for a in node.args.kwonlyargs]


def signature_of(function) -> list:
    """The same from the first line of the docstring, which pybind11 writes."""
    line = function.__doc__.splitlines()[0]
    inner = re.sub(r"\[[^\[\]]*\]", "", re.sub(r"\[[^\[\]]*\]", "", line))
    inner = inner[inner.index("(") + 1:inner.rindex(") -> ")]
    parts = re.findall(r"(?:^|, )(\*|\w+)(?=:|$|,)", inner)
    return [part for part in parts if part not in ("self", "arg0")]


def test_both_have_the_same_names():
    assert {n for n in STUBS if not n.startswith("_")} == set(PUBLIC)
    groups = {name for name in PUBLIC if name.endswith("Settings")} - {"Settings"}
    assert set(fairway.__all__) - {"__version__"} == set(PUBLIC) - groups


@pytest.mark.parametrize("name", [n for n, value in PUBLIC.items() if isinstance(value, type)])
def test_classes_have_the_same_members(name):
    members = members_of(STUBS[name])
    real = set(vars(PUBLIC[name])) - USUAL
    assert set(members) - USUAL == real
    for member, node in members.items():
        value = vars(PUBLIC[name]).get(member)
        if isinstance(node, ast.FunctionDef) and callable(getattr(value, "__func__", value)):
            function = getattr(value, "__func__", value)
            if "->" in (getattr(function, "__doc__", None) or "") and not member.startswith("__"):
                assert arguments_of(node) == signature_of(function), member


@pytest.mark.parametrize("name", [n for n, value in PUBLIC.items() if not isinstance(value, type)])
def test_functions_have_the_same_arguments(name):
    assert arguments_of(STUBS[name]) == signature_of(PUBLIC[name])


@pytest.mark.parametrize("name", [n for n, value in PUBLIC.items() if hasattr(value, "__init__")
                                  and isinstance(value, type) and not n.endswith("Settings")])
def test_constructors_have_the_same_arguments(name):
    node = members_of(STUBS[name]).get("__init__")
    real = PUBLIC[name].__init__.__doc__ or ""
    if node is None:
        assert "->" not in real
    else:
        assert arguments_of(node) == signature_of(PUBLIC[name].__init__)


def test_everything_is_documented():
    for name, value in PUBLIC.items():
        assert (value.__doc__ or "").strip(), name


@pytest.mark.parametrize("enumeration, header", [
    ("NavigationStatus", "navigation/navigation_status.hpp"),
    ("LimitingFactor", "navigation/navigation_status.hpp"),
    ("PathStatus", "path/path.hpp"),
    ("CorridorStatus", "corridor/corridor.hpp"),
    ("SolveStatus", "mpc/solution.hpp"),
])
def test_enumerations_are_those_of_the_headers(enumeration, header):
    text = (ROOT / "src/fairway" / header).read_text(encoding="utf-8")
    body = re.search(r"enum class " + enumeration + r" : \S+ \{(.*?)\};", text, re.DOTALL).group(1)
    names = re.findall(r"^\s*(\w+),?", re.sub(r"//.*", "", body), re.MULTILINE)
    names = ["None_" if name == "None" else name for name in names]  # a keyword of Python
    assert list(PUBLIC[enumeration].__members__) == names
    assert [v.text for v in PUBLIC[enumeration].__members__.values()] == re.findall(
        r'return "([^"]+)"', re.search(r"to_text\(" + enumeration + r" \w+\) noexcept \{(.*?)\n\}", text,
                                       re.DOTALL).group(1))[:len(names)]


def test_the_stub_of_the_settings_is_up_to_date():
    path = PYTHON / "tools/write_settings_stub.py"
    spec = importlib.util.spec_from_file_location("write_settings_stub", path)
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    written = (PYTHON / "fairway/settings.pyi").read_text(encoding="utf-8")
    assert written == script.stub(), "run python/tools/write_settings_stub.py"


def test_a_type_checker_accepts_stubs_and_examples():
    if importlib.util.find_spec("mypy") is None:
        if os.environ.get("FAIRWAY_CI"):
            pytest.fail("mypy is not installed; CI checks the types")
        pytest.skip("mypy is not installed")
    done = subprocess.run([sys.executable, "-m", "mypy", "--cache-dir=/dev/null"], cwd=ROOT, text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0, done.stdout


def test_every_class_and_member_has_a_docstring():
    missing = []
    for name, kind in vars(_fairway).items():
        if not isinstance(kind, type) or name.startswith("_"):
            continue
        if not (kind.__doc__ or "").strip():
            missing.append(name)
        for member, value in vars(kind).items():
            if member.startswith("_") or isinstance(value, kind):
                continue
            if isinstance(value, property):
                doc = value.__doc__
            elif callable(value):
                doc = re.sub(r"\A\w+\(.*\) -> .*\n", "", value.__doc__ or "")  # after the signature
            else:
                continue
            if len((doc or "").strip()) < 4 and member not in ("name", "value"):
                missing.append(f"{name}.{member}")
    assert missing == []
