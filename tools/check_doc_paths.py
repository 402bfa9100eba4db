#!/usr/bin/env python3
"""Fails when docs/walkthrough.md names a source that does not exist."""

import pathlib
import re
import sys


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    text = (root / "docs" / "walkthrough.md").read_text()
    names = re.findall(r"`([a-z_0-9/]+\.[ch]pp)`", text)
    missing = [name for name in names if not (root / "src" / "fairway" / name).exists()]
    for name in missing:
        print(f"docs/walkthrough.md: expected a file of src/fairway, found {name}")
    print(f"{len(names)} paths checked, {len(missing)} missing")
    return 1 if missing or not names else 0


if __name__ == "__main__":
    sys.exit(main())
