"""Runs the shell blocks of the pages that call the tool, as a reader would."""

import concurrent.futures
import os
import pathlib
import re
import signal
import subprocess
import tempfile

CALLS_TOOL = re.compile(r"(?:^|[;&|(\s])(?:build/release/bin/)?fairway(?=\s)", re.MULTILINE)
LONGEST = 40  # [s], of one block


def calls_tool(block) -> bool:
    commands = re.sub(r"(^|\s)#[^\n]*", "", block.text)
    return block.language in ("sh", "bash") and bool(CALLS_TOOL.search(commands))


def folder_for(root: pathlib.Path, tool: pathlib.Path, folder: pathlib.Path) -> None:
    """What a reader has in the project's folder, without what the commands of a page could spoil."""
    for name in ("scenarios", "examples", "benchmarks", "tests", "tools"):
        (folder / name).symlink_to(root / name)
    (folder / "build/release/bin").mkdir(parents=True)
    (folder / "build/release/bin/fairway").symlink_to(tool)


def run_block(block, folder: pathlib.Path) -> tuple:
    """@return exit code, standard output, standard error"""
    environment = dict(os.environ, PATH=f"{folder}/build/release/bin:{os.environ['PATH']}")
    script = "set -eo pipefail\n" + block.text
    # A session of its own, so that what the block has started ends with it.
    with subprocess.Popen(["bash", "-c", script], cwd=folder, env=environment, text=True,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, start_new_session=True) as started:
        try:
            out, err = started.communicate(timeout=LONGEST)
        except subprocess.TimeoutExpired:
            os.killpg(started.pid, signal.SIGKILL)
            started.communicate()
            return None, "", f"not finished after {LONGEST} s"
    return started.returncode, out, err


def matches(expected: str, found: str) -> bool:
    """Whether the expected lines come in this order; `...` stands for anything."""
    lines = [line.rstrip() for line in found.splitlines()]
    for line in expected.splitlines():
        if line.strip() in ("", "..."):
            continue
        pattern = re.compile(".*?".join(map(re.escape, line.rstrip().split("..."))) + "$")
        while lines and not pattern.match(lines[0]):
            lines.pop(0)
        if not lines:
            return False
        lines.pop(0)
    return True


def check_page(root: pathlib.Path, tool: pathlib.Path, page) -> tuple:
    """@return errors, and how many blocks ran"""
    errors, ran, output = [], 0, None
    if not any(calls_tool(block) for block in page.blocks):
        return errors, ran
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        folder_for(root, tool, folder)
        for block in page.blocks:
            where = f"{page.path.relative_to(root)}:{block.line}"
            if "file" in block.directives:
                file = folder / block.directives["file"]
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(block.text)
            elif "output" in block.directives:
                if output is not None and not matches(block.text, output):
                    errors.append(f"{where}: expected the output of the block above, found\n{output}")
            elif calls_tool(block):
                output = None
                if "not run" in block.directives:
                    if not block.directives["not run"]:
                        errors.append(f"{where}: expected a reason after `not run:`, found none")
                    continue
                code, output, err = run_block(block, folder)
                ran += 1
                if code != int(block.directives.get("exit code", 0)):
                    errors.append(f"{where}: expected exit code "
                                  f"{block.directives.get('exit code', 0)}, found {code}: {err.strip()}")
                output += err
    return errors, ran


def check_commands(root: pathlib.Path, tool: pathlib.Path, pages: list) -> tuple:
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        answers = list(pool.map(lambda page: check_page(root, tool, page), pages))
    return [e for errors, _ in answers for e in errors], sum(ran for _, ran in answers)
