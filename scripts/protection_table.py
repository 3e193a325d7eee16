"""
Check that every test and attack that the table in rosy-hs/worker/PROTECTION.md names exists, and that its table of
resources is that of the accounting. ``python3 scripts/protection_table.py`` writes the latter.

In: the document and the files it names. Out: one sentence for each name that is not found, for each row without one, and
for a table of resources that is not the generated one.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

__all__ = ["protection_breaches"]

ROOT = Path(__file__).resolve().parents[1]

DOCUMENT = Path("rosy-hs/worker/PROTECTION.md")
ATTACKS = Path("rosy-hs/test-worker/attacks")
HEADING = "## What is protected, from what, and how it is known"
RESOURCES = "## What one client may use"


def protection_breaches(root: Path) -> Iterator[str]:
    text = (root / DOCUMENT).read_text()
    if text != _with_resources(text):
        yield f"{DOCUMENT}: the table of resources is not that of the accounting; scripts/protection_table.py writes it"
    _, _, section = text.partition(HEADING)
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


def _with_resources(text: str) -> str:
    """The document with the generated table in place of the one below the heading."""
    before, heading, after = text.partition(f"{RESOURCES}\n")
    introduction, _, rest = after.partition("| Resource |")
    table = "| Resource | All clients | One client | Beyond that |\n|---|---|---|---|\n"
    table += "".join(f"| {row.name} | {row.total} | {row.each} | {row.beyond}. |\n" for row in _table())
    following = rest.partition("\n\n")[2]
    return f"{before}{heading}{introduction}{table}\n{following}"


@dataclass(frozen=True, slots=True)
class Resource:
    """A row of the table: what it is, what all clients and one client have of it, and what happens beyond that."""

    name: str
    total: str
    each: str
    beyond: str


def _table() -> tuple[Resource, ...]:
    sys.path.insert(0, str(ROOT / "sim-service"))
    from rosy_sim.accounting import resources as grants
    from rosy_sim.config import Limits

    limits = Limits()
    fair = "waits; the client with the fewest places, the least long work lately and the least use is next, and its pages take turns"

    return (
        Resource(
            "Places to run",
            f"{limits.runs} (`--runs`)",
            "all that are free",
            f"{fair}. A client without a place gets one: the longest idle program of the client with the most places is "
            f"stopped with a sentence, or a program that did nothing for {grants.IDLE:g} s",
        ),
        Resource(
            "Checks and completions",
            f"{grants.QUESTIONS.places} at once",
            f"{grants.QUESTIONS.page_places} for each page",
            f"{fair}. Clients with more than {grants.QUESTIONS.allowance:g} s of questions that took over {grants.QUESTIONS.long:g} s share all places but one."
            f" One that takes over {grants.QUESTIONS.long:g} s gives its place to a client without one, and is asked again",
        ),
        Resource(
            "Compiling for runs",
            f"{grants.COMPILING.places} at once",
            f"{grants.COMPILING.page_places} for each page",
            f"{fair}. One that takes over {grants.COMPILING.long:g} s gives its place to a client without one, and begins again",
        ),
        Resource(
            "Previews",
            "half of the cores, 2 at least",
            "all that are free",
            f"{fair}. One that takes over {grants.PREVIEW_LONG:g} s ends early for a client without a place",
        ),
        Resource(
            "Tests in rooms, rehearsals and checks of hand-ins",
            "half of the cores, 2 at least",
            "all that are free",
            f"{fair}. One that takes over {grants.BACKGROUND_LONG:g} s ends with a sentence for a client without a place",
        ),
        Resource("Pages", str(limits.sessions), f"{limits.address_sessions} of an address", "refused with a sentence"),
        Resource("Pages in a class", str(grants.CLASS_PAGES), f"{grants.CLASS_PAGES_EACH} of an address", "closed"),
        Resource(
            "Boards and projectors without the key",
            str(grants.LOCKED),
            f"{grants.LOCKED_EACH} of an address",
            f"the oldest of the address with most is closed, and each after {grants.LOCKED_SECONDS:g} s; a right key always enters",
        ),
        Resource("New pupils", "as many as the class has", f"{grants.JOINS_EACH} of an address", "refused with a sentence"),
        Resource(
            "Bytes of uploaded recordings",
            f"{grants.UPLOADS // 1_000_000} MB",
            f"{grants.CLIENT_UPLOADS // 1_000_000} MB",
            f"refused with a sentence; an upload ends after {grants.UPLOAD_SECONDS:g} s, and its file is removed with its page",
        ),
    )


def _names(part: str) -> Iterator[tuple[Path, str]]:
    """Files with the titles of tests in them; an attack is a file of its own."""
    quoted = re.findall(r"`([^`]+)`", part)
    if part.startswith("attacks "):
        yield from ((ATTACKS / f"{name}.hs", "") for name in quoted)
    else:
        yield from ((Path(quoted[0]), name) for name in quoted[1:])


if __name__ == "__main__":
    document = ROOT / DOCUMENT
    document.write_text(_with_resources(document.read_text()))
