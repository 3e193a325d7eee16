"""The same commit runs the same tests on each day: what the tools list does not change when the clock is set a week on."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from testing.names import listed_tests
from testing.suites import suites

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.skipif(shutil.which("faketime") is None, reason="faketime is not installed")
def test_a_week_later_the_same_tests_are_run(tmp_path: Path) -> None:
    known = suites(tmp_path)
    names = listed_tests(ROOT, known)
    assert len(names) > 5000
    assert listed_tests(ROOT, known, ["faketime", "-f", "+7d"]) == names
