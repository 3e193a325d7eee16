"""What the language's tables say is tested, is: every test that they name stands in a suite."""

from __future__ import annotations

import re

from rosy_sim.config import discover

ROOT = discover().root
TABLES = ROOT / "rosy-hs" / "test" / "coverage.md"
GALLERY = ROOT / "rosy-hs" / "test-worker" / "gallery"


def suites() -> str:
    """The source of all suites, without commas: Python's tests are named with underscores."""
    haskell = [p for folder in ROOT.glob("rosy-hs/test*/Test") for p in folder.rglob("*.hs")]
    python = list((ROOT / "sim-service" / "tests").rglob("test_*.py"))
    texts = [p.read_text("utf-8") for p in haskell] + [p.read_text("utf-8").replace("_", " ") for p in python]
    return "\n".join(texts).replace(",", "")


def test_every_test_that_a_table_names_is_there() -> None:
    rows = [line for line in TABLES.read_text("utf-8").splitlines() if line.startswith("| ")]
    named = [name for row in rows for name in re.findall(r'"([^"]+)"', row.split(" | ", 1)[1])]
    all_of_them = suites()
    assert len(named) > 80
    assert [name for name in named if name.replace(",", "") not in all_of_them] == []


def test_every_mistake_that_a_table_names_is_in_the_gallery() -> None:
    rows = [line for line in TABLES.read_text("utf-8").splitlines() if "`Gallery`" in line and line.startswith("| ")]
    named = [name for row in rows for name in re.findall(r"`([a-z-]+)`", row)]
    assert named
    assert [name for name in named if not (GALLERY / name / "Main.hs").exists()] == []
