"""
The worker and the service under nonsense and under fire: a little in every run, a lot when asked.

``ROSY_ENDURE=10000`` makes ten thousand random texts and as many mutated programs, ``ROSY_KILLS=200`` as many murders;
both print what there was before and after (README.md says how). Failures name the seed and the number of what caused
them.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import random
import re
import signal
import socket
import sys
import time
import urllib.request
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest

from rosy_sim.config import Config, Limits, discover
from rosy_sim.errors import WorkerLost
from rosy_sim.wire.worker import Started
from rosy_sim.worker.client import Worker

from .processes import alive, below, descriptors, named, resident
from .test_app import Page, opened

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

TEXTS = int(os.environ.get("ROSY_ENDURE", "200"))
KILLS = int(os.environ.get("ROSY_KILLS", "6"))
SEED = int(os.environ.get("ROSY_SEED", "1"))

WORDS = ["where", "let", "in", "case", "of", "data", "class", "instance", "deriving", "do", "Memory", "import"]

AT_ONCE = 8
"""Requests under way at the same time."""

PATIENT = Limits(settle=20.0, ready=60.0, gone=60.0, compile=120.0, worker_ready=120.0)

ROOT = Path(__file__).resolve().parents[2]

DRIVE = "move :: Velocity\nmove = Velocity 0.3 0.1\n\nmain = simulate move\n"


def programs() -> list[str]:
    """What mutants are made from: the examples, and the mistakes that learners make."""
    examples = sorted(ROOT.glob("examples/*/Main.hs"))
    mistakes = sorted(ROOT.glob("rosy-hs/test-worker/gallery/*/Main.hs"))
    return [file.read_text("utf-8") for file in [*examples * 5, *mistakes]]


def random_text(dice: random.Random) -> str:
    """Random bytes, read as text in one way or another."""
    octets = dice.randbytes(dice.choice((1, 10, 100, 1000)))
    return octets.decode(dice.choice(("latin-1", "utf-8", "utf-16-le")), "replace")


def mutant(dice: random.Random, originals: list[str]) -> str:
    """A program that somebody's cat has walked over."""
    text = dice.choice(originals)
    for _ in range(dice.choice((1, 1, 2, 3, 10))):
        at, to = sorted(dice.randrange(len(text) + 1) for _ in range(2))
        to = min(to, at + dice.choice((1, 5, 40)))
        match dice.randrange(8):
            case 0:
                text = text[:at] + text[to:]
            case 1:
                text = text[:at] + dice.choice("(){}[]=|\\:;,.'\"`_-<>@#$ \n\t0aZ∀λ") + text[at:]
            case 2:
                text = text[:at] + text[at:to] * dice.choice((2, 3, 50)) + text[to:]
            case 3:
                other = dice.choice(originals)
                begin = dice.randrange(len(other) + 1)
                text = text[:at] + other[begin : begin + 60] + text[to:]
            case 4:
                lines = text.splitlines(keepends=True)
                dice.shuffle(lines)
                text = "".join(lines)
            case 5:
                text = f"{text[:at]} {dice.choice(WORDS)} {text[to:]}"
            case _:
                # Often still a program.
                text = text[:at] + re.sub(r"\b\d", lambda _: str(dice.randrange(10)), text[at:], count=2)
    return text


def texts(count: int, seed: int) -> Iterator[tuple[str, str]]:
    """Names and texts: as many random ones as mutants."""
    originals = programs()
    for kind in ("random", "mutant"):
        for number in range(count):
            dice = random.Random(f"{seed} {kind} {number}")
            yield f"{kind} {number} of seed {seed}", random_text(dice) if kind == "random" else mutant(dice, originals)


@asynccontextmanager
async def warm(config: Config) -> AsyncIterator[Worker]:
    ready = asyncio.Event()
    worker = Worker(config, lambda state: ready.set() if state == "ready" else None)
    keeper = asyncio.create_task(worker.run())
    try:
        await ready.wait()
        yield worker
    finally:
        keeper.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await keeper


async def checked_and_run(worker: Worker, name: str, source: str) -> bool:
    """Every request is answered; says whether the program ran."""
    try:
        await worker.check(source)
        ours, theirs = socket.socketpair()
        with ours:
            program = await worker.start(source, theirs)
            async with asyncio.timeout(PATIENT.compile):
                answer = await program.started
                if isinstance(answer, Started):
                    worker.kill(program)
                    await program.gone
        return isinstance(answer, Started)
    except (WorkerLost, TimeoutError) as error:
        raise AssertionError(f"{name}: {error!r}\n{source!r}") from error


def counts() -> dict[str, int]:
    """What must not grow."""
    ours = below(os.getpid())
    [*workers] = named(ours, "/rosy-worker")
    own = [pid for pid in workers if len(below(pid)) == max(len(below(w)) for w in workers)]
    return {
        "processes": len(ours),
        "descriptors of the worker": max((descriptors(pid) for pid in own), default=0),
        "memory of the worker, MB": max((resident(pid) for pid in workers), default=0) // 1024,
        "descriptors here": descriptors(os.getpid()),
    }


async def settled() -> dict[str, int]:
    """The counts once nothing changes any more."""
    before = counts()
    for _ in range(200):
        await asyncio.sleep(0.02)
        now = counts()
        if now == before:
            return now
        before = now
    return before


def test_no_text_crashes_or_hangs_the_worker_or_leaves_anything_behind() -> None:
    async def tell() -> None:
        # Without a spare worker, which would come at some moment in between.
        config = discover().with_limits(PATIENT)
        async with warm(config) as worker:
            first = worker.pid
            work = texts(TEXTS, SEED)
            ran = 0

            async def some() -> None:
                nonlocal ran
                for name, source in work:
                    ran += await checked_and_run(worker, name, source)

            # Several at once, so that all the children are there that answer questions.
            first_ones = list(texts(20, SEED + 1))
            await asyncio.gather(*(checked_and_run(worker, name, source) for name, source in first_ones))
            await asyncio.sleep(3.5)
            before = await settled()
            began = time.monotonic()
            await asyncio.gather(*(some() for _ in range(AT_ONCE)))
            after = await settled()
            assert worker.pid == first, "the worker died"
        print(f"\n{2 * TEXTS} texts checked and run in {time.monotonic() - began:.0f} s; {ran} of them were programs")
        print(f"before: {before}\nafter:  {after}")
        assert after["processes"] <= before["processes"]
        assert after["descriptors of the worker"] <= before["descriptors of the worker"]
        assert after["descriptors here"] <= before["descriptors here"]
        # Its cache of answers is full then, and its heap has found its size.
        assert after["memory of the worker, MB"] <= before["memory of the worker, MB"] + 100

    asyncio.run(tell())


# Under fire


class Fort:
    """The whole service as a process of its own, started again when it has been killed."""

    def __init__(self) -> None:
        with socket.create_server(("127.0.0.1", 0)) as free:
            self.port = free.getsockname()[1]
        self.address = f"127.0.0.1:{self.port}"
        self._process: asyncio.subprocess.Process | None = None

    @property
    def pid(self) -> int:
        assert self._process is not None
        return self._process.pid

    async def start(self) -> None:
        command = [sys.executable, "-m", "rosy_sim", "serve", "--port", str(self.port), "--no-browser"]
        self._process = await asyncio.create_subprocess_exec(
            *command, cwd=ROOT / "sim-service", stdout=asyncio.subprocess.DEVNULL
        )
        await self.ready()

    async def ready(self) -> None:
        """Until it answers and its worker is warm."""
        async with asyncio.timeout(120):
            while await asyncio.to_thread(self._state) != "ready":
                await asyncio.sleep(0.02)

    def _state(self) -> str:
        try:
            with urllib.request.urlopen(f"http://{self.address}/api/health", timeout=10) as answer:
                return str(json.load(answer)["worker"])
        except (OSError, ValueError):
            return "away"

    async def buried(self) -> None:
        assert self._process is not None
        await self._process.wait()

    async def end(self) -> None:
        assert self._process is not None
        with contextlib.suppress(ProcessLookupError):
            self._process.terminate()
        await self._process.wait()


async def gone(pids: set[int]) -> None:
    """Until none of these processes is left."""
    async with asyncio.timeout(30):
        while alive(pids):
            await asyncio.sleep(0.01)


async def crowd_member(fort: Fort, seed: int) -> None:
    """Somebody who runs and checks all the time, and comes back whenever the connection breaks."""
    dice = random.Random(seed)
    run = 0
    while True:
        with contextlib.suppress(Exception):
            async with opened(fort.address, open_timeout=5) as page:
                while True:
                    run += 1
                    await page.send("check", id=run, source=f"{DRIVE}-- {seed} {run}\n")
                    await page.send("run", run=run, source=DRIVE, speed=1)
                    await asyncio.sleep(dice.random() / 2)
        await asyncio.sleep(0.05)


async def serves(fort: Fort) -> None:
    """A newcomer can check and run a program."""
    await fort.ready()
    for attempt in range(3):
        # A worker that has just been replaced may take a newcomer's first request with it.
        async with opened(fort.address) as page:
            if await drives(page, attempt):
                return
    raise AssertionError("no program runs any more")


async def drives(page: Page, run: int) -> bool:
    await page.send("run", run=run, source=DRIVE, speed=1)
    last = await page.until(lambda m: m.get("state") == "ended" or (m["op"] == "frame" and m["v"] > 0.1))
    return bool(last["op"] == "frame")


def test_whoever_is_killed_at_whatever_moment_the_service_recovers_and_nobody_is_orphaned() -> None:
    async def tell() -> None:
        dice = random.Random(SEED)
        fort = Fort()
        await fort.start()
        crowd = [asyncio.create_task(crowd_member(fort, n)) for n in range(6)]
        killed = {"worker": 0, "program": 0, "service": 0}
        slowest = 0.0
        try:
            for number in range(KILLS):
                await asyncio.sleep(dice.random())
                whom = ("worker", "program", "service")[number % 3]
                everybody = below(fort.pid)
                if whom == "service":
                    os.kill(fort.pid, signal.SIGKILL)
                    await fort.buried()
                    await gone(everybody)
                    began = time.monotonic()
                    await fort.start()
                else:
                    workers = named(everybody, "/rosy-worker")
                    leaves = {pid for pid in workers if not below(pid)}
                    victims = sorted(leaves if whom == "program" else workers - leaves) or sorted(workers)
                    began = time.monotonic()
                    with contextlib.suppress(ProcessLookupError):
                        os.kill(dice.choice(victims), signal.SIGKILL)
                killed[whom] += 1
                await serves(fort)
                slowest = max(slowest, time.monotonic() - began)
        finally:
            for member in crowd:
                member.cancel()
            everybody = below(fort.pid)
            await fort.end()
        await gone(everybody)
        print(f"\nkilled: {killed}; a newcomer's program drove again after {slowest:.1f} s at the latest; no orphan")

    asyncio.run(tell())
