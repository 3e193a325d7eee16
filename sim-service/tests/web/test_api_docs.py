"""The page that explains every name of the language, as scripts/api_docs.py built it before the tests."""

from __future__ import annotations

import re
from pathlib import Path

from rosy_sim.config import discover

ROOT = Path(__file__).resolve().parents[3]


def exports() -> set[str]:
    """What Rosy's export list names, types without their constructors."""
    text = (ROOT / "rosy-hs/src/Rosy.hs").read_text()
    listed = text[text.index("module Rosy\n") : text.index("where\n")]
    return set(re.findall(r"^    (\w+)(?: \(\.\.\))?,$", listed, re.M))


def test_every_name_has_its_place() -> None:
    page = (discover().api_docs / "Rosy.html").read_text()
    anchors = set(re.findall(r'id="([tv]:[^"]+)"', page))
    names = exports()
    assert {"simulate", "Velocity", "Task", "randomR", "callOptions"} <= names
    assert {f"{'t' if name[0].isupper() else 'v'}:{name}" for name in names} - anchors == set()
    assert {"v:LeftBumper", "v:Pressed", "v:forever", "v:replicateM_", "v:when"} <= anchors


def test_nothing_is_fetched_from_elsewhere() -> None:
    for file in discover().api_docs.iterdir():
        if file.suffix in {".html", ".css"}:
            own = re.sub(r'src: url\("\w|<script src="\w[\w.-]*"></script>', "", file.read_text())
            assert not re.search(r"https?:|//cdn|src=", own), file.name
