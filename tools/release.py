#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prepares and builds a release.

    tools/release.py prepare 0.2.0          writes the version and its date into every file that has it
    tools/release.py build --out dist       makes the source archive, the packages and their checksums

Between the two: look at the changes, commit them, and tag the commit. `build` takes the version from
CMakeLists.txt, packs the files of the newest commit, and refuses a changed work tree.
"""

import argparse
import datetime
import email.utils
import gzip
import hashlib
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
# Files that hold the version, each with the pattern around it.
PLACES = {
    "CMakeLists.txt": r"(project\(fairway VERSION )[0-9.]+()",
    "ros/fairway_ros/package.xml": r"(<version>)[0-9.]+(</version>)",
    "ros/nav2_fairway_controller/package.xml": r"(<version>)[0-9.]+(</version>)",
    "ros/nav2_fairway_controller/CMakeLists.txt": r"(VERSION )[0-9.]+( LANGUAGES)",
    "packaging/vcpkg/vcpkg.json": r'("version": ")[0-9.]+(")',
    "packaging/conan/conanfile.py": r'(    version = ")[0-9.]+(")',
}


def fail(message: str) -> None:
    raise SystemExit(f"release: {message}")


def git(*arguments: str) -> str:
    return subprocess.run(["git", *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout


def version() -> str:
    return re.search(PLACES["CMakeLists.txt"].replace("[0-9.]+", "([0-9.]+)"),
                     (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(2)


def number(text: str) -> tuple:
    if not re.fullmatch(r"[0-9]+\.[0-9]+\.[0-9]+", text):
        fail(f"expected a version such as 1.2.3, found {text}")
    return tuple(map(int, text.split(".")))


def prepare(new: str, date: datetime.date) -> None:
    """Every file is checked before the first is written."""
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    released = f"## [{new}]" in changelog or re.search(rf"fairway \({re.escape(new)}-", (ROOT / "packaging/debian/changelog").read_text())
    first = "## [" not in changelog.replace("## [Unreleased]", "")
    if number(new) < number(version()) or (number(new) == number(version()) and not first):
        fail(f"expected a version above {version()}, found {new}")
    if "## [Unreleased]\n" not in changelog:
        fail("CHANGELOG.md: expected the heading [Unreleased]")
    texts = {}
    for name, pattern in PLACES.items():
        texts[name], count = re.subn(pattern, rf"\g<1>{new}\g<2>", (ROOT / name).read_text(encoding="utf-8"), count=1)
        if count != 1:
            fail(f"{name}: expected a version")
    texts["CHANGELOG.md"] = changelog.replace("## [Unreleased]\n", f"## [Unreleased]\n\n## [{new}] - {date}\n", 1)
    if not released:
        when = email.utils.format_datetime(datetime.datetime.combine(date, datetime.time(12), datetime.timezone.utc))
        texts["packaging/debian/changelog"] = (
            f"fairway ({new}-1) unstable; urgency=medium\n\n"
            f"  * Packages of version {new}; CHANGELOG.md of the sources has the changes.\n\n"
            f" -- The Fairway authors <fairway@users.noreply.github.com>  {when}\n\n"
            + (ROOT / "packaging/debian/changelog").read_text(encoding="utf-8"))
    for name, text in texts.items():
        (ROOT / name).write_text(text, encoding="utf-8")
    print(f"version {new} is in {len(texts)} files; commit them, then: git tag -a v{new} -m 'Fairway {new}'")


def source_archive(out: pathlib.Path) -> pathlib.Path:
    """Equal commits give equal bytes."""
    base = f"fairway-{version()}"
    tar = subprocess.run(["git", "archive", "--format=tar", f"--prefix={base}/", "HEAD"], cwd=ROOT, check=True, capture_output=True).stdout
    path = out / f"{base}.tar.gz"
    with path.open("wb") as file, gzip.GzipFile("", "wb", 9, file, mtime=0) as packed:
        packed.write(tar)
    return path


def build(out: pathlib.Path, folder: pathlib.Path | None) -> None:
    if git("status", "--porcelain", "--untracked-files=no"):
        fail("expected a work tree without changes; commit them first")
    playground = folder / "playground.html" if folder else None
    if playground and not playground.exists():
        fail(f"{playground}: expected the playground, which docs/playground.md promises; build the target `playground`")
    out.mkdir(parents=True, exist_ok=True)
    if any(out.iterdir()):
        fail(f"{out}: expected an empty folder")
    source_archive(out)
    if folder:
        subprocess.run(["cpack", "-G", "DEB", "-B", str(out)], cwd=folder, check=True)
        subprocess.run(["cmake", "-E", "rm", "-rf", str(out / "_CPack_Packages")], check=True)
        (out / f"fairway-playground-{version()}.html").write_bytes(playground.read_bytes())
        if (folder / "python" / "fairway").exists():
            sys.path.insert(0, str(ROOT / "python" / "packaging"))
            import wheel_backend
            wheel_backend.build_wheel(str(out), {"build-dir": str(folder)})
    files = sorted(file for file in out.iterdir() if file.is_file())
    sums = "".join(f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in files)
    (out / "SHA256SUMS").write_text(sums)
    print(sums, end="")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    steps = parser.add_subparsers(dest="step", required=True)
    prepared = steps.add_parser("prepare", help="write the version into every file that has it")
    prepared.add_argument("version")
    prepared.add_argument("--date", type=datetime.date.fromisoformat, default=None, help="default: today")
    built = steps.add_parser("build", help="make the files of the release")
    built.add_argument("--out", type=pathlib.Path, default=pathlib.Path("dist"))
    built.add_argument("--build", type=pathlib.Path, help="a finished build whose packages are added; without it only the sources")
    given = parser.parse_args()
    if given.step == "prepare":
        number(given.version)
        prepare(given.version, given.date or datetime.date.today())
    else:
        build(given.out.resolve(), given.build.resolve() if given.build else None)
    return 0


if __name__ == "__main__":
    sys.exit(main())
