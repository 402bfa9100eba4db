"""Names in the pages that must be those of the program: settings and statuses."""

import pathlib
import re
import subprocess

# Where the texts of the statuses are, and which functions give them.
STATUSES = {
    "src/fairway/navigation/navigation_status.hpp": ("NavigationStatus", "LimitingFactor"),
    "src/fairway/path/path.hpp": ("PathStatus",),
    "src/fairway/corridor/corridor.hpp": ("CorridorStatus",),
    "src/fairway/mpc/solution.hpp": ("SolveStatus", "ConstraintKind"),
}


def setting_names(tool: pathlib.Path) -> set:
    text = subprocess.run([tool, "settings"], capture_output=True, text=True, check=True).stdout
    names, group = set(), ""
    for line in text.splitlines():
        if found := re.match(r"^([a-z_]+):", line):
            group = found.group(1)
        elif found := re.match(r"^  ([a-z_]+):", line):
            names.add(f"{group}.{found.group(1)}")
    return names


def check_settings(root: pathlib.Path, tool: pathlib.Path, pages: list) -> list:
    names = setting_names(tool)
    groups = {name.split(".")[0] for name in names}
    renamed = root / "src/fairway/navigation/settings.hpp"
    old = set(re.findall(r"\"([a-z_]+\.[a-z_]+)\"", renamed.read_text()))
    # A task of `fairway bodies` has a robot as well, with keys of its own.
    tasks = root / "experiments/bodies/body_task_file.cpp"
    keys = re.findall(r"\.(?:number|text|points|has)\(\"(\w+)\"", tasks.read_text())
    names |= {f"robot.{key}" for key in keys}
    errors = []
    for page in pages:
        allowed = names | old if page.path.name == "CHANGELOG.md" else names
        for number, line in page.prose:
            for name in re.findall(r"`([a-z_]+\.[a-z_]+)(?:[:=][^`]*)?`", line):
                if name.split(".")[0] in groups and name not in allowed:
                    # A file such as `map.yaml` is no setting.
                    if name.endswith((".yaml", ".png", ".csv", ".mcap", ".html", ".json", ".launch")):
                        continue
                    errors.append(f"{page.path.relative_to(root)}:{number}: expected a setting, "
                                  f"found {name}")
    return errors


def status_texts(root: pathlib.Path) -> dict:
    texts = {}
    for file, enumerations in STATUSES.items():
        source = (root / file).read_text()
        for enumeration in enumerations:
            body = re.search(r"to_text\(" + enumeration + r" \w+\) noexcept \{(.*?)\n\}", source,
                             re.DOTALL)
            if not body:
                raise SystemExit(f"{file}: expected to_text({enumeration}), found none")
            texts[enumeration] = re.findall(r"case [^;]*?return \"([^\"]+)\"", body.group(1))
    return texts


def check_statuses(root: pathlib.Path) -> list:
    """Each status has a heading or a row of a table of its own."""
    path = root / "docs/statuses.md"
    lines = [line for line in path.read_text().splitlines() if line.startswith(("|", "#"))]
    described = {name for line in lines for name in re.findall(r"^(?:\| |#+ )`([^`]+)`", line)}
    errors, known = [], set()
    for enumeration, texts in status_texts(root).items():
        known.update(texts)
        errors += [f"docs/statuses.md: expected the {enumeration} `{text}`, found none"
                   for text in texts if text not in described]
    return errors + [f"docs/statuses.md: expected a status of the program, found `{text}`"
                     for text in sorted(described - known)]


def check_provoked(root: pathlib.Path) -> list:
    """Some test names each status and each limiting factor, and the C++ page lists them."""
    source = (root / "src/fairway/navigation/navigation_status.hpp").read_text()
    page = (root / "docs/cpp.md").read_text()
    tests = [path.read_text() for folder in ("tests/unit", "tests/closed_loop")
             for path in sorted((root / folder).rglob("*.cpp"))]
    errors = []
    for enumeration in STATUSES["src/fairway/navigation/navigation_status.hpp"]:
        for value in dict.fromkeys(re.findall(rf"case {enumeration}::(\w+)", source)):
            bare = rf"\b{enumeration}::{value}\b"
            used = rf"using enum {enumeration};(?s:.*)\b{value}\b"
            if not any(re.search(f"{bare}|{used}", text) for text in tests):
                errors.append(f"tests: expected a test that names {enumeration}::{value}, found none")
            if f"`{value}`" not in page:
                errors.append(f"docs/cpp.md: expected the enumerator `{value}`, found none")
    return errors


def cells_of(row: str) -> list:
    """The cells of a row of a table that say something, with links as their texts."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", row)
    return [cell.strip() for cell in text.split("|") if cell.strip()]


def check_guide(root: pathlib.Path, tool: pathlib.Path) -> list:
    """The tool and the page say the same about statuses."""
    page = [cells_of(line) for line in (root / "docs/statuses.md").read_text().splitlines()
            if line.startswith("|")]
    shown = subprocess.run([tool, "statuses", "--markdown"], capture_output=True, text=True,
                           check=True).stdout
    # `fairway statuses NAME` shows one row only.
    referring = [f"status_guide.cpp: expected a text of its own, found a reference to another row: {row}"
                 for row in shown.splitlines() if re.search(r"\b(As above|As for|See the limiting)\b", row)]
    return referring + [f"docs/statuses.md: expected the row of `fairway statuses --markdown`, found none: {row}"
                        for row in shown.splitlines() if row.startswith("| `") and cells_of(row) not in page]


def check_keys(root: pathlib.Path) -> list:
    """Every key that a reader of files asks for is on the page of the formats."""
    asked = re.compile(r"(?:text|choice|numbers?|boolean|integer|mappings?|rows|read_choice<\w+>)"
                       r"\(\s*(?:\w+,\s*)?\"(\w+)\"")
    page = (root / "docs/formats.md").read_text()
    errors = []
    for folder in ("scenario", "maps"):
        for source in sorted((root / "src/fairway/io" / folder).glob("*.cpp")):
            errors += [f"docs/formats.md: expected the key `{key}` of {source.name}, found none"
                       for key in dict.fromkeys(asked.findall(source.read_text()))
                       if not re.search(r"`(?:\w+: *)?" + key + r"\b", page)]
    return errors
