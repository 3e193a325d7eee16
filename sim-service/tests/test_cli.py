"""The command line as a person meets it: exit statuses, last lines, and one sentence for every mistake."""

from __future__ import annotations

import csv
import io
import json
import math
import os
import shutil
import signal
import socket
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import httpx
import pytest

from rosy_sim.cli import main
from rosy_sim.cli.parser import options_parser
from rosy_sim.config import Config
from rosy_sim.web.lan_addresses import is_unspecified, lan_addresses
from rosy_sim.worker import launcher
from rosy_sim.worker.launcher import missing_sandbox

from .conftest import FAKE_WORKER, PATIENCE
from .processes import await_end, children

ROOT = Path(__file__).resolve().parents[1]
CODEGEN = pytest.mark.skipif(
    shutil.which("node") is None or not (ROOT.parent / "codegen" / "dist" / "cli.js").exists(),
    reason="codegen's command line is not built",
)


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    """A project root with nothing but the fake worker and the protocol."""
    worker = tmp_path / "worker"
    worker.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{FAKE_WORKER}"\n')
    worker.chmod(0o755)
    # The robot descriptions.
    (tmp_path / "protocol").symlink_to(ROOT.parent / "protocol")
    (tmp_path / "codegen").symlink_to(ROOT.parent / "codegen")
    kept = {key: value for key, value in os.environ.items() if not key.startswith("ROSY_")}
    return {
        **kept,
        "PYTHONPATH": str(ROOT),
        "ROSY_ROOT": str(tmp_path),
        "ROSY_WORKER": str(worker),
        "ROSY_SANDBOX": "off",
        "NO_COLOR": "1",
        "LC_ALL": "C.UTF-8",
    }


WARNING = "rosy: programs run without their sandbox: the sandbox is turned off.\n"
"""What every command with a worker prints first in the ``environment`` of these tests."""


def rosy(environment: dict[str, str], *arguments: object) -> subprocess.CompletedProcess[str]:
    """A command in a process of its own; the warning above is removed."""
    done = subprocess.run(
        [sys.executable, "-m", "rosy_sim", *map(str, arguments)],
        env=environment, capture_output=True, text=True, timeout=PATIENCE, check=False, cwd=environment["ROSY_ROOT"],
    )  # fmt: skip
    done.stderr = done.stderr.removeprefix(WARNING)
    return done


Here = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture
def here(environment: dict[str, str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Here:
    """The same command without a process of its own, for the many that end before they begin."""
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.chdir(environment["ROSY_ROOT"])

    def run(*arguments: object) -> subprocess.CompletedProcess[str]:
        words = [str(argument) for argument in arguments]
        status = main(words)
        output = capsys.readouterr()
        return subprocess.CompletedProcess(words, status, output.out, output.err.removeprefix(WARNING))

    return run


def last(done: subprocess.CompletedProcess[str]) -> dict[str, object]:
    line: dict[str, object] = json.loads(done.stdout.splitlines()[-1])
    return line


def test_a_run_ends_with_its_json(environment: dict[str, str], tmp_path: Path) -> None:
    program = tmp_path / "p.hs"
    program.write_text("drive:0.5 say:hi@3")
    done = rosy(environment, "run", program, "--seconds", 2, "--seed", 1)
    assert (done.stderr, done.returncode) == ("", 0)
    assert done.stdout.splitlines()[0] == "hi"
    assert set(last(done)) == {"time", "pose", "ended", "steps", "wall"}
    assert (last(done)["time"], last(done)["ended"], last(done)["steps"]) == (2.0, "time", 100)


def test_a_program_cannot_give_orders_to_the_terminal(environment: dict[str, str], tmp_path: Path) -> None:
    program = tmp_path / "p.hs"
    program.write_text("say:\033[2Jhi\u009b31m@3 done@4")
    done = rosy(environment, "run", program)
    assert done.stdout.splitlines()[0] == "\ufffd[2Jhi\ufffd31m"


@pytest.mark.parametrize(
    ("script", "ended", "status"),
    [("done@9", "done", 0), ("error@4", "error", 2), ("hang@4", "stuck", 2), ("refuse", "error", 1)],
)
def test_the_exit_status_says_how_it_ended(
    script: str, ended: str, status: int, environment: dict[str, str], tmp_path: Path
) -> None:
    program = tmp_path / "p.hs"
    program.write_text(script)
    done = rosy(environment, "run", program)
    assert (done.returncode, last(done)["ended"]) == (status, ended)
    assert len(done.stderr.splitlines()) == (0 if status == 0 else 1)


def test_explain_prints_why_the_last_command_or_that_of_a_time_was_sent(
    environment: dict[str, str], tmp_path: Path
) -> None:
    (tmp_path / "p.hs").write_text("tell")
    done = rosy(environment, "run", tmp_path / "p.hs", "--seconds", 1, "--explain")
    assert done.stdout.splitlines()[:-1] == [
        "At 0.98 s f sent `Velocity 0.5 0.0` for `Seconds 49`.",
        "f ran at 0.98 s because it runs ten times a second.",
    ]
    done = rosy(environment, "run", tmp_path / "p.hs", "--seconds", 1, "--explain", "0.5")
    assert done.stdout.splitlines()[0] == "At 0.50 s f sent `Velocity 0.5 0.0` for `Seconds 25`."
    assert last(done)["time"] == 1.0


def test_explain_speaks_the_language_of_the_terminal(environment: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("tell")
    done = rosy({**environment, "LC_ALL": "de_DE.UTF-8"}, "run", tmp_path / "p.hs", "--seconds", 1, "--explain")
    assert done.stdout.splitlines()[:-1] == [
        "Bei 0,98 s sendete f `Velocity 0.5 0.0` für `Seconds 49`.",
        "f lief bei 0,98 s, denn sie läuft zehnmal in der Sekunde.",
    ]


def test_a_trace_has_the_provenance_of_firings_on_request(environment: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("tell")
    for options in ((), ("--provenance",)):
        done = rosy(environment, "run", tmp_path / "p.hs", "--seconds", 1, "--trace", tmp_path / "t.jsonl", *options)
        assert done.returncode == 0
        lines = [json.loads(line) for line in (tmp_path / "t.jsonl").read_text().splitlines()]
        told = [[firing["function"] for firing in line.get("firings", [])] for line in lines]
        assert told == [["f"] if options else []] * 50


def test_a_project_brings_its_world_and_inputs_their_hands(environment: dict[str, str], tmp_path: Path) -> None:
    project = tmp_path / "p.rosy"
    world = {"size": [3, 3], "start": {"x": 1, "y": 1}}
    project.write_text(json.dumps({"rosy": 1, "name": "p", "haskell": "drive:0.5", "world": world}))
    inputs = tmp_path / "i.jsonl"
    inputs.write_text(
        '{"t":0.5,"press":"Button0"}\n\n{"t":1,"teleport":{"x":2,"y":2,"theta":1.5}}\n{"t":1,"lift":"both"}\n'
    )
    trace = tmp_path / "t.jsonl"
    done = rosy(environment, "run", project, "--seconds", 2, "--input", inputs, "--trace", trace)
    assert last(done)["pose"] == {"x": 2.0, "y": 2.0, "theta": 1.5}
    assert len(trace.read_text().splitlines()) == 100


@pytest.mark.parametrize(("x", "status", "state"), [(2.0, 0, "done"), (9.0, 3, "missed")])
def test_a_goal_decides_the_exit_status(
    x: float, status: int, state: str, environment: dict[str, str], tmp_path: Path
) -> None:
    goal = {"kind": "reach", "x": x, "y": 1, "r": 0.3}
    world = tmp_path / "w.json"
    world.write_text(json.dumps({"size": [4, 2], "start": {"x": 1, "y": 1}, "goals": [goal]}))
    (tmp_path / "p.hs").write_text("drive:0.5")
    done = rosy(environment, "run", tmp_path / "p.hs", "--world", world, "--seconds", 5)
    assert done.returncode == status
    told = last(done)["goals"]
    assert isinstance(told, list)
    assert [goal["state"] for goal in told] == [state]


def test_a_folder_of_programs_gives_a_table(environment: dict[str, str], tmp_path: Path) -> None:
    world = tmp_path / "w.json"
    goal = {"kind": "reach", "x": 2, "y": 1, "r": 0.3, "title": "Get there"}
    world.write_text(json.dumps({"size": [4, 2], "start": {"x": 1, "y": 1}, "goals": [goal]}))
    folder = tmp_path / "class" / "more"
    folder.mkdir(parents=True)
    for name, script in {"ann": "drive:0.5", "bob": "", "cem": "refuse", "dan": "error@4"}.items():
        (folder / f"{name}.hs").write_text(script)
    done = rosy(environment, "run", tmp_path / "class", "--world", world, "--seconds", 5)
    assert done.returncode == 3
    lines = [line.split() for line in done.stdout.splitlines()]
    assert [tuple(line[:3]) for line in lines[1:-1]] == [
        ("ann.hs", "well", "1/1"), ("bob.hs", "goal", "missed"), ("cem.hs", "not", "compiled"),
        ("dan.hs", "failed", "0/1"),
    ]  # fmt: skip
    assert "Get there" in done.stdout
    assert done.stdout.endswith("1 of 4 went well.\n")
    (tmp_path / "none").mkdir()
    one_sentence(rosy(environment, "run", tmp_path / "none"))
    options = ("--world", world, "--seconds", 5, "--csv")
    done = rosy(environment, "run", tmp_path / "class", *options)
    assert (done.returncode, done.stderr) == (3, "")
    assert done.stdout.startswith("\ufeff")
    rows = list(csv.reader(io.StringIO(done.stdout.removeprefix("\ufeff"))))
    assert rows[0] == ["program", "went", "goals reached", "goals", "time", "remark"]
    assert [row[:4] for row in rows[1:]] == [
        ["ann.hs", "well", "1", "1"], ["bob.hs", "goal missed", "0", "1"], ["cem.hs", "not compiled", "0", "0"],
        ["dan.hs", "failed", "0", "1"],
    ]  # fmt: skip
    # One program is a table as well.
    done = rosy(environment, "run", folder / "bob.hs", *options)
    assert [row[0] for row in csv.reader(io.StringIO(done.stdout))][1:] == ["bob.hs"]


@pytest.mark.parametrize(
    ("reach", "language", "status", "row", "place"),
    [
        (1.5, "en", 0, "p.hs well 1/1 1.00 s", "The robot is at x = 1.5 m, y = 1 m and looks in direction 90°."),
        (3.5, "en", 3, "p.hs goal missed 0/1 1.00 s Get there", "The robot is at x = 1.5 m"),
        (1.5, "de", 0, "p.hs gut 1/1 1.00 s", "Der Roboter ist bei x = 1,5 m, y = 1 m und schaut in Richtung 90°."),
    ],
)
def test_a_person_at_a_terminal_reads_a_table_and_a_sentence_instead_of_json(
    reach: float,
    language: str,
    status: int,
    row: str,
    place: str,
    here: Here,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    (tmp_path / "p.hs").write_text("done@50")
    goal = {"kind": "reach", "x": reach, "y": 1, "r": 0.3, "title": "Get there"}
    start = {"x": 1.5, "y": 1, "theta": math.pi / 2}
    (tmp_path / "w.json").write_text(json.dumps({"size": [4, 2], "start": start, "goals": [goal]}))
    monkeypatch.setenv("LC_ALL", f"{language}.UTF-8")
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    done = here("run", tmp_path / "p.hs", "--world", tmp_path / "w.json")
    assert done.returncode == status
    _, told, last_line = (" ".join(line.split()) for line in done.stdout.splitlines())
    assert told == row
    assert last_line.startswith(place)


@pytest.mark.parametrize("at_terminal", [True, False])
def test_a_person_at_a_terminal_reads_that_the_robot_pushes_against_something(
    at_terminal: bool, here: Here, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "p.hs").write_text("drive:0.5")
    (tmp_path / "w.json").write_text(json.dumps({"size": [4, 2], "start": {"x": 3.5, "y": 1, "theta": 0}}))
    monkeypatch.setattr(sys.stdout, "isatty", lambda: at_terminal)
    done = here("run", tmp_path / "p.hs", "--world", tmp_path / "w.json", "--seconds", "10")
    notes = [line for line in done.stderr.splitlines() if "pushes against something" in line]
    assert len(notes) == int(at_terminal)


def test_check_prints_sentences_or_json(environment: dict[str, str], tmp_path: Path) -> None:
    program = tmp_path / "p.hs"
    program.write_text("refuse")
    done = rosy(environment, "check", program)
    assert done.returncode == 1
    assert done.stdout == f"{program}:1:1: `move` gives a number. The robot needs a Velocity.\n"
    done = rosy(environment, "check", program, "--json")
    assert (done.returncode, set(json.loads(done.stdout))) == (1, {"problems", "declarations", "graph"})
    program.write_text("drive:0.5")
    assert rosy(environment, "check", program).returncode == 0


_CONFLICT = """\
go :: Velocity
go = Velocity 0.2 0

back :: Bumper -> Velocity
back _ = Velocity (-0.2) 0

main = simulate %s
"""


@CODEGEN
def test_check_warns_about_functions_that_override_each_other(environment: dict[str, str], tmp_path: Path) -> None:
    folder = tmp_path / "programs"
    folder.mkdir()
    (folder / "a.hs").write_text(_CONFLICT % "(go, back)")
    (folder / "b.hs").write_text(_CONFLICT % "(priority 1 back go)")
    warning = f"{folder}/a.hs:1:1: warning: `back` and `go` both set the velocity, and `go` keeps winning. Say"
    for what, after in ((folder / "a.hs", []), (folder, [f"{folder}/b.hs: no problems."])):
        done = rosy(environment, "check", what)
        [first, *others] = done.stdout.splitlines()
        assert (done.returncode, others, done.stderr) == (0, after, "")
        assert first.startswith(warning)
    german = rosy({**environment, "LC_ALL": "de_DE.UTF-8"}, "check", folder / "a.hs").stdout
    assert "stellen beide die Geschwindigkeit ein" in german
    [problem] = json.loads(rosy(environment, "check", folder / "a.hs", "--json").stdout)["problems"]
    assert problem["fixes"][0]["edits"][0]["text"] == "(priority 1 back go)"


@CODEGEN
def test_check_says_when_it_cannot_look_for_conflicts(environment: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("drive:0.5")
    (tmp_path / "codegen").unlink()
    done = rosy(environment, "check", tmp_path / "p.hs")
    assert (done.returncode, done.stdout) == (0, f"{tmp_path}/p.hs: no problems.\n")
    assert done.stderr == (
        "rosy: Conflicts between functions were not looked for: "
        "the conversions between blocks and Haskell are not built.\n"
    )


BAD_FILES = {
    "missing.hs": None, "latin.hs": b"caf\xe9", "cut.rosy": '{"rosy":1,"haskell":"ma',
    "future.rosy": '{"rosy":2,"haskell":""}', "list.rosy": "[]", "empty.rosy": "", "no-program.rosy": '{"rosy":1}',
    "wordy.rosy": '{"rosy":"one","haskell":""}',
    "floorless.rosy": '{"rosy":1,"haskell":"","world":{"tiles":["##"],"start":{"x":0,"y":0}}}',

    "nowhere.rosy": '{"rosy":1,"haskell":"","world":"atlantis"}', "number.rosy": '{"rosy":1,"haskell":"","world":7}',
    "deep.rosy": "[" * 100_000, "long.hs": "x" * 200_001, "zero.rosy": b"\0\0\0",
}  # fmt: skip


@pytest.mark.parametrize("name", BAD_FILES)
@pytest.mark.parametrize("command", ["run", "check"])
def test_a_bad_file_gives_one_sentence(command: str, name: str, here: Here, tmp_path: Path) -> None:
    path, content = tmp_path / name, BAD_FILES[name]
    if content is not None:
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
    if command == "check" and '"world"' in str(content):
        return
    one_sentence(here(command, path))


def one_sentence(done: subprocess.CompletedProcess[str], status: int = 1) -> None:
    assert done.returncode == status, done.stderr
    assert done.stdout == ""
    [line] = done.stderr.splitlines()
    assert line.startswith("rosy: ")
    assert line.rstrip().endswith((".", "?"))
    assert "Traceback" not in line


@pytest.mark.parametrize(
    "options",
    [
        ["--world", "atlantis"], ["--world", "gone.json"], ["--seconds", "-1"], ["--seconds", "x"], ["--speed", "fast"],
        ["--speed", "0"], ["--seed", "x"], ["--input", "gone.jsonl"], ["--trace", "no/such/folder/t"], ["--fly"],
        ["--robot", "ws://127.0.0.1:9"], ["--robot", "http://x"], ["--robot", "ros"], ["--robot", "ws://x/?ros=3"],
        ["--robot", "ws://127.0.0.1:9", "--world", "room"], ["--robot", "ws://127.0.0.1:9", "--seed", "1"],
        ["--explain", "soon"], ["--explain", "-1"], ["--provenance"], ["--robot", "ws://127.0.0.1:9", "--explain"],
        ["--encoding", "morse"],
    ],
)  # fmt: skip
def test_a_bad_option_gives_one_sentence(options: list[str], here: Here, tmp_path: Path) -> None:
    program = tmp_path / "p.hs"
    program.write_text("drive:0.5")
    one_sentence(here("run", program, *options))


@pytest.mark.parametrize(
    "line", ["x", "{}", '{"t":-1,"press":"Button0"}', '{"t":1}', '{"t":1,"press":"Button7"}', '{"t":1,"fly":1}']
)
def test_a_bad_input_line_is_named(line: str, here: Here, tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("")
    (tmp_path / "i.jsonl").write_text('{"t":1,"press":"Button0"}\n' + line + "\n")
    done = here("run", tmp_path / "p.hs", "--input", tmp_path / "i.jsonl")
    one_sentence(done)
    assert "Line 2" in done.stderr


def test_every_program_of_a_folder_is_checked(environment: dict[str, str], tmp_path: Path) -> None:
    one_sentence(rosy(environment, "check", tmp_path))
    names = ["a b.hs", "empty.hs", "u\u0308.hs", "ü.hs", f"{'n' * 250}.hs", "sub/c.hs"]
    (tmp_path / "sub").mkdir()
    for name in names:
        (tmp_path / name).write_text("" if name == "empty.hs" else "drive:0.5")
    (tmp_path / "link.hs").symlink_to("a b.hs")
    done = rosy(environment, "check", tmp_path)
    assert (done.stderr, done.returncode) == ("", 0)
    assert sorted(done.stdout.splitlines()) == sorted(
        f"{tmp_path}/{name}: no problems." for name in [*names, "link.hs"]
    )
    (tmp_path / "big.hs").write_text("a" * 10_000_000)
    (tmp_path / "latin.hs").write_bytes(b"caf\xe9")
    (tmp_path / "wrong.hs").write_text("refuse")
    # Links that lead nowhere and to themselves.
    (tmp_path / "nowhere.hs").symlink_to("missing.hs")
    (tmp_path / "self.hs").symlink_to("self.hs")
    done = rosy(environment, "check", tmp_path)
    assert done.returncode == 1
    assert len(done.stdout.splitlines()) == len(names) + 2
    lines = done.stderr.splitlines()
    assert len(lines) == 4
    for line, name in zip(lines, ("big.hs", "latin.hs", "nowhere.hs", "self.hs"), strict=True):
        assert f"{tmp_path}/{name}" in line
    one_sentence(rosy(environment, "check", tmp_path, "--json"))


@pytest.mark.parametrize(
    "command",
    [
        ["check", "p.hs"], ["check", "."], ["run", "p.hs"], ["run", "."], ["build", "p.hs", "-o", "p"],
        ["run", "p.hs", "--rooms", 1, "--family", "pits", "--hold", "never-falls"],
    ],
)  # fmt: skip
def test_every_command_reads_programs_in_the_encoding_that_is_named(
    command: list[object], environment: dict[str, str], tmp_path: Path
) -> None:
    (tmp_path / "p.hs").write_bytes("refuse größer".encode("latin-1"))
    done = rosy(environment, *command)
    assert done.returncode == 1
    assert "see line 1, “refuse größer”. Save it as UTF-8 in your editor, or add --encoding Latin-1" in (
        done.stdout + done.stderr
    )
    done = rosy(environment, *command, "--encoding", "Latin-1")
    assert done.returncode == 1
    assert "`move` gives a number." in done.stdout + done.stderr


@pytest.mark.parametrize("command", ["run", "check"])
def test_a_name_that_is_too_long_gives_one_sentence(command: str, here: Here) -> None:
    one_sentence(here(command, "n" * 3000))


def test_no_command_gives_one_sentence(here: Here) -> None:
    one_sentence(here())
    one_sentence(here("dance"))


def test_a_worker_that_is_missing_or_dies_gives_one_sentence(environment: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("die")
    one_sentence(rosy(environment, "check", tmp_path / "p.hs"), 2)
    one_sentence(rosy({**environment, "ROSY_WORKER": "/nowhere"}, "check", tmp_path / "p.hs"), 2)


def test_a_port_in_use_gives_one_sentence(environment: dict[str, str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        one_sentence(rosy(environment, "serve", "--no-browser", "--port", port))
    one_sentence(rosy(environment, "serve", "--no-browser", "--port", 70000))
    one_sentence(rosy(environment, "serve", "--no-browser", "--host", "192.0.2.1"))


def test_without_a_sandbox_only_this_machine_is_served(environment: dict[str, str]) -> None:
    one_sentence(rosy(environment, "serve", "--no-browser", "--host", "0.0.0.0", "--port", 0))


@pytest.mark.usefixtures("here")
def test_every_command_with_a_worker_warns_once_when_the_sandbox_is_missing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "p.hs").write_text("done@1")
    (tmp_path / "q.hs").write_text("refuse")
    for words in (["check", "p.hs"], ["run", "p.hs"], ["run", "p.hs", "q.hs"]):
        main(words)
        output = capsys.readouterr()
        assert output.err == WARNING
    assert "move` gives a number" in output.out


def test_nothing_is_said_about_a_sandbox_that_is_there(config: Config, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(launcher, "sandbox_fault", lambda: None)
    assert missing_sandbox(replace(config, sandbox=True)) is None


@pytest.mark.parametrize("sent", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_ends_the_service_and_its_worker(sent: int, environment: dict[str, str]) -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "rosy_sim", "serve", "--no-browser", "--port", "0"],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    ) as service:  # fmt: skip
        assert service.stdout is not None
        address = service.stdout.readline().split(" at ")[1].split()[0]
        health = httpx.get(f"{address}api/health", timeout=PATIENCE).json()
        assert health["sessions"] == 0
        started = children(service.pid)
        assert started
        service.send_signal(sent)
        assert service.wait(PATIENCE) == 0
    await_end(started, PATIENCE)


def test_who_asks_twice_gets_no_traceback_of_the_service(environment: dict[str, str]) -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "rosy_sim", "serve", "--no-browser", "--port", "0"],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    ) as service:  # fmt: skip
        assert service.stdout is not None
        assert service.stderr is not None
        service.stdout.readline()
        service.send_signal(signal.SIGINT)
        service.send_signal(signal.SIGINT)
        # Two at one instant are one.
        assert service.wait(60) in (0, 130)
        assert "asyncio" not in service.stderr.read()


@pytest.mark.parametrize("command", ["start", "check", "run", "build", "room", "replay"])
def test_the_help_of_a_command_names_what_it_takes_and_nothing_else(command: str) -> None:
    text = (ROOT.parent / "languages" / "en" / "help" / f"{command}.txt").read_text()
    named = {line.split()[0] for line in text.splitlines() if line.startswith("  -")}
    commands = options_parser()._subparsers._group_actions[0].choices  # type: ignore[union-attr]
    parser = commands["serve" if command == "start" else command]  # type: ignore[index]
    taken = set(parser._option_string_actions)
    if command == "start":
        # Its cluster form is a parser of its own, whose options are explained below --cluster.
        taken |= {"--cluster"}
        node = commands["node"]._option_string_actions  # type: ignore[index]
        assert [option for option in node if option not in text] == []
    assert named == taken


def test_a_program_comes_from_standard_input(environment: dict[str, str]) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "rosy_sim", "check", "-"],
        env=environment, input="drive:0.5", capture_output=True, text=True, timeout=PATIENCE, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (0, "-: no problems.\n", WARNING)


def test_a_word_too_many_is_named(here: Here) -> None:
    done = here("check", "a.hs", "b.hs")
    assert done.returncode == 1
    assert done.stderr == "rosy: check does not take b.hs. ./rosy check --help says what there is.\n"


@pytest.mark.parametrize("host", ["0.0.0.0", "::"])
def test_everybody_is_everybody(host: str) -> None:
    assert is_unspecified(host)
    assert not is_unspecified("127.0.0.1")
    assert not is_unspecified("localhost")


def test_others_are_told_addresses_that_reach_this_machine() -> None:
    for address in lan_addresses():
        with socket.create_server((address, 0)) as listener:
            assert listener.getsockname()[0] == address
        assert not address.startswith("127.")
