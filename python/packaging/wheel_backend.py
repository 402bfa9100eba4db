# SPDX-License-Identifier: Apache-2.0
"""Builds the wheel and the source archive of Fairway for pip (PEP 517), with CMake.

It needs nothing but the standard library, so that pip downloads nothing for the build.

    pip install .
    pip install -e .                                         # uses the package in build/wheel
    pip wheel . --config-settings build-dir=build/release    # uses a build that exists
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPTIONS = ("APPS", "TESTS", "EXAMPLES", "ROS", "BENCHMARKS", "PHYSICS")


def version() -> str:
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(fairway VERSION ([0-9.]+)", text).group(1)


def tag() -> str:
    abi = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{abi}-{abi}-{platform}"


def metadata() -> str:
    return (f"Metadata-Version: 2.1\nName: fairway\nVersion: {version()}\n"
            "Summary: Safe corridors and model predictive control for wheeled robots\n"
            "License: Apache-2.0\nRequires-Python: >=3.9\nRequires-Dist: numpy\n"
            "Description-Content-Type: text/markdown\n\n"
            + (ROOT / "README.md").read_text(encoding="utf-8"))


def run(*command: str) -> None:
    """Runs a command; its output goes to standard error, which pip shows after a failure."""
    subprocess.run(command, check=True, stdout=sys.stderr)


def configure(build: pathlib.Path) -> None:
    off = [f"-DFAIRWAY_BUILD_{part}=OFF" for part in OPTIONS]
    run("cmake", "-S", str(ROOT), "-B", str(build), "-DCMAKE_BUILD_TYPE=Release",
        "-DFAIRWAY_UNITY_BUILD=ON", "-DFAIRWAY_BUILD_PYTHON=ON",
        f"-DPython3_EXECUTABLE={sys.executable}", *off)


def built(settings: dict) -> pathlib.Path:
    """Builds the package, unless settings name a finished build, and returns the build's folder."""
    given = settings.get("build-dir")
    build = pathlib.Path(given).resolve() if given else ROOT / "build" / "wheel"
    if not given:
        configure(build)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
        run("cmake", "--build", str(build), "--target", "fairway_python_package", "-j", jobs)
    return build


def installed(build: pathlib.Path, prefix: pathlib.Path) -> pathlib.Path:
    """Returns a copy of the package of a build."""
    run("cmake", "--install", str(build), "--component", "python", "--prefix", str(prefix), "--strip")
    for folder in prefix.rglob("fairway"):
        if list(folder.glob("_fairway*.so")):
            return folder
    raise SystemExit(f"{build}: expected the Python package, found none; is pybind11-dev installed?")


class Wheel:
    """A wheel while it is written: it records the checksum of each file."""

    def __init__(self, path: pathlib.Path):
        self.archive = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED)
        self.record = []

    def add(self, name: str, content: bytes) -> None:
        checksum = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        self.record.append(f"{name},sha256={checksum},{len(content)}")
        info = zipfile.ZipInfo(name)  # with a fixed date: the same files give the same wheel
        info.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
        info.compress_type = zipfile.ZIP_DEFLATED
        self.archive.writestr(info, content)

    def close(self, folder: str) -> None:
        self.add(f"{folder}/RECORD", "\n".join([*self.record, f"{folder}/RECORD,,", ""]).encode())
        self.archive.close()


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_editable(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"fairway-{version()}-{tag()}.whl"
    info = f"fairway-{version()}.dist-info"
    wheel = Wheel(pathlib.Path(wheel_directory) / name)
    with tempfile.TemporaryDirectory() as prefix:
        package = installed(built(config_settings or {}), pathlib.Path(prefix))
        for file in sorted(package.iterdir()):
            if file.is_file():
                wheel.add(f"fairway/{file.name}", file.read_bytes())
    describe(wheel, info)
    return name


def describe(wheel: Wheel, info: str) -> None:
    """Adds what pip reads of a wheel, and closes it."""
    wheel.add(f"{info}/METADATA", metadata().encode())
    wheel.add(f"{info}/WHEEL", ("Wheel-Version: 1.0\nGenerator: fairway\nRoot-Is-Purelib: false\n"
                                f"Tag: {tag()}\n").encode())
    wheel.add(f"{info}/LICENSE", (ROOT / "LICENSE").read_bytes())
    wheel.close(info)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that refers to the package in the build's folder: a build there updates it (PEP 660)."""
    name = f"fairway-{version()}-{tag()}.whl"
    package = built(config_settings or {}) / "python"
    if not list((package / "fairway").glob("_fairway*.so")):
        raise SystemExit(f"{package}: expected the Python package, found none; is pybind11-dev installed?")
    wheel = Wheel(pathlib.Path(wheel_directory) / name)
    wheel.add("fairway.pth", f"{package}\n".encode())
    describe(wheel, f"fairway-{version()}.dist-info")
    return name


def sources() -> list:
    """The files of the repository; those of an unpacked source archive, which has no git."""
    if (ROOT / ".git").exists():
        listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True)
        return sorted(name for name in listed.stdout.decode().split("\0") if name and (ROOT / name).is_file())
    made = {"build", "dist", "out", "node_modules", "__pycache__"}
    found = []
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in made]
        found += [str((pathlib.Path(folder) / name).relative_to(ROOT)) for name in files]
    return sorted(name for name in found if name != "PKG-INFO")


def build_sdist(sdist_directory, config_settings=None):
    base = f"fairway-{version()}"
    path = pathlib.Path(sdist_directory) / f"{base}.tar.gz"
    with tarfile.open(path, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for name in sources():
            archive.add(ROOT / name, f"{base}/{name}")
        with tempfile.NamedTemporaryFile() as file:
            file.write(metadata().encode())
            file.flush()
            archive.add(file.name, f"{base}/PKG-INFO")
    return path.name
