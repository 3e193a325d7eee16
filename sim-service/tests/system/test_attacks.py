"""
Programs that mean harm, each from a page's Run to its end, with every layer of protection on and with each one off.

``rosy-hs/test-worker/attacks`` holds a program a file. In one column each is compiled before Run is pressed. In none of
the columns may one of them read the secret file, leave a file, hit another process, or outlive its run.
``UPDATE_GOLDENS=1`` writes the table of what became of each.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import re
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.config import Config, Limits, discover
from rosy_sim.web.service import Service
from rosy_sim.worker.launcher import uses_sandbox
from rosy_sim.worker.prepared_runs import PreparedRun, PreparedRuns

from ..conftest import PATIENCE as HANG
from ..processes import below
from ..web.page_client import Page, opened, serving

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

ATTACKS = Path(__file__).resolve().parents[3] / "rosy-hs" / "test-worker" / "attacks"

SECRET = "rosy-secret-4711"

RECORDS = bool(os.environ.get("UPDATE_GOLDENS"))
"""Whether the table is written."""

PATIENCE = 30.0 if RECORDS else 10.0
"""How long a program may do its worst where no limit of the service ends it, s."""

PREPARING = 10.0
"""How long a prepared child is waited for, s: one that takes too long to compile never waits."""

ALL = 4 * HANG
"""How long a program waits to be compiled, s: one whose work takes long comes after all others."""

COMPILING = 1
"""
Limit of a check and of a compilation, s of processor time: some thirty compile bombs use it up in each column, and no
other program comes near.
"""

LOOK = 0.05
"""Between two looks at all processes, s: each costs milliseconds of processor time."""

PAGES = 100
"""How many programs run at once: an address has a limited number of pages."""

STRICT = Limits(settle=1.0, ready=2.0, stop=0.5, gone=10.0, compile=60.0, worker_ready=120.0, runs=1000)

PATIENT = replace(STRICT, settle=4.0, ready=4.0)
"""For columns in which another limit shall have its chance before the service looks at the clock."""

ENDLESS = replace(STRICT, settle=1000.0, ready=1000.0)


@dataclass(frozen=True)
class Column:
    """One layer less, or none."""

    title: str
    off: tuple[str, ...] = ()
    sandbox: bool = True
    limits: Limits = STRICT
    # Whether the page checks the program first, and presses Run when a child waits that has compiled it.
    prepared: bool = False


COLUMNS = [
    Column("all layers"),
    Column("without language", ("--without", "language")),
    Column("without system calls", ("--without", "system-calls")),
    Column("without limits", ("--without", "limits")),
    Column("without sandbox", sandbox=False),
    Column("without service", limits=ENDLESS),
    Column("prepared", prepared=True),
]

SINGLE_LIMITS = [
    Column("without lists", ("--without", "lists")),
    Column("without memory limit", ("--without", "memory"), limits=PATIENT),
    Column("without process limit", ("--without", "processes")),
    Column("without file limit", ("--without", "files")),
    Column("without computing limit", ("--without", "computing"), limits=PATIENT),
    Column("without no-new-privileges", ("--without", "privileges")),
]
"""Parts of the layers, each off by itself; for the recorded table only, which takes twice as long with them."""


@dataclass(frozen=True)
class Target:
    """What the programs are aimed at: a secret to read, a file to make, a process to hit."""

    secret: Path
    file: Path
    victim: subprocess.Popen[bytes]

    def aim(self, source: str) -> str:
        for word, value in (("CANARY", self.secret), ("TARGET", self.file), ("VICTIM", self.victim.pid)):
            source = source.replace(word, str(value))
        return source

    def unharmed(self) -> bool:
        return self.victim.poll() is None and not self.file.exists() and self.secret.read_text() == SECRET


@contextmanager
def target() -> Iterator[Target]:
    with tempfile.TemporaryDirectory(prefix="rosy-attack-") as folder:
        secret = Path(folder, "secret")
        secret.write_text(SECRET)
        with subprocess.Popen([sys.executable, "-c", "import signal; signal.pause()"]) as victim:
            try:
                yield Target(secret, Path(folder, "target"), victim)
            finally:
                victim.kill()


def read_robot_configuration(column: Column) -> Config:
    config = discover().with_limits(column.limits)
    worker = (*config.worker, "--check-seconds", str(COMPILING), "--run-seconds", "2", *column.off)
    return replace(config, worker=worker, sandbox=column.sandbox)


class WatchedRuns(PreparedRuns):
    """Prepared runs that are prepared once, so that each child that waits can be told from the others."""

    def __init__(self, service: Service) -> None:
        super().__init__(service.worker, service.config.limits.prepared)
        self.asked: dict[str, asyncio.Event] = defaultdict(asyncio.Event)
        self.begun: dict[str, asyncio.Event] = defaultdict(asyncio.Event)
        # One program at a time is prepared.
        self.turn = asyncio.Lock()

    def prepare(self, page: object, source: str) -> None:
        if not self.begun[source].is_set():
            super().prepare(page, source)
            self.asked[source].set()

    def take(self, page: object, source: str) -> PreparedRun | None:
        self.begun[source].set()
        return super().take(page, source)


async def run_prepared(page: Page, source: str, runs: WatchedRuns) -> bool:
    """
    Press Run when a child has compiled the program and waits.

    Returns:
        False for a program that has a mistake or could not be compiled in time.
    """
    async with runs.turn:
        before = waiting_children()
        await page.send("check", id=1, source=source)
        checked = await page.op("checked")
        waits = False
        if not any(problem["severity"] == "error" for problem in checked["problems"]):
            async with asyncio.timeout(HANG):
                await runs.asked[source].wait()
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(PREPARING):
                    while not waiting_children() - before:
                        await asyncio.sleep(LOOK)
                    waits = True
        await page.send("run", run=1, source=source, speed=1, seed=1)
        async with asyncio.timeout(HANG):
            await runs.begun[source].wait()
        return waits


def waiting_children() -> set[int]:
    """Processes under the second filter: programs that wait or run. proc(5), Seccomp_filters."""
    found = set()
    for pid in below(os.getpid()):
        with contextlib.suppress(OSError):
            if "\nSeccomp_filters:\t2\n" in Path(f"/proc/{pid}/status").read_text():
                found.add(pid)
    return found


async def become(page: Page, name: str) -> str:
    """What becomes of the program of this name, which the page runs."""
    try:
        last = await page.until(started_or_ended, within=ALL)
    except TimeoutError:
        pytest.fail(f"{name} neither started nor ended: {[m for m in page.seen if m['op'] != 'frame']}")
    if last["state"] == "running":
        try:
            async with asyncio.timeout(PATIENCE):
                last = await page.until(driven_or_ended)
        except TimeoutError:
            return "endless"
    said = [m["text"] for m in page.seen if m["op"] == "said"]
    if "HARM" in said or any(SECRET in str(message) for message in page.seen):
        return "HARM"
    if last["op"] == "frame" or last["ended"] == "done":
        return "denied" if {"no", "-1"} & set(said) else "ran"
    return "refused" if last["ended"] == "refused" else str(last["problems"][0]["kind"])


def started_or_ended(message: dict[str, Any]) -> bool:
    return message["op"] == "state" and message["state"] in ("running", "ended")


def driven_or_ended(message: dict[str, Any]) -> bool:
    return started_or_ended(message) or (message["op"] == "frame" and message["step"] > 3)


async def attack(column: Column, programs: dict[str, str], aimed: Target) -> dict[str, str]:
    at_once = asyncio.Semaphore(PAGES)

    prepared: set[str] = set()

    async def one(address: str, name: str) -> str:
        async with at_once, opened(address) as page:
            source = aimed.aim(programs[name])
            if runs is None:
                await page.send("run", run=1, source=source, speed=1, seed=1)
            elif await run_prepared(page, source, runs):
                prepared.add(name)
            return await become(page, name)

    config = read_robot_configuration(column)
    async with serving(config) as (address, service), opened(address) as bystander:
        runs = WatchedRuns(service) if column.prepared else None
        if runs is not None:
            service.prepared_runs = runs
        await bystander.op("worker", state="ready")
        before = below(os.getpid())
        outcomes: dict[str, str] = {}
        # Those that fill memory by themselves: they need the processor for it.
        for hungry in (True, False):
            names = [name for name in programs if name.startswith("memory") == hungry]
            outcomes |= zip(names, await asyncio.gather(*(one(address, name) for name in names)), strict=True)
        if runs is not None:
            # The others have a mistake or take too long to compile, on a slow machine more of them.
            compiled = [name for name, outcome in outcomes.items() if outcome != "refused"]
            assert len(prepared) * 2 >= len(compiled), f"prepared: {sorted(prepared)}"
        # Nothing is left, and no other page noticed.
        async with asyncio.timeout(HANG):
            while service.budgets.runs.running or not children(before):
                await asyncio.sleep(LOOK)
        await bystander.send("check", id=1, source="main = pure ()\n")
        assert (await bystander.op("checked"))["problems"] == []
    return outcomes


def children(before: set[int]) -> bool:
    """Whether all that was started since has ended; the worker keeps some processes of its own."""
    return len(below(os.getpid())) <= len(before) + 6


def repeated_lines(program: str) -> str:
    """A program with the lines for which a line ``FROM 0 TO 9:…`` stands; ``NUMBER`` is the number of each."""

    def lines(found: re.Match[str]) -> str:
        return "".join(f"{found[3]}\n".replace("NUMBER", str(n)) for n in range(int(found[1]), int(found[2]) + 1))

    return re.sub(r"^FROM (\d+) TO (\d+):(.*)\n", lines, program, flags=re.MULTILINE)


def test_programs_of_many_lines_are_made() -> None:
    assert repeated_lines("a\nFROM 8 TO 10:  fNUMBER = NUMBER\nb\n") == "a\n  f8 = 8\n  f9 = 9\n  f10 = 10\nb\n"
    made = {path.stem: repeated_lines(path.read_text("utf-8")) for path in ATTACKS.glob("*.hs")}
    assert sum(program.count("\n") > 1500 for program in made.values()) == 5
    assert not any("NUMBER" in program for program in made.values())


def test_the_table_names_each_program_once() -> None:
    rows = re.findall(r"^\| ([a-z][^|]*) \| \w", (ATTACKS / "README.md").read_text("utf-8"), re.MULTILINE)
    named = [name for row in rows if row != "programs" for name in row.split(", ")]
    assert sorted(named) == sorted(path.stem for path in ATTACKS.glob("*.hs"))


def harmless(column: Column) -> dict[str, str]:
    """What became of each program in this column; fails if one did harm or left a process."""
    programs = {path.stem: repeated_lines(path.read_text("utf-8")) for path in sorted(ATTACKS.glob("*.hs"))}
    assert len(programs) >= 250
    left = below(os.getpid())
    if column.sandbox and not uses_sandbox(read_robot_configuration(column)):
        pytest.skip("this machine cannot build the sandbox")
    with target() as aimed:
        outcomes = asyncio.run(attack(column, programs, aimed))
        assert aimed.unharmed(), f"{column.title}: one hit a process or changed a file"
    with contextlib.suppress(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)
    assert below(os.getpid()) <= left
    assert {name: outcome for name, outcome in outcomes.items() if outcome == "HARM"} == {}
    return outcomes


if RECORDS:

    def test_the_table_of_what_became_of_each_is_written() -> None:
        columns = [*COLUMNS, *SINGLE_LIMITS]
        table: dict[str, list[str]] = {path.stem: [] for path in sorted(ATTACKS.glob("*.hs"))}
        for column in columns:
            outcomes = harmless(column)
            for name, row in table.items():
                row.append(outcomes[name])
        (ATTACKS / "README.md").write_text(show(table, columns), "utf-8")

else:

    @pytest.mark.long
    @pytest.mark.parametrize("column", COLUMNS, ids=[column.title for column in COLUMNS])
    def test_no_program_does_harm_whichever_layer_is_missing(column: Column) -> None:
        outcomes = harmless(column)
        for name, outcome in outcomes.items():
            print(f"{name}: {outcome}")


HEADING = """# Programs that mean harm

**In:** a program a file; `CANARY` stands for a secret file, `TARGET` for a file to make, `VICTIM` for a process to hit.
A line `FROM 0 TO 9:…` stands for ten lines, in which `NUMBER` is 0 to 9.
**Out:** this table, written by `sim-service/tests/system/test_attacks.py`.
**Never:** edited by hand: run that test with `UPDATE_GOLDENS=1`.

Each was run from a page, with every layer of protection on and with each one off. *prepared*: with all layers, and
compiled before Run was pressed, by a child that waited (what has a mistake is not). *refused*: it does not compile.
*denied*: the system refused what it asked for. *exception*: Haskell's own error ended it, as a refused system call
does. *memory*, *time*: a limit ended it. *stuck*: the service ended it, because it did not answer. *died*: it ended
itself, or was killed for what it called. *broken-link*, *too-much*: it sent what no program may send. *endless*:
nothing ended it but the page's leaving. *ran*: it did what it wanted to, which was harmless. An empty cell: as with
all layers.
"""


def show(table: dict[str, list[str]], columns: list[Column]) -> str:
    """A row for all programs that came to the same ends; a cell is empty where the end is that of the first column."""
    titles = " | ".join(column.title for column in columns)
    together = defaultdict[tuple[str, ...], list[str]](list)
    for name, row in table.items():
        together[row[0], *(end if end != row[0] else "" for end in row[1:])].append(name)
    rows = "\n".join(f"| {', '.join(names)} | {' | '.join(row)} |" for row, names in together.items())
    return f"{HEADING}\n| programs | {titles} |\n|---|{'---|' * len(columns)}\n{rows}\n"
