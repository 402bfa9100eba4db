"""Compiles the C++ blocks of the pages, or finds them in an example."""

import pathlib
import re
import subprocess
import tempfile


def normalised(text: str) -> list:
    return [line.strip() for line in text.splitlines() if line.strip()]


def is_excerpt(block, examples: list) -> bool:
    wanted = normalised(block.text)
    return any(example[i:i + len(wanted)] == wanted
               for example in examples for i in range(len(example) - len(wanted) + 1))


def wrapped(block, number: int, root: pathlib.Path) -> tuple:
    """@return the includes of a block, and the rest in a namespace of its own"""
    lines = block.text.splitlines()
    given = block.directives.get("with", "").splitlines()
    includes = [line for line in lines + given if line.startswith("#include")]
    body = "\n".join("" if line.startswith("#include") else line for line in lines)
    given = "\n".join(line for line in given if not line.startswith("#include"))
    place = f'#line {block.line} "{block.page.relative_to(root)}"\n'
    if re.search(r"^int main\(", block.text, re.MULTILINE):
        body = re.sub(r"^int main\(", "int main_(", body, flags=re.MULTILINE)
        return includes, f"namespace block_{number} {{\n{given}\n{place}{body}\n}}\n"
    return includes, f"void block_{number}() {{\n{given}\n{place}{body}\n}}\n"


def check_code(root: pathlib.Path, pages: list, compiler: list) -> tuple:
    """@return errors, and how many blocks were looked at"""
    examples = [normalised(p.read_text()) for p in sorted((root / "examples").glob("*.cpp"))]
    includes, bodies, looked_at = {'#include "fairway/fairway.hpp"': None}, [], 0
    for page in pages:
        for block in page.blocks:
            if block.language not in ("cpp", "c++") or "not compiled" in block.directives:
                continue
            looked_at += 1
            if is_excerpt(block, examples):
                continue
            more, body = wrapped(block, looked_at, root)
            includes.update(dict.fromkeys(more))
            bodies.append(body)
    if not bodies or not compiler:
        return [], looked_at
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "blocks.cpp"
        source.write_text("\n".join(includes) + "\n" + "\n".join(bodies))
        done = subprocess.run([*compiler, "-fsyntax-only", str(source)], capture_output=True,
                              text=True, check=False)
    if done.returncode == 0:
        return [], looked_at
    found = [line for line in done.stderr.splitlines() if "error:" in line]
    return found or [done.stderr.strip()], looked_at
