#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the Debian packages of a build and checks them: names, contents, dependencies, sizes.

lintian, where it is installed, must find no error.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

MOST_BYTES = 15_000_000  # of all packages together

# What each package has at least: files below /usr, and packages that it depends on.
EXPECTED = {
    "libfairway-dev": (["lib/libfairway.a", "lib/libfairway_simulation.a", "include/fairway/fairway.hpp",
                        "lib/cmake/fairway/fairway-config.cmake"], ["libeigen3-dev", "libexpected-dev"]),
    "libfairway-io-dev": (["lib/libfairway_io.a", "include/fairway/io/maps/map_file.hpp"],
                          ["libfairway-dev", "libyaml-cpp-dev", "libcairo2-dev"]),
    "libfairway-ipopt-dev": (["lib/libfairway_ipopt.a"], ["libfairway-dev", "coinor-libipopt-dev"]),
    "fairway": (["bin/fairway", "share/fairway/scenarios/workshop.yaml", "share/fairway/scenarios/maps/workshop.png",
                 "share/man/man1/fairway.1.gz", "share/doc/fairway/README.md", "share/doc/fairway/command_line.md",
                 "share/doc/fairway/images/plan.svg", "share/bash-completion/completions/fairway"],
                ["libc6", "libstdc++6", "libyaml-cpp0.7|libyaml-cpp0.8", "libzstd1"]),
    "python3-fairway": (["lib/python3/dist-packages/fairway/__init__.py", "lib/python3/dist-packages/fairway/py.typed"],
                        ["python3", "python3-numpy", "libc6"]),
    "fairway-ros": (["lib/fairway_ros/fairway_ros_node", "share/fairway_ros/package.xml",
                     "share/fairway_ros/launch/simulation.launch"], ["libroscpp4d|libroscpp3d", "libc6"]),
    "fairway-dds": (["bin/fairway_dds_node", "bin/fairway_dds_simulator", "bin/fairway_dds_goal"], ["libc6"]),
}
# Programs that a build may leave out, each with its package and its place there.
PROGRAMS = {"fairway_vda5050": ("fairway", "bin"), "fairway_vda5050_ros": ("fairway-ros", "bin"),
            "fairway_vda5050_dds": ("fairway-dds", "bin")}
ALWAYS = {"libfairway-dev", "libfairway-io-dev", "fairway"}


def output(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def problems_of(deb: pathlib.Path, version: str) -> list:
    name, found, depends = output("dpkg-deb", "-W", "--showformat=${Package}\t${Version}\t${Depends}", str(deb)).split("\t")
    if name not in EXPECTED:
        return [f"{deb.name}: expected a known package, found {name}"]
    problems = []
    if found != f"{version}-1":
        problems.append(f"{name}: expected version {version}-1, found {found}")
    files = {line.split(None, 5)[5].lstrip("./") for line in output("dpkg-deb", "-c", str(deb)).splitlines()}
    wanted, packages = EXPECTED[name]
    for file in [*wanted, f"share/doc/{name}/copyright", f"share/doc/{name}/changelog.Debian.gz"]:
        if f"usr/{file}" not in files:
            problems.append(f"{name}: expected /usr/{file}, found no such file")
    for program in sorted(pathlib.Path(file).name for file in files if re.fullmatch(r"usr/bin/.+", file)):
        if f"usr/share/bash-completion/completions/{program}" not in files:
            problems.append(f"{name}: expected a completion of {program}, found none")
    outside = sorted(file for file in files if file and not file.startswith("usr"))
    if outside:
        problems.append(f"{name}: expected files below /usr only, found {outside[0]}")
    if re.search(r"\([<>=]+ +[^0-9 ]", depends):
        problems.append(f"{name}: expected versions that begin with a digit, found {depends}")
    known = {re.split(r"[ (:]", one.strip())[0] for part in depends.split(",") for one in part.split("|")}
    for package in packages:
        if not known.intersection(package.split("|")):
            problems.append(f"{name}: expected a dependency on {package}, found {depends}")
    return problems


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True)
    parser.add_argument("--cpack", default="cpack")
    parser.add_argument("--version", required=True)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        made = subprocess.run([given.cpack, "-G", "DEB", "-B", folder], cwd=given.build, capture_output=True, text=True)
        if made.returncode != 0:
            print(made.stdout + made.stderr)
            return 1
        debs = sorted(pathlib.Path(folder).glob("*.deb"))
        for program, (package, place) in PROGRAMS.items():
            if (pathlib.Path(given.build) / "bin" / program).exists():
                EXPECTED[package][0].append(f"{place}/{program}")
        problems = [problem for deb in debs for problem in problems_of(deb, given.version)]
        names = {deb.name.split("_")[0] for deb in debs}
        problems += [f"expected the package {name}, found {sorted(names)}" for name in sorted(ALWAYS - names)]
        size = sum(deb.stat().st_size for deb in debs)
        if size > MOST_BYTES:
            problems.append(f"expected at most {MOST_BYTES} bytes, found {size}")
        if shutil.which("lintian") and debs:
            checked = subprocess.run(["lintian", "--allow-root", "--fail-on", "error", *map(str, debs)], capture_output=True, text=True)
            print(checked.stdout, end="")
            if checked.returncode != 0:
                problems.append("lintian: expected no error, found those above")
        print(*problems, sep="\n", end="\n" if problems else "")
        print(f"{len(debs)} packages, {size / 1e6:.1f} MB, {len(problems)} problems")
        return 1 if problems or not debs else 0


if __name__ == "__main__":
    sys.exit(main())
