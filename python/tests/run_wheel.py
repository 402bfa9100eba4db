#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel of a build, installs it offline into a new virtual environment, and drives a robot.

Usage: run_wheel.py BUILD. 77 means that the test is skipped, and says why.
"""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command: object, cwd: pathlib.Path = ROOT) -> None:
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    done = subprocess.run([str(part) for part in command], cwd=cwd, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")


def main() -> int:
    missing = [name for name in ("venv", "ensurepip", "pip", "numpy", "pytest")
               if importlib.util.find_spec(name) is None]
    if missing:
        print(f"skipped: {sys.executable} has no {' and no '.join(missing)}")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        # NumPy and pytest are those of the system: nothing is downloaded.
        run(sys.executable, "-m", "venv", "--system-site-packages", folder / "venv")
        python = folder / "venv/bin/python"
        run(python, "-m", "pip", "wheel", ROOT, "--no-index", "--no-deps", "--wheel-dir", folder,
            "--config-settings", f"build-dir={pathlib.Path(sys.argv[1]).resolve()}")
        wheels = list(folder.glob("fairway-*.whl"))
        if len(wheels) != 1:
            sys.exit(f"expected one wheel, found {wheels}")
        run(python, "-m", "pip", "install", "--no-index", wheels[0])
        place = "import fairway, sys; sys.exit(not fairway.__file__.startswith(sys.prefix))"
        run(python, "-c", place, cwd=folder)
        run(python, "-m", "pytest", "-q", "-p", "no:cacheprovider", ROOT / "python/tests/test_drive.py",
            cwd=folder)
        print(f"{wheels[0].name}, {wheels[0].stat().st_size / 1e6:.1f} MB: a robot drives")
    return 0


if __name__ == "__main__":
    sys.exit(main())
