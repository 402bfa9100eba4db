"""The page of the command line against the help of the tool."""

import pathlib
import re
import subprocess


def help_of(tool: pathlib.Path, *command: str) -> str:
    return subprocess.run([tool, *command, "--help"], capture_output=True, text=True,
                          check=True).stdout


def sections_of(page: str) -> dict:
    """The text under each heading of the second level; a heading may name several commands."""
    sections = {}
    for part in re.split(r"^## ", page, flags=re.MULTILINE)[1:]:
        heading, _, text = part.partition("\n")
        for name in heading.split(", "):
            sections[name.strip()] = text
    return sections


def check_options(root: pathlib.Path, tool: pathlib.Path) -> list:
    """Every command has a section, and every option is named in it or in the one for all."""
    file = "docs/command_line.md"
    sections = sections_of((root / file).read_text())
    errors = []
    listed = help_of(tool).partition("Subcommands:")[2].partition("\n\n")[0]
    for command in re.findall(r"^  ([a-z]+) ", listed, re.MULTILINE):
        if command not in sections:
            errors.append(f"{file}: expected a section '{command}', found none")
            continue
        known = sections[command] + sections.get("For all commands", "")
        for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", help_of(tool, command), re.MULTILINE):
            if option != "--help" and not re.search(re.escape(option) + r"\b", known):
                errors.append(f"{file}: {command}: expected the option {option}, found none")
    return errors
