"""Markdown pages as the checks see them: headings, links and code blocks with their directives."""

import dataclasses
import pathlib
import re

FENCE = re.compile(r"^(\s*)(`{3,})(\S*)\s*$")
DIRECTIVE = re.compile(r"^<!--\s*(not run|not compiled|file|with|exit code|output)\s*(?::\s*(.*?))?\s*-->$",
                       re.DOTALL)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")


@dataclasses.dataclass
class Block:
    """A fenced block. `directives` come from the HTML comments directly above it."""

    page: pathlib.Path
    line: int
    language: str
    text: str
    directives: dict


@dataclasses.dataclass
class Page:
    path: pathlib.Path
    prose: list  # (line number, text) outside of fenced blocks
    blocks: list
    anchors: set


def slug(heading: str) -> str:
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip()).lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def read_page(path: pathlib.Path) -> Page:
    page = Page(path, [], [], set())
    fence, block, directives, comment = None, None, {}, ""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if not fence and (comment or line.startswith("<!--")):  # which may have several lines
            comment += line + "\n"
            if "-->" not in line:
                continue
            line, comment = comment.strip(), ""
        if fence:
            if line.strip() == fence:
                block.text = "\n".join(block.text) + "\n"
                page.blocks.append(block)
                fence = None
            else:
                block.text.append(line)
            continue
        start = FENCE.match(line)
        if start:
            fence = start.group(2)
            block = Block(path, number + 1, start.group(3), [], directives)
            directives = {}
            continue
        directive = DIRECTIVE.match(line.strip())
        if directive:
            directives[directive.group(1)] = directive.group(2) or ""
            continue
        if line.strip():
            directives = {}
        page.prose.append((number, line))
        heading = re.match(r"^#{1,6}\s+(.*?)\s*#*$", line)
        if heading:
            anchor, more = slug(heading.group(1)), 0
            while anchor in page.anchors:
                more += 1
                anchor = f"{slug(heading.group(1))}-{more}"
            page.anchors.add(anchor)
        page.anchors.update(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", line))
    if fence:
        raise SystemExit(f"{path}: expected an end of the last code block, found none")
    return page


def pages_of(root: pathlib.Path) -> list:
    """Every page that users read."""
    names = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "benchmarks/README.md"]
    paths = [root / name for name in names] + sorted((root / "docs").rglob("*.md"))
    return [read_page(path) for path in paths if path.exists()]


def check_links(root: pathlib.Path, pages: list) -> list:
    """Every relative link leads to a file, and every anchor to a heading."""
    errors = []
    known = {page.path.resolve(): page for page in pages}
    for page in pages:
        for number, line in page.prose:
            for target in LINK.findall(re.sub(r"`[^`]*`", "", line)):
                if re.match(r"^[a-z]+:", target):
                    continue
                name, _, anchor = target.partition("#")
                file = (page.path.parent / name).resolve() if name else page.path.resolve()
                where = f"{page.path.relative_to(root)}:{number}"
                if not file.exists():
                    errors.append(f"{where}: expected a link to a file, found {target}")
                elif anchor and file in known and anchor not in known[file].anchors:
                    errors.append(f"{where}: expected a link to a heading, found {target}")
    return errors


def cells_in(row: str) -> int:
    """How many cells a row of a table has; bars in code and escaped bars separate none."""
    return len(re.sub(r"`[^`]*`|\\\|", "x", row).strip().strip("|").split("|"))


def check_tables(root: pathlib.Path, pages: list) -> list:
    """Every row of a table has as many cells as its head."""
    errors = []
    for page in pages:
        head = 0
        for (_, before), (number, line) in zip(page.prose, page.prose[1:]):
            if re.match(r"^\|[-| :]+\|$", line):
                head = cells_in(before)
            elif not line.startswith("|"):
                head = 0
            if head and cells_in(line) != head:
                errors.append(f"{page.path.relative_to(root)}:{number}: expected {head} cells, "
                              f"found {cells_in(line)}")
    return errors
