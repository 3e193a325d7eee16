"""Nothing that a file, its name or a world says gives orders to a terminal."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from rosy_sim.sentences.terminal_text import escape_json, neutralize, neutralize_line

from .test_cli import environment, here, rosy

__all__ = ["environment", "here"]

ORDER = "\033]0;owned\007\033[2J\x9b31m\r\x7f"
"""Sets the title of a terminal, clears it, and colours what follows."""

CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")


def test_control_characters_become_a_sign() -> None:
    assert neutralize("a\033[2J\tb\n\x9bc\x7f\ud800") == "a\ufffd[2J\tb\n\ufffdc\ufffd\ufffd"
    assert neutralize_line("a\nb\tc") == "a\ufffdb c"


def test_json_means_the_same_without_control_characters() -> None:
    value = {"t\x9b": "\x7f\x80é\033"}
    text = escape_json(json.dumps(value, ensure_ascii=False))
    assert not CONTROL.search(text)
    assert json.loads(text) == value


@pytest.mark.parametrize("command", ["check", "run"])
@pytest.mark.parametrize("script", ["refuse", "done@2", "error@2"])
def test_the_name_of_a_file_gives_no_orders(
    command: str, script: str, environment: dict[str, str], tmp_path: Path
) -> None:
    program = tmp_path / f"p{ORDER}.hs"
    program.write_text(script)
    done = rosy(environment, command, program)
    assert done.stdout or done.stderr
    assert not CONTROL.search(done.stdout + done.stderr)


def test_a_file_that_is_not_there_gives_no_orders(environment: dict[str, str], tmp_path: Path) -> None:
    for words in (
        ["check", f"gone{ORDER}\n.hs"],
        ["run", f"gone{ORDER}.rosy"],
        ["run", "p.hs", "--world", f"gone{ORDER}"],
        ["run", "p.hs", f"--{ORDER}"],
    ):
        (tmp_path / "p.hs").write_text("done@1")
        done = rosy(environment, *words)
        [line] = done.stderr.rstrip("\n").split("\n")
        assert not CONTROL.search(line)


def test_a_world_gives_no_orders(environment: dict[str, str], tmp_path: Path) -> None:
    goal = {"kind": "reach", "x": 1, "y": 1, "r": 0.3, "title": f"Get there{ORDER}"}
    world = tmp_path / "w.json"
    world.write_text(json.dumps({"size": [4, 2], "start": {"x": 3, "y": 1}, "goals": [goal]}))
    for name in ("p", "q"):
        (tmp_path / f"{name}.hs").write_text("done@2")
    for files in (["p.hs"], ["p.hs", "q.hs"]):
        done = rosy(environment, "run", *files, "--world", world)
        assert "Get there" in done.stdout
        assert not CONTROL.search(done.stdout + done.stderr)
    world.write_text(
        json.dumps({"size": [4, 2], "start": {"x": 3, "y": 1}, f"color{ORDER}": 1, "goals": [{"kind": ORDER}]})
    )
    done = rosy(environment, "run", "p.hs", "--world", world)
    assert done.returncode == 1
    assert not CONTROL.search(done.stderr)
