"""``./rosy run … --rooms N``: statuses, the table, JSON, the smallest room, bad options, and an interrupt."""

from __future__ import annotations

import json
import os
import re
import shlex
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import msgspec
import pytest

from rosy_sim.config import Limits
from rosy_sim.rooms.trial_process import Answer, Request, Task, Trial
from rosy_sim.sentences.wording import LANGUAGES
from rosy_sim.worker.background_process import WorkerSetup
from rosy_sim.worlds.gallery import load_world, usable_arena

from ..conftest import PATIENCE
from ..processes import await_end, below
from ..test_cli import Here, environment, here, one_sentence, rosy

__all__ = ["environment", "here"]

Environment = dict[str, str]


def told(environment: Environment, *arguments: object) -> tuple[int, dict[str, Any]]:
    done = rosy(environment, "run", *arguments, "--json")
    assert done.stderr == ""
    return done.returncode, json.loads(done.stdout)


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "p.hs"
    path.write_text("drive:0.5 bump")
    return path


def test_a_program_that_keeps_the_properties_passes(environment: Environment, tmp_path: Path) -> None:
    (tmp_path / "still.hs").write_text("done@20")
    done = rosy(environment, "run", "still.hs", "--rooms", 4, "--family", "pits", "--hold", "never-falls")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == "still.hs: 4 of 4 rooms passed.\n"
    assert not list(tmp_path.glob("*.json"))


@pytest.mark.parametrize("name", ["my walk.hs", "it's.hs", "a$(b).hs"])
def test_the_command_that_shows_a_failure_can_be_copied(environment: Environment, name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text("drive:0.5 bump")
    done = rosy(environment, "run", name, "--rooms", 1, "--hold", "never-pushes 0 s", "--seconds", 20)
    [command] = [line.split(": ", 1)[1] for line in done.stdout.splitlines() if line.startswith("See it: ")]
    words = shlex.split(command)
    assert words[:4] == ["./rosy", "run", name, "--world"]
    assert (tmp_path / words[4]).is_file()


@pytest.mark.parametrize("language", [*sorted(json.loads((LANGUAGES / "languages.json").read_text())), "en_XA"])
def test_the_table_of_failures_has_columns_in_every_language(
    environment: Environment, program: Path, language: str
) -> None:
    told = {**environment, "LC_ALL": f"{language}.UTF-8"}
    done = rosy(told, "run", program, "--rooms", 1, "--hold", "never-pushes 0 s", "--seconds", 20)
    head, row = done.stdout.splitlines()[:2]
    # The time is right-aligned in its column.
    assert row.index(" s ") + 2 == len(head)


def test_a_failure_gives_a_table_and_a_room_that_opens(environment: Environment, program: Path, tmp_path: Path) -> None:
    done = rosy(environment, "run", program, "--rooms", 4, "--hold", "never-pushes 0 s", "--seconds", 20)
    assert (done.returncode, done.stderr) == (3, "")
    lines = done.stdout.splitlines()
    assert lines[0].split() == ["room", "went", "time"]
    assert "pushed for 0.02 s until" in lines[1]
    assert "rooms passed." in done.stdout
    assert "no smaller one fails" in done.stdout
    assert re.search(r"^Rooms tried for it: \d+, in \d+\.\d s\.$", done.stdout, re.MULTILINE)
    # The command in the last line runs the program in the smallest room.
    usable_arena(load_world(str(tmp_path / "p-smallest-room.json")), "the room")
    again = rosy(environment, *lines[-1].removeprefix("See it: ./rosy ").split())
    assert again.returncode in (0, 3)


def test_the_answer_does_not_depend_on_the_number_of_processes(environment: Environment, program: Path) -> None:
    test = (program, "--rooms", 6, "--seconds", 15, "--seed", 3, "--hold", "reaches-goal", "never-pushes", 1, "s")
    one, three = (told(environment, *test, "--processes", count) for count in (1, 3))
    assert one == three
    status, report = one
    assert status == 3
    assert (report["family"], report["seed"], report["rooms"]) == ("obstacles", 3, 6)
    assert report["properties"] == ["reaches-goal", "never-pushes 1 s"]
    [tested] = report["programs"]
    assert len(tested["rooms"]) == 6
    assert tested["smallest"]["things"] <= tested["smallest"]["of"]
    passed = [room["passed"] for room in tested["rooms"]]
    # Worst first.
    assert passed == sorted(passed)
    assert tested["passed"] == sum(passed) < 6


@pytest.mark.parametrize(("script", "status"), [("refuse", 1), ("error@4", 2), ("close@4", 2)])
def test_the_exit_status_tells_what_is_wrong(
    script: str, status: int, environment: Environment, tmp_path: Path
) -> None:
    (tmp_path / "p.hs").write_text(script)
    done = rosy(environment, "run", "p.hs", "--rooms", 2, "--hold", "never-falls")
    assert (done.returncode, done.stderr) == (status, "")
    if script == "refuse":
        assert done.stdout == "p.hs:1:1: `move` gives a number. The robot needs a Velocity.\n"
    else:
        assert done.stdout.count("crashed") == 2
        assert "0 of its" in done.stdout


def test_a_folder_of_programs_is_tested_one_by_one(environment: Environment, tmp_path: Path) -> None:
    for name, script in {"ann": "done@1", "bob": "drive:0.5", "cem": "refuse"}.items():
        (tmp_path / "class" / name).mkdir(parents=True)
        (tmp_path / "class" / name / "p.hs").write_text(script)
    test = ("class", "--rooms", 2, "--family", "maze", "--hold", "never-pushes", 1, "--seconds", 15)
    status, report = told(environment, *test)
    assert status == 3
    assert [tested["passed"] for tested in report["programs"]] == [2, 0, 0]
    assert [len(tested["problems"]) for tested in report["programs"]] == [0, 0, 1]
    assert [path.name for path in tmp_path.glob("*.json")] == ["bob-p-smallest-room.json"]
    _, again = told(environment, *test, "--smallest", "rooms/of class")
    assert again["programs"][1]["smallest"]["file"] == "rooms/of class/bob-p-smallest-room.json"
    assert (tmp_path / "rooms/of class/bob-p-smallest-room.json").is_file()
    assert len(list(tmp_path.glob("*.json"))) == 1
    one_sentence(rosy(environment, "run", *test, "--smallest", "class/ann/p.hs"))


@pytest.mark.parametrize(
    "options",
    [
        ["--rooms", "0"], ["--rooms", "x"], ["--rooms", "100000"], ["--rooms", "2", "--family", "caves"],
        ["--rooms", "2", "--family", "like:atlantis"], ["--rooms", "2", "--hold", "flies"], ["--rooms", "2", "--hold"],
        ["--rooms", "2", "--hold", "covers", "0"], ["--rooms", "2", "--world", "room"],
        ["--rooms", "2", "--trace", "t"],
        ["--rooms", "2", "--csv"],
        ["--rooms", "2", "--speed", "1"], ["--rooms", "2", "--robot", "ws://x"], ["--rooms", "2", "--processes", "0"],
        ["--rooms", "2", "--seconds", "0"], ["--family", "maze"], ["--hold", "never-falls"], ["--json"],
        ["--smallest", "x"],
        ["--rooms", "2", "--family", "like:track", "--hold", "reaches-goal"],
    ],
)  # fmt: skip
def test_a_bad_option_gives_one_sentence(options: list[str], here: Here, program: Path) -> None:
    one_sentence(here("run", program, *options))


def test_an_interrupt_leaves_nothing_behind(environment: Environment, tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("drive:0.1 hang@100")
    command = [sys.executable, "-m", "rosy_sim", "run", "p.hs", "--rooms", "50", "--processes", "2"]
    with subprocess.Popen(
        command, env=environment, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, process_group=0
    ) as running:
        seen: set[int] = set()
        # A trial process, its worker, and the program that hangs.
        while len(seen) < 3 and running.poll() is None:
            seen |= below(running.pid)
        os.killpg(running.pid, signal.SIGINT)
        said, wrong = running.communicate(timeout=PATIENCE)
        assert (running.returncode, said) == (130, b"")
        # The scripted worker may complain about the end of its owner.
        assert b"KeyboardInterrupt" not in wrong
        assert b"rosy_sim/" not in wrong
    await_end(seen, PATIENCE)
    assert not list(tmp_path.glob("*.json"))


def test_a_trial_process_without_a_worker_says_so() -> None:
    setup = WorkerSetup(("/nowhere",), False, [], Limits())
    request = Request(Trial(1), Task("", "never-falls", 1.0, "maze", None, 1))
    lines = b"".join(msgspec.json.encode(message) + b"\n" for message in (setup, request))
    command = [sys.executable, "-m", "rosy_sim.rooms"]
    # Its input stays open until it has answered: the end of the input ends it at once.
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0) as running:
        assert running.stdin is not None
        assert running.stdout is not None
        running.stdin.write(lines)
        said = running.stdout.readline()
        assert running.wait(PATIENCE) != 0
    assert msgspec.json.decode(said, type=Answer).failure.startswith("The compiler part of Rosy is not built")
