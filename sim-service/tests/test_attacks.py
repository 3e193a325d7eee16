"""
Programs that mean harm, each from a page's Run to its end, with every layer of protection on and with each one off.

``rosy-hs/test-worker/attacks`` holds a program a file. In none of the columns may one of them read the secret file,
leave a file, hit another process, or outlive its run. ``UPDATE_GOLDENS=1`` writes the table of what became of each.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.config import Config, Limits, discover
from rosy_sim.worker.launch import uses_sandbox

from .conftest import PATIENCE as HANG
from .processes import below
from .test_app import Page, opened, serving

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

ATTACKS = Path(__file__).resolve().parents[2] / "rosy-hs" / "test-worker" / "attacks"

SECRET = "rosy-secret-4711"

PATIENCE = 30.0
"""How long a program may do its worst where no limit of the service ends it, s."""

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


COLUMNS = [
    Column("all layers"),
    Column("without language", ("--without", "language")),
    Column("without system calls", ("--without", "system-calls")),
    Column("without limits", ("--without", "limits")),
    Column("without sandbox", sandbox=False),
    Column("without service", limits=ENDLESS),
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
        with subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"]) as victim:
            try:
                yield Target(secret, Path(folder, "target"), victim)
            finally:
                victim.kill()


def configured(column: Column) -> Config:
    config = discover().with_limits(column.limits)
    worker = (*config.worker, "--check-seconds", "2", "--run-seconds", "2", *column.off)
    return replace(config, worker=worker, sandbox=column.sandbox)


async def become(page: Page, source: str) -> str:
    """Run a program and say what became of it."""
    await page.send("run", run=1, source=source, speed=1, seed=1)
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
    async def one(address: str, source: str) -> str:
        async with opened(address) as page:
            return await become(page, aimed.aim(source))

    config = configured(column)
    async with serving(config) as (address, service), opened(address) as bystander:
        await bystander.op("worker", state="ready")
        before = below(os.getpid())
        outcomes: dict[str, str] = {}
        # Those that fill memory by themselves: they need the processor for it.
        for hungry in (True, False):
            names = [name for name in programs if name.startswith("memory") == hungry]
            outcomes |= zip(names, await asyncio.gather(*(one(address, programs[name]) for name in names)), strict=True)
        # Nothing is left, and nobody else noticed.
        async with asyncio.timeout(HANG):
            while service.places.taken or not children(before):
                await asyncio.sleep(0.01)
        await bystander.send("check", id=1, source="main = pure ()\n")
        assert (await bystander.op("checked"))["problems"] == []
    return outcomes


def children(before: set[int]) -> bool:
    """Whether all that was started since has ended; the worker keeps some processes of its own."""
    return len(below(os.getpid())) <= len(before) + 6


def test_no_program_does_harm_whichever_layer_is_missing() -> None:
    programs = {path.stem: path.read_text("utf-8") for path in sorted(ATTACKS.glob("*.hs"))}
    assert len(programs) >= 60
    columns = [*COLUMNS, *SINGLE_LIMITS] if os.environ.get("UPDATE_GOLDENS") else COLUMNS
    table: dict[str, list[str]] = {name: [] for name in programs}
    left = below(os.getpid())
    for column in columns:
        if column.sandbox and not uses_sandbox(configured(column)):
            pytest.skip("this machine cannot build the sandbox")
        with target() as aimed:
            outcomes = asyncio.run(attack(column, programs, aimed))
            assert aimed.unharmed(), f"{column.title}: one hit a process or changed a file"
        for name, outcome in outcomes.items():
            table[name].append(outcome)
    with contextlib.suppress(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)
    assert below(os.getpid()) <= left
    shown = show(table, columns)
    print(shown, flush=True)
    harmful = {name: row for name, row in table.items() if "HARM" in row}
    assert harmful == {}
    if os.environ.get("UPDATE_GOLDENS"):
        (ATTACKS / "README.md").write_text(shown, "utf-8")


HEADING = """# Programs that mean harm

**In:** a program a file; `CANARY` stands for a secret file, `TARGET` for a file to make, `VICTIM` for a process to hit.
**Out:** this table, written by `sim-service/tests/test_attacks.py`.
**Never:** edited by hand: run that test with `UPDATE_GOLDENS=1`.

Each was run from a page, with every layer of protection on and with each one off. *refused*: it does not compile.
*denied*: the system refused what it asked for. *exception*: Haskell's own error ended it, as a refused system call
does. *memory*, *time*: a limit ended it. *stuck*: the service ended it, because it did not answer. *died*: it ended
itself, or was killed for what it called. *broken-link*, *too-much*: it sent what no program may send. *endless*:
nothing ended it but the page's leaving. *ran*: it did what it wanted to, which was harmless.
"""


def show(table: dict[str, list[str]], columns: list[Column]) -> str:
    titles = " | ".join(column.title for column in columns)
    rows = "\n".join(f"| {name} | {' | '.join(row)} |" for name, row in table.items())
    return f"{HEADING}\n| program | {titles} |\n|---|{'---|' * len(columns)}\n{rows}\n"
