#!/usr/bin/env python3
"""Drives tasks with the tool and judges the traces: run_bodies.py TOOL [FOLDER].

Without a folder, the tasks are those of benchmarks/cases/make_body_tasks.py. Exits with 77 where the folder is absent: skipped.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks/cases"))
import check_trace
import make_body_tasks as make_tasks


def main():
    tool = sys.argv[1]
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        if len(sys.argv) > 2:
            folder = pathlib.Path(sys.argv[2])
            if not folder.is_dir():
                print(f"skipped: {folder} is not here")
                return 77
        else:
            folder = scratch / "tasks"
            folder.mkdir()
            for name, task in make_tasks.TASKS.items():
                make_tasks.write(folder, name, task)
        traces, result = scratch / "traces", scratch / "result.json"
        done = subprocess.run([tool, "bodies", folder, "--trace-dir", traces, "--json", result], check=False)
        wrong = done.returncode
        claimed = {t["task"]: t for t in json.loads(result.read_text())["tasks"]}
        shares = []
        for task in sorted(folder.glob("*.json")):
            reasons, time, clearance, witness = check_trace.judge(task, traces / f"{task.stem}.csv")
            claim = claimed[task.stem]
            if abs(claim["time"] - time) > 1e-6 or not claim["success"]:
                reasons.append("the result says something else")
            # The tool looks at every moment, the checker at many: so the tool's clearance is no larger.
            if claim["min_clearance"] > clearance + 2e-4:
                reasons.append(f"the result says {claim['min_clearance']:.4f} m of clearance")
            shares += [time / witness] if witness else []
            wrong += 1 if reasons else 0
            print(f"{task.stem}: {time:.2f} s, {clearance:.4f} m: " + ("; ".join(reasons) or "sound"))
        if shares:
            median = sorted(shares)[len(shares) // 2]
            print(f"median share of the witness's time: {median:.2f}")
            wrong += 1 if median > 0.7 else 0
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
