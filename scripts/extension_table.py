"""
Check that rosy-hs/worker/EXTENSIONS.md lists exactly the language extensions that the worker enables and allows.

In: the document, ``defaultExtensions`` of the session and ``allowedExtensions`` of the allowlist. Out: one sentence per
difference.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

__all__ = ["extension_breaches"]

WORKER = Path("rosy-hs/worker")
DOCUMENT = WORKER / "EXTENSIONS.md"
SESSION = WORKER / "Rosy/Worker/Ghc/Session.hs"
ALLOWLIST = WORKER / "Rosy/Worker/Allowlist.hs"


def extension_breaches(root: Path) -> Iterator[str]:
    sections = (root / DOCUMENT).read_text().split("\n## ")
    for title, source, enabled in (
        ("On in every program", SESSION, _default_extensions((root / SESSION).read_text())),
        ("May be switched on", ALLOWLIST, _allowed_extensions((root / ALLOWLIST).read_text())),
    ):
        listed = _listed(next((text for text in sections if text.startswith(title)), ""))
        for name in sorted(enabled - listed):
            yield f"{DOCUMENT}: {name} of {source} is missing under “{title}”"
        for name in sorted(listed - enabled):
            yield f"{DOCUMENT}: {name} under “{title}” is not in {source}"
        if not enabled:
            yield f"{source}: no extensions were found; scripts/extension_table.py reads them"


def _listed(section: str) -> set[str]:
    """The names in the first column of a table whose rows have a reason in the second."""
    rows = re.findall(r"^\| ([A-Z]\w*(?:, \w+)*) \| \S[^|]*\|$", section, re.M)
    return {name for row in rows for name in row.split(", ")}


def _default_extensions(text: str) -> set[str]:
    found = re.search(r"^defaultExtensions =\n  \[(.*?)\]", text, re.M | re.S)
    # A name in lower case stands for an extension that compilers call differently (Rosy.Worker.Ghc.Compat).
    return {name[0].upper() + name[1:] for name in re.findall(r"\w+", found.group(1))} if found else set()


def _allowed_extensions(text: str) -> set[str]:
    found = re.search(r"^allowedExtensions =\n.*?\[(.*?)\]", text, re.M | re.S)
    return {name for line in re.findall(r'"([^"]*)"', found.group(1)) for name in line.split()} if found else set()
