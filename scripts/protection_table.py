"""
Check that every test and attack that the table in rosy-hs/worker/PROTECTION.md names exists.

In: the document and the files it names. Out: one sentence for each name that is not found, and for each row without one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

__all__ = ["protection_breaches"]

DOCUMENT = Path("rosy-hs/worker/PROTECTION.md")
ATTACKS = Path("rosy-hs/test-worker/attacks")
HEADING = "## What is protected, from what, and how it is known"


def protection_breaches(root: Path) -> Iterator[str]:
    _, _, section = (root / DOCUMENT).read_text().partition(HEADING)
    rows = re.findall(r"^\| (.+?) \| (.+?) \| (.+) \|$", section.partition("\n## ")[0], re.M)[1:]
    if not rows:
        yield f"{DOCUMENT}: the table of assets is missing"
    for asset, _, shown in rows:
        names = 0
        for part in shown.split("; "):
            for place, name in _names(part):
                names += 1
                file = root / place
                if not file.is_file() or name not in file.read_text():
                    yield f"{DOCUMENT}: {asset}: there is no {name} in {place}"
        if names == 0:
            yield f"{DOCUMENT}: {asset}: no test is named"


def _names(part: str) -> Iterator[tuple[Path, str]]:
    """Files with the titles of tests in them; an attack is a file of its own."""
    quoted = re.findall(r"`([^`]+)`", part)
    if part.startswith("attacks "):
        yield from ((ATTACKS / f"{name}.hs", "") for name in quoted)
    else:
        yield from ((Path(quoted[0]), name) for name in quoted[1:])
