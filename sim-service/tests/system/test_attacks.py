"""
Programs that mean harm, each from a page's Run to its end, with every layer of protection on and with each one off.

``rosy-hs/test-worker/attacks`` holds a program a file. In one column each is compiled before Run is pressed. In none of
the columns may one of them read the secret file, leave a file, hit another process, or outlive its run.
``UPDATE_GOLDENS=1`` writes the table of what became of each.

``./rosy test`` runs each program on two days of six, on one of them with all layers, and on one in another column;
after a change of the worker or of its launcher on each day. ``./rosy test nightly`` runs each in every column.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
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
from ..extent import SEED, TODAY, WHOLE, rotated
from ..processes import below
from ..web.page_client import Page, opened, serving

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

ATTACKS = Path(__file__).resolve().parents[3] / "rosy-hs" / "test-worker" / "attacks"

SECRET = "rosy-secret-4711"

RECORDS = bool(os.environ.get("UPDATE_GOLDENS"))
"""Whether the table is written."""

EVERYWHERE = RECORDS or WHOLE
"""Whether each program runs in every column."""

PROTECTION = ("rosy-hs/worker/", "rosy-hs/test-worker/attacks/", "sim-service/rosy_sim/worker/")
"""Sources of what protects a machine, and of the programs that attack it."""

SANDBOX_CHANGED = any(name.startswith(PROTECTION) for name in TODAY.changed)
"""Whether what protects a machine may have changed since all tests passed."""

PATIENCE = 30.0 if EVERYWHERE else 10.0
"""How long a program may do its worst where no limit of the service ends it, s."""

PREPARING = 10.0
"""How long a prepared child is waited for, s: one that takes too long to compile never waits."""

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
    worker = (*config.worker, "--check-seconds", "2", "--run-seconds", "2", *column.off)
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
                        await asyncio.sleep(0.01)
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


async def become(page: Page) -> str:
    """What becomes of a program that the page runs."""
    last = await page.until(started_or_ended)
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
            return await become(page)

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
            while service.run_queue.running or not children(before):
                await asyncio.sleep(0.01)
        await bystander.send("check", id=1, source="main = pure ()\n")
        assert (await bystander.op("checked"))["problems"] == []
    return outcomes


def children(before: set[int]) -> bool:
    """Whether all that was started since has ended; the worker keeps some processes of its own."""
    return len(below(os.getpid())) <= len(before) + 6


def programs_of(
    column: int, programs: dict[str, str], seed: int = SEED, days: int = 2 if SANDBOX_CHANGED else 6
) -> dict[str, str]:
    """
    The programs that run in a column today. Within ``days`` each program runs once in the first column, with all layers
    on, and once in one of the others, which take turns.
    """
    names = list(programs)
    if column == 0:
        today = rotated(names, days, seed=seed, whole=EVERYWHERE)
    else:
        one_off = rotated(names, len(COLUMNS) - 1, seed=seed // days + column, whole=EVERYWHERE)
        today = [name for name in one_off if EVERYWHERE or name in rotated(names, days, seed=seed + 1, whole=False)]
    return {name: programs[name] for name in today}


@pytest.mark.skipif(EVERYWHERE, reason="each program runs in every column")
@pytest.mark.parametrize("days", [2, 6])
@pytest.mark.parametrize("first", [0, 3, 20_785])
def test_each_program_meets_every_column_in_its_turn(days: int, first: int) -> None:
    programs = dict.fromkeys("abcdefghijk", "")
    met: set[tuple[str, int]] = set()
    for seed in range(first, first + days * len(COLUMNS)):
        met |= {(name, column) for column in range(len(COLUMNS)) for name in programs_of(column, programs, seed, days)}
    assert len(met) == len(programs) * len(COLUMNS)
    period = [[*programs_of(0, programs, first + day, days)] for day in range(days)]
    assert sorted(name for day in period for name in day) == sorted(programs)


def harmless(number: int, column: Column) -> dict[str, str]:
    """What became of each of the programs that run in this column; fails if one did harm or left a process."""
    programs = {path.stem: path.read_text("utf-8") for path in sorted(ATTACKS.glob("*.hs"))}
    assert len(programs) >= 250
    left = below(os.getpid())
    if column.sandbox and not uses_sandbox(read_robot_configuration(column)):
        pytest.skip("this machine cannot build the sandbox")
    with target() as aimed:
        outcomes = asyncio.run(attack(column, programs_of(number, programs), aimed))
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
        for number, column in enumerate(columns):
            outcomes = harmless(number, column)
            for name, row in table.items():
                row.append(outcomes[name])
        (ATTACKS / "README.md").write_text(show(table, columns), "utf-8")

else:

    @pytest.mark.long
    @pytest.mark.parametrize("number", range(len(COLUMNS)), ids=[column.title for column in COLUMNS])
    def test_no_program_does_harm_whichever_layer_is_missing(number: int) -> None:
        outcomes = harmless(number, COLUMNS[number])
        for name, outcome in outcomes.items():
            print(f"{name}: {outcome}")


HEADING = """# Programs that mean harm

**In:** a program a file; `CANARY` stands for a secret file, `TARGET` for a file to make, `VICTIM` for a process to hit.
**Out:** this table, written by `sim-service/tests/system/test_attacks.py`.
**Never:** edited by hand: run that test with `UPDATE_GOLDENS=1`.

Each was run from a page, with every layer of protection on and with each one off. *prepared*: with all layers, and
compiled before Run was pressed, by a child that waited (what has a mistake is not). *refused*: it does not compile.
*denied*: the system refused what it asked for. *exception*: Haskell's own error ended it, as a refused system call
does. *memory*, *time*: a limit ended it. *stuck*: the service ended it, because it did not answer. *died*: it ended
itself, or was killed for what it called. *broken-link*, *too-much*: it sent what no program may send. *endless*:
nothing ended it but the page's leaving. *ran*: it did what it wanted to, which was harmless.
"""


def show(table: dict[str, list[str]], columns: list[Column]) -> str:
    titles = " | ".join(column.title for column in columns)
    rows = "\n".join(f"| {name} | {' | '.join(row)} |" for name, row in table.items())
    return f"{HEADING}\n| program | {titles} |\n|---|{'---|' * len(columns)}\n{rows}\n"
