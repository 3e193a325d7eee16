"""Where a line ends: in the function for it, in each module, and in what a program says while a folder is run."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

import rosy_sim
from rosy_sim.run.grading import grade_programs
from rosy_sim.text_lines import text_lines

_INSIDE = ["\x0b", "\x0c", "\x1c", "\x1d", "\x1e", "\x85", "\u2028", "\u2029"]
"""What ``str.splitlines`` takes for the end of a line, and a protocol or an editor does not."""


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("", []),
        ("a", ["a"]),
        ("a\n", ["a"]),
        ("a\r\nb\rc\n\nd", ["a", "b", "c", "", "d"]),
        *((f"a{sign}b\nc", [f"a{sign}b", "c"]) for sign in _INSIDE),
    ],
)
def test_lines_end_at_their_three_ends_only(text: str, lines: list[str]) -> None:
    assert text_lines(text) == lines


def test_no_module_splits_lines_in_another_way() -> None:
    package = Path(rosy_sim.__file__).parent
    assert [str(path) for path in package.rglob("*.py") if ".splitlines()" in path.read_text("utf-8")] == []


@pytest.mark.parametrize("sign", _INSIDE)
def test_a_result_with_such_a_sign_is_read_as_one_line(monkeypatch: pytest.MonkeyPatch, sign: str) -> None:
    result = json.dumps({"goals": [{"title": f"say{sign}hello", "state": "done"}], "time": 1.5}, ensure_ascii=False)
    # JSON escapes the control characters among them, but not the others.
    monkeypatch.setattr(
        subprocess, "run", lambda command, **_: subprocess.CompletedProcess(command, 0, result + "\n", "")
    )
    [grade] = grade_programs([Path("a.hs")], [])
    assert (grade.goals, grade.time) == ((1, 1), 1.5)
