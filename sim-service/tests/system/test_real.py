"""The four first programs with the real worker, when it is built: the whole path, byte for byte."""

from __future__ import annotations

import asyncio
import io
import json
import os
import select
import socket
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest

from rosy_sim.config import Config, Limits, discover
from rosy_sim.robot_description import simulated
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.run.headless_run import RunOutput, RunResult, RunSettings, run_program
from rosy_sim.wire.worker import Started
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, usable_arena

from ..conftest import PATIENCE
from ..processes import below
from ..web.page_client import opened, serving

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

MOVE = "move :: Velocity\nmove = Velocity 0.5 0\n\nmain = simulate move\n"
ACCELERATE = "accelerate :: Velocity -> Velocity\naccelerate (Velocity v w) = Velocity (v + 0.5) w\n"
AND_PLAY = (
    ACCELERATE
    + "\nplay :: Bumper -> Maybe Sound\nplay (Bumper _ Pressed) = Just ErrorSound\nplay _ = Nothing\n"
    + "\nmain = simulate (accelerate, play)\n"
)
FORWARD_BACKWARD = """type Hit = Bool

hit :: Bumper -> Memory Hit
hit _ = Memory True

drive :: Memory Hit -> Velocity -> Velocity
drive (Memory True) (Velocity v w) = Velocity (v - 0.5) w
drive _ (Velocity v w) = Velocity (v + 0.5) w

main = simulate (hit, drive)
"""
PROGRAMS = {
    "move": MOVE,
    "accelerate": ACCELERATE + "\nmain = simulate accelerate\n",
    "accelerateAndPlay": AND_PLAY,
    "forwardBackward": FORWARD_BACKWARD,
}


TYPES = {kind["name"] for kind in simulated()["types"]}

LIMITS = Limits(settle=20.0, ready=60.0, gone=20.0, compile=60.0, preview=120.0, worker_ready=120.0)


@pytest.fixture(scope="module")
def real() -> Config:
    return discover().with_limits(LIMITS)


@pytest.fixture(scope="module")
def worker(real: Config) -> Iterator[BlockingWorker]:
    with BlockingWorker(real) as started:
        started.ready()
        yield started


def run(
    worker: BlockingWorker, source: str, order: RunSettings, limits: Limits = LIMITS
) -> tuple[RunResult, list[dict[str, Any]], bytes, World]:
    world = World(usable_arena(named_world("room"), "room"), KOBUKI)
    trace = io.BytesIO()
    outcome = run_program(worker, source, world, replace(order, limits=limits), RunOutput(trace=trace))
    return outcome, [json.loads(line) for line in trace.getvalue().splitlines()], trace.getvalue(), world


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_program_gives_the_same_bytes_at_any_speed(name: str, worker: BlockingWorker) -> None:
    order = RunSettings(seconds=8.0, seed=3)
    outcome, lines, once, _ = run(worker, PROGRAMS[name], order)
    assert (outcome.ended, outcome.steps, len(lines)) == ("time", 400, 400)
    assert any("Bumper CenterBumper Pressed" in line["events"] for line in lines)
    assert max(line["x"] for line in lines) > 4.8
    assert run(worker, PROGRAMS[name], replace(order, speed=20.0))[2] == once


def test_the_error_sound_plays_once_at_the_wall(worker: BlockingWorker) -> None:
    _, lines, _, _ = run(worker, AND_PLAY, RunSettings(8.0, 1))
    assert [c for line in lines for c in line["commands"] if "Sound" in c] == ["ErrorSound"]


USING = """data Mood = Mood

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

bumped :: BumperLeft -> Done ()
bumped _ = Done ()

sulk :: Either Cliff Button -> Mood
sulk _ = Mood

look :: Mood -> (Memory Int, Maybe Led1)
look _ = (Memory 1, Nothing)

drive :: Task ()
drive = do
  task accelerate bumped
  task () (sulk, look)

main = simulate drive
"""


STEPS = "main = simulate $ do\n  penColor RedInk\n  replicateM_ 2 (penDown >> drive 10)\n  once (PenWidth 0.1)\n"
"""Ready-made tasks, whose types are in no function of the program."""


@pytest.mark.parametrize(
    ("source", "types"),
    [
        (USING, ["BumperLeft", "Button", "Cliff", "Led1", "Velocity"]),
        (STEPS, ["Pen", "PenColor", "PenWidth"]),
    ],
)
def test_a_start_says_which_types_of_the_library_the_program_uses(
    source: str, types: list[str], worker: BlockingWorker
) -> None:
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    with ours:
        answer = worker.run(source, theirs)
    worker.kill()
    assert isinstance(answer, Started), answer
    assert [name for name in answer.uses if name in TYPES] == types


def test_forward_backward_ends_at_the_wall_behind(worker: BlockingWorker) -> None:
    _, _, _, world = run(worker, FORWARD_BACKWARD, RunSettings(20.0, 1))
    assert world.x == pytest.approx(0.17575, abs=1e-3)


@pytest.mark.parametrize(
    ("source", "ended", "kind", "function"),
    [
        ("main = simulate (1 + True)", "refused", None, None),
        ("spin :: Bumper -> Velocity\nspin b = spin b\n"
         "main = simulate (Velocity 0.7 0, spin)", "stuck", "stuck", "spin"),
        ("boom :: Bumper -> Velocity\nboom _ = Velocity (fromIntegral (div 1 (0 :: Int))) 0\n"
         "main = simulate (Velocity 0.7 0, boom)", "error", None, "boom"),
        ('main = simulate (say "hello")', "done", None, None),
    ],
)  # fmt: skip
def test_an_end_names_what_caused_it(
    source: str, ended: str, kind: str | None, function: str | None, worker: BlockingWorker
) -> None:
    outcome, _, _, _ = run(
        worker, source, RunSettings(20.0, 1), replace(LIMITS, settle=1.0) if ended == "stuck" else LIMITS
    )
    assert outcome.ended == ended
    assert len(outcome.problems) == (0 if ended == "done" else len(outcome.problems) or 1)
    if kind is not None:
        assert outcome.problems[0].kind == kind
    if function is not None:
        assert outcome.problems[0].function == function


def test_ten_runs_stopped_at_any_moment_leave_nothing_behind(real: Config) -> None:
    async def tell() -> None:
        async with serving(real) as (address, service), opened(address) as page:
            for run in range(1, 11):
                await page.send("run", run=run, source=MOVE, speed="max" if run % 2 else 1)
                if run % 3:
                    await page.op("state", run=run, state="running")
                await page.send("stop" if run % 2 else "reset")
                await page.ended(run)
            await page.send("check", id=1, source=MOVE)
            await page.op("checked")
            assert service.worker.pid is not None
            left.append(os.pidfd_open(service.worker.pid))

    left: list[int] = []
    before = below(os.getpid())
    asyncio.run(tell())
    # Its fork server reaps it, which may take a moment longer than the service.
    assert select.select(left, [], [], PATIENCE)[0] == left
    os.close(left[0])
    assert below(os.getpid()) <= before


def test_a_killed_worker_is_replaced_and_its_run_ends_with_a_sentence(real: Config) -> None:
    async def tell() -> None:
        async with serving(real) as (address, service), opened(address) as page:
            for run in (1, 2):
                await page.send("run", run=run, source=MOVE, speed="max")
                await page.until(lambda m: m["op"] == "frame" and m["step"] > 5)
                assert service.worker.pid is not None
                os.kill(service.worker.pid, 9)
                # The next worker may be there before the program of this one has died.
                ended, _ = await page.all_of(
                    {"op": "state", "run": run, "state": "ended"}, {"op": "worker", "state": "ready"}
                )
                assert ended["problems"][0]["kind"] == "worker-lost"

    asyncio.run(tell())
