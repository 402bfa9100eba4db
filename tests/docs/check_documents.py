#!/usr/bin/env python3
"""Checks that what the documents say can be done.

Every shell block that calls the tool runs, every C++ block compiles or is part of an example, every
link leads somewhere, every setting exists, every status is described, and no word that the
language rules exclude is used. HTML comments directly above a block change what is done with it:

    <!-- not run: REASON -->      the shell block is skipped (data that is absent, long work)
    <!-- exit code: N -->         the shell block ends with N instead of 0
    <!-- file: NAME -->           the block is written to a file, for later blocks of the page
    <!-- output -->               the block above prints these lines; `...` stands for anything
    <!-- with: DECLARATIONS -->   what a C++ block takes for given
    <!-- not compiled: REASON --> the C++ block is skipped
"""

import argparse
import pathlib
import shlex
import sys

import code_blocks
import commands
import names
import options
import pages
import schemas
import words


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tool", type=pathlib.Path, help="the built tool; without it nothing runs")
    parser.add_argument("--compiler", default="", help="command that compiles a file; else none is")
    parser.add_argument("--only", default="", help="links, words, statuses, guide, keys, settings, options, schemas, code or commands")
    given = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parents[2]
    tool = given.tool.resolve() if given.tool else None
    all_pages = pages.pages_of(root)
    counts = {}

    def code() -> list:
        errors, counts["C++ blocks"] = code_blocks.check_code(root, all_pages,
                                                              shlex.split(given.compiler))
        return errors

    def run() -> list:
        errors, counts["shell blocks"] = commands.check_commands(root, tool, all_pages)
        return errors

    checks = {"links": lambda: pages.check_links(root, all_pages),
              "words": lambda: words.check_words(root, all_pages),
              "statuses": lambda: names.check_statuses(root) + names.check_provoked(root),
              "keys": lambda: names.check_keys(root),
              "code": code}
    if tool:
        checks["settings"] = lambda: names.check_settings(root, tool, all_pages)
        checks["options"] = lambda: options.check_options(root, tool)
        checks["guide"] = lambda: names.check_guide(root, tool)
        checks["schemas"] = lambda: schemas.check_schemas(root, tool)
        checks["commands"] = run
    errors = []
    for name, check in checks.items():
        if not given.only or name in given.only.split(","):
            errors += check()
    for error in errors:
        print(error)
    counted = "".join(f", {count} {what}" for what, count in counts.items())
    print(f"{len(all_pages)} pages{counted}: {len(errors)} errors")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
