#!/usr/bin/env python3
"""benchmarks/compare on builds whose times are known: small programs that print them."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMPARE = pathlib.Path(__file__).resolve().parents[2] / "benchmarks" / "compare"


def make_build(folder, times):
    """A build whose benchmark takes `times` [us], by name."""
    runs = [{"name": name, "cpu_time": time, "time_unit": "us"} for name, time in times.items()]
    program = folder / "bin" / "pipeline_benchmark"
    program.parent.mkdir(parents=True)
    program.write_text(f"#!/bin/sh\necho '{json.dumps({'benchmarks': runs})}'\n", encoding="ascii")
    program.chmod(0o755)
    return str(folder)


class CompareTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        root = pathlib.Path(self.folder.name)
        self.old = make_build(root / "old", {"path": 20.0, "map": 10.0, "gone": 1.0})
        self.new = make_build(root / "new", {"path": 10.0, "map": 11.0})
        self.history = root / "history"

    def run_compare(self, *arguments):
        return subprocess.run([sys.executable, "-B", COMPARE, *arguments], capture_output=True, text=True, check=False)

    def test_prints_ratios_of_the_stages_that_both_have(self):
        done = self.run_compare(self.old, self.new, "--rounds", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 3)
        self.assertIn("0.500", lines[1])
        self.assertTrue(lines[1].endswith("faster"))
        self.assertIn("1.100", lines[2])
        self.assertTrue(lines[2].endswith("slower"))

    def test_appends_to_the_history(self):
        for _ in range(2):
            self.run_compare(self.old, self.new, "--rounds", "2", "--history", str(self.history))
        results = [json.loads(line) for line in self.history.read_text(encoding="ascii").splitlines()]
        self.assertEqual(len(results), 2)
        self.assertAlmostEqual(results[1]["stages"][0]["ratio"], 0.5)

    def test_refuses_a_folder_without_benchmarks(self):
        done = self.run_compare(self.old, self.folder.name, "--rounds", "2")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("expected", done.stderr)


if __name__ == "__main__":
    unittest.main()
