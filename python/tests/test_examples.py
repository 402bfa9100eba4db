# SPDX-License-Identifier: Apache-2.0
"""Every example runs, has its twin in C++, and the notebook and the Python code of the pages run."""

import json
import pathlib
import re
import subprocess
import sys

import pytest

import fairway

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = sorted((ROOT / "python/examples").glob("*.py"))
PAGES = ["README.md", "docs/python.md"]


def run(code: str, folder: pathlib.Path) -> str:
    place = str(pathlib.Path(fairway.__file__).parents[1])
    start = f"import sys; sys.path.insert(0, {place!r})\n"
    done = subprocess.run([sys.executable, "-B", "-c", start + code], cwd=folder, text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_runs(path, tmp_path):
    code = path.read_text(encoding="utf-8")
    assert run(f"__file__ = {str(path)!r}\n" + code, tmp_path).strip()


def test_every_example_in_cpp_has_a_twin():
    twins = {path.stem for path in EXAMPLES}
    assert {path.stem for path in (ROOT / "examples").glob("*.cpp")} <= twins


@pytest.mark.parametrize("name", PAGES)
def test_the_python_code_of_a_page_runs(name, tmp_path):
    """The blocks of a page run one after the other in one program."""
    text = (ROOT / name).read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert blocks
    for folder in ("scenarios", "examples"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    run("\n".join(blocks), tmp_path)


def test_the_notebook_runs(tmp_path):
    pytest.importorskip("matplotlib")
    notebook = json.loads((ROOT / "python/examples/first_drive.ipynb").read_text(encoding="utf-8"))
    cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
    run("import matplotlib; matplotlib.use('Agg')\n" + "\n".join(cells), tmp_path)
