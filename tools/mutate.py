#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Changes the constants and comparisons of the safety monitor, one at a time, and runs its tests.

    tools/mutate.py [--shard I/N] [--list] [SOURCE...]

Every change must turn a test of tests/unit/monitor red. Those that cannot are in EQUIVALENT, with
the reason. Exit code 1 if another change passes all tests, 2 for bad usage.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ["safety_monitor.cpp", "monitored_axis.cpp", "guarded_polygon.cpp", "monitor_settings.cpp"]
# What the tests need beside the monitor.
LIBRARY = ["base/error.cpp"]
FLAGS = ["-std=gnu++20", "-O1", f"-I{ROOT}/src", f"-I{ROOT}/tests"]
LIBRARIES = ["-lgtest", "-lgtest_main", "-lpthread"]
LONGEST_TEST = 120  # [s]; a change that loops is found, too

# Part of a line, the change, and why no test can see it.
EQUIVALENT = [
    ("erase_if(sent_", "< -> <=", "a command of exactly that age has been obeyed already"),
    ("* fastest * fastest", "0.5 -> 0.65", "looking at points further away only costs time"),
    ("i % 2 ==", "0 -> 1", "the four bases come in another order"),
    ("i / 2 ==", "0 -> 1", "the four bases come in another order"),
    ("constexpr double kDue", "1e-9 -> 1.3e-09", "both are far below a step"),
    ("constexpr double kRounding", "1e-9 -> 1.3e-09", "both are far below a step"),
    ("due(s) >=", "> -> >=", "a command that is due in exactly that rounding"),
    ("t >= last - kRounding", "> -> >=", "as above, at the end of the last command"),
    ("now_ <= end - kRounding", "< -> <=", "as above, at the end of the cycle"),
    ("t - now_ < kLongStop", "<= -> <", "as above, after a minute"),
    ("from * to >=", "> -> >=", "a change from or to zero is the same by both"),
    ("speed * wanted >=", "> -> >=", "a change from or to zero is the same by both"),
    ("std::abs(kept) <= std::abs(", "< -> <=", "nothing is lost where both are equal"),
    ("if (needed >", ">= -> >", "the speed is reached exactly then"),
    ("elapsed <", "<= -> <", "after 10 s the base has reached its command"),
]

OPPOSITES = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
             "std::min": "std::max", "std::max": "std::min"}
TOKEN = re.compile(r"(?P<number>(?<![\w.])\d+(\.\d+)?(e-?\d+)?(?![\w.]))"
                   r"|(?P<operator>(?<= )(<=|>=|==|!=|&&|\|\||<|>)(?= )|std::(min|max)(?=\())")


def changed_number(text: str) -> str:
    value = float(text)
    if re.fullmatch(r"\d+", text):
        return str(int(text) + 1)
    return repr(value * 1.3) if value else "0.1"


def code_of(line: str) -> str:
    """The line without its comment, and without code that cannot be changed alone."""
    code = re.sub(r'"[^"]*"', lambda m: " " * len(m.group()), line).split("//")[0]
    return "" if code.lstrip().startswith("#") else code


def mutants(source: str):
    """Line number, the change in words, and the changed text of the source."""
    lines = source.split("\n")
    for number, line in enumerate(lines):
        for match in TOKEN.finditer(code_of(line)):
            old = match.group()
            new = changed_number(old) if match.group("number") else OPPOSITES[old]
            changed = line[:match.start()] + new + line[match.end():]
            yield number + 1, f"{old} -> {new}", "\n".join(lines[:number] + [changed] + lines[number + 1:])


def compiled(compiler: str, source: pathlib.Path, target: pathlib.Path) -> bool:
    command = [compiler, *FLAGS, "-c", str(source), "-o", str(target)]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def is_red(folder: pathlib.Path, compiler: str, objects: list) -> bool:
    program = folder / "monitor_test"
    if subprocess.run([compiler, *map(str, objects), *LIBRARIES, "-o", str(program)],
                      capture_output=True, check=False).returncode != 0:
        return True
    try:
        return subprocess.run([str(program), "--gtest_fail_fast"], capture_output=True, check=False,
                              timeout=LONGEST_TEST).returncode != 0
    except subprocess.TimeoutExpired:
        return True


def is_equivalent(line: str, change: str) -> bool:
    return any(part in line and change == known for part, known, _ in EQUIVALENT)


def shard_of(text: str) -> tuple:
    match = re.fullmatch(r"(\d+)/(\d+)", text)
    if not match or not 1 <= int(match.group(1)) <= int(match.group(2)):
        raise argparse.ArgumentTypeError(f"expected I/N with 1 <= I <= N, found {text}")
    return int(match.group(1)), int(match.group(2))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shard", type=shard_of, default=(1, 1), help="part I of N of the changes")
    parser.add_argument("--list", action="store_true", help="print the changes and run nothing")
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("sources", nargs="*", default=SOURCES)
    options = parser.parse_args()
    eigen = subprocess.run(["pkg-config", "--cflags", "eigen3"], capture_output=True, text=True, check=True)
    FLAGS.extend(eigen.stdout.split())
    monitor = ROOT / "src/fairway/monitor"
    changes = [(name, *mutant) for name in options.sources for mutant in mutants((monitor / name).read_text())]
    index, count = options.shard
    changes = changes[index - 1::count]
    if options.list:
        for name, number, change, _ in changes:
            print(f"{name}:{number}: {change}")
        return 0
    survivors = 0
    with tempfile.TemporaryDirectory() as text:
        folder = pathlib.Path(text)
        objects = {}
        fixed = [*sorted((ROOT / "tests/unit/monitor").glob("*_test.cpp")), ROOT / "tests/support/runs/allocation_guard.cpp",
                 *(ROOT / "src/fairway" / name for name in LIBRARY), *(monitor / name for name in SOURCES)]
        for source in fixed:
            objects[source.name] = folder / f"{source.name}.o"
            if not compiled(options.compiler, source, objects[source.name]):
                print(f"{source}: expected a source that compiles", file=sys.stderr)
                return 2
        if is_red(folder, options.compiler, list(objects.values())):
            print("expected tests that pass before any change", file=sys.stderr)
            return 2
        for name, number, change, changed in changes:
            source = folder / name
            source.write_text(changed)
            mutant = {**objects, name: folder / "mutant.o"}
            red = not compiled(options.compiler, source, mutant[name]) or is_red(
                folder, options.compiler, list(mutant.values()))
            line = changed.split("\n")[number - 1]
            if not red and not is_equivalent(line, change):
                survivors += 1
                print(f"{name}:{number}: {change}: no test is red", flush=True)
    print(f"{len(changes)} changes, {survivors} of them without a red test")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
