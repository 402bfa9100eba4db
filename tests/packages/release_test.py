#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests tools/release.py on a copy of the files that it changes."""

import hashlib
import importlib.util
import pathlib
import shutil
import subprocess
import tarfile
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SPEC = importlib.util.spec_from_file_location("release", ROOT / "tools" / "release.py")
release = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(release)


class ReleaseTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name) / "fairway"
        for name in [*release.PLACES, "tools/release.py", "packaging/debian/changelog"]:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.root / name)
        (self.root / "CHANGELOG.md").write_text("# Changelog\n\n## [Unreleased]\n\n### Added\n- A thing.\n")
        self.commit("first")

    def tearDown(self):
        self.folder.cleanup()

    def commit(self, message):
        git = ["git", "-c", "user.name=Test", "-c", "user.email=test@example.org", "-C", str(self.root)]
        if not (self.root / ".git").exists():
            subprocess.run([*git, "init", "-q"], check=True)
        subprocess.run([*git, "add", "-A"], check=True)
        subprocess.run([*git, "commit", "-qm", message], check=True)

    def run_script(self, *arguments):
        return subprocess.run([str(self.root / "tools" / "release.py"), *arguments], capture_output=True, text=True)

    def test_prepare_writes_the_version_everywhere(self):
        done = self.run_script("prepare", "7.8.9", "--date", "2030-02-01")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in release.PLACES:
            self.assertIn("7.8.9", (self.root / name).read_text(), name)
        changes = (self.root / "CHANGELOG.md").read_text()
        self.assertIn("## [Unreleased]\n\n## [7.8.9] - 2030-02-01\n\n### Added", changes)
        debian = (self.root / "packaging/debian/changelog").read_text()
        self.assertTrue(debian.startswith("fairway (7.8.9-1) "), debian)
        self.assertIn("Fri, 01 Feb 2030 12:00:00 +0000", debian)

    def test_an_older_version_is_refused_and_nothing_changes(self):
        before = (self.root / "CMakeLists.txt").read_text()
        for version in ["0.0.1", "1.2", "v1.2.3"]:
            done = self.run_script("prepare", version)
            self.assertEqual(done.returncode, 1, version)
            self.assertIn("expected a version", done.stderr)
        self.assertEqual(before, (self.root / "CMakeLists.txt").read_text())

    def test_the_same_commit_gives_the_same_archive(self):
        out = pathlib.Path(self.folder.name)
        archives = []
        for name in ["one", "two"]:
            done = self.run_script("build", "--out", str(out / name))
            self.assertEqual(done.returncode, 0, done.stderr)
            archives += list((out / name).glob("fairway-*.tar.gz"))
        self.assertEqual(archives[0].read_bytes(), archives[1].read_bytes())
        with tarfile.open(archives[0]) as archive:
            names = archive.getnames()
        self.assertIn(f"{archives[0].name[:-len('.tar.gz')]}/CMakeLists.txt", names)
        digest, name = (out / "one" / "SHA256SUMS").read_text().split()
        self.assertEqual(name, archives[0].name)
        self.assertEqual(digest, hashlib.sha256(archives[0].read_bytes()).hexdigest())

    def test_a_release_without_the_playground_is_refused(self):
        out = pathlib.Path(self.folder.name) / "out"
        done = self.run_script("build", "--out", str(out), "--build", self.folder.name)
        self.assertEqual(done.returncode, 1)
        self.assertIn("expected the playground", done.stderr)
        self.assertFalse(out.exists())

    def test_a_changed_work_tree_is_refused(self):
        (self.root / "CMakeLists.txt").write_text("changed")
        done = self.run_script("build", "--out", str(pathlib.Path(self.folder.name) / "out"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("without changes", done.stderr)


if __name__ == "__main__":
    unittest.main()
