# SPDX-License-Identifier: Apache-2.0
"""Builds the wheel and the source archive of Fairway for pip (PEP 517), with CMake.

It needs nothing but the standard library, so that pip downloads nothing for the build.

    pip install .
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


def installed(settings: dict, prefix: pathlib.Path) -> pathlib.Path:
    """Builds the package, unless settings name a finished build, and returns a copy of it."""
    given = settings.get("build-dir")
    build = pathlib.Path(given).resolve() if given else ROOT / "build" / "wheel"
    if not given:
        configure(build)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
        run("cmake", "--build", str(build), "--target", "fairway_python_package", "-j", jobs)
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


def get_requires_for_build_sdist(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"fairway-{version()}-{tag()}.whl"
    info = f"fairway-{version()}.dist-info"
    wheel = Wheel(pathlib.Path(wheel_directory) / name)
    with tempfile.TemporaryDirectory() as prefix:
        package = installed(config_settings or {}, pathlib.Path(prefix))
        for file in sorted(package.iterdir()):
            if file.is_file():
                wheel.add(f"fairway/{file.name}", file.read_bytes())
    wheel.add(f"{info}/METADATA", metadata().encode())
    wheel.add(f"{info}/WHEEL", ("Wheel-Version: 1.0\nGenerator: fairway\nRoot-Is-Purelib: false\n"
                                f"Tag: {tag()}\n").encode())
    wheel.add(f"{info}/LICENSE", (ROOT / "LICENSE").read_bytes())
    wheel.close(info)
    return name


def build_sdist(sdist_directory, config_settings=None):
    base = f"fairway-{version()}"
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True)
    path = pathlib.Path(sdist_directory) / f"{base}.tar.gz"
    with tarfile.open(path, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for name in files.stdout.decode().split("\0"):
            if name and (ROOT / name).is_file():
                archive.add(ROOT / name, f"{base}/{name}")
        with tempfile.NamedTemporaryFile() as file:
            file.write(metadata().encode())
            file.flush()
            archive.add(file.name, f"{base}/PKG-INFO")
    return path.name
