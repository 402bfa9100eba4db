#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs Fairway with pip in the ways that need no finished build, and drives a robot with each.

    run_source_install.py [BUILD]

The source archive of the repository is unpacked outside of git, makes the same archive again, and is
installed with `pip install .` into a new virtual environment; then the repository with
`pip install -e .`. Nothing is downloaded. Each compiles the library, which takes minutes; with BUILD
both use that finished build instead.
"""

import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DRIVE = "test_drive.py"


def run(*command: object, cwd: pathlib.Path) -> str:
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    done = subprocess.run([str(part) for part in command], cwd=cwd, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def source_archive(root: pathlib.Path, out: pathlib.Path) -> pathlib.Path:
    """The archive that pip and `build` would make of these sources."""
    out.mkdir()
    code = (f"import sys; sys.path.insert(0, {str(root / 'python/packaging')!r});"
            f" import wheel_backend; wheel_backend.build_sdist({str(out)!r})")
    run(sys.executable, "-B", "-c", code, cwd=root)
    return next(out.glob("fairway-*.tar.gz"))


def names(archive: pathlib.Path) -> list:
    with tarfile.open(archive) as packed:
        return sorted(packed.getnames())


def drives(python: pathlib.Path, folder: pathlib.Path, expected: pathlib.Path) -> None:
    place = run(python, "-c", "import fairway; print(fairway.__file__)", cwd=folder).strip()
    if not place.startswith(f"{expected}/"):
        sys.exit(f"expected the package in {expected}, found {place}")
    print(f"{place}: {run(python, '-m', 'pytest', '-q', '-p', 'no:cacheprovider', ROOT / 'python/tests' / DRIVE, cwd=folder).splitlines()[-1]}")


def main() -> int:
    finished = [f"build-dir={pathlib.Path(build).resolve()}" for build in sys.argv[1:]]
    options = ["--no-index", "--no-deps", *(part for name in finished for part in ("--config-settings", name))]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        archive = source_archive(ROOT, folder / "first")
        with tarfile.open(archive) as packed:
            packed.extractall(folder / "unpacked")
        (unpacked,) = (folder / "unpacked").iterdir()
        again = source_archive(unpacked, folder / "second")
        if names(again) != names(archive):
            sys.exit(f"the unpacked sources make another archive: {set(names(again)) ^ set(names(archive))}")
        print(f"{archive.name}: {len(names(archive))} files, the same without git")
        for kind, source in (("plain", unpacked), ("editable", ROOT)):
            venv = folder / kind
            # NumPy and pytest are those of the system.
            run(sys.executable, "-m", "venv", "--system-site-packages", venv, cwd=folder)
            place = ["-e", source] if kind == "editable" else [source]
            run(venv / "bin/python", "-m", "pip", "install", *options, *place, cwd=folder)
            build = pathlib.Path(finished[0].removeprefix("build-dir=")) if finished else ROOT / "build/wheel"
            drives(venv / "bin/python", folder, build / "python" if kind == "editable" else venv)
    return 0


if __name__ == "__main__":
    sys.exit(main())
