"""
Recordings of the guide's animations: where the robot was and what its sensors said while a program of a page ran.

``docs/animations.json`` says which program of which page, and for how many seconds. The recording is compared with
``docs/recordings/<name>.json``, from which ``editor/test/guide/animations.test.ts`` draws the animation.
``UPDATE_GOLDENS=1`` writes it anew.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from typing import Any

import pytest

from rosy_sim.config import discover
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.run.headless_run import RunOutput, RunSettings, run_program
from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, usable_arena

from .real_runs import LIMITS, worker_started
from .test_guide import BLOCKS, ROOT

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

SHOWN_CHANNELS = ("Bumper", "Cliff", "Wheel", "Button", "Led1", "Led2")
"""The channels that change how the robot is drawn."""

STEPS_PER_POSE = 5
"""A pose every tenth of a second."""

ANIMATIONS = json.loads((ROOT / "docs" / "animations.json").read_text("utf-8"))


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


@pytest.mark.parametrize("animation", ANIMATIONS, ids=lambda animation: animation["name"])
def test_an_animation_shows_what_its_program_does(animation: dict[str, Any], worker: BlockingWorker) -> None:
    recorded = recording(worker, animation)
    golden = ROOT / "docs" / "recordings" / f"{animation['name']}.json"
    if os.environ.get("UPDATE_GOLDENS"):
        golden.parent.mkdir(exist_ok=True)
        golden.write_text(recorded, "utf-8")
    assert golden.read_text("utf-8") == recorded


def recording(worker: BlockingWorker, animation: dict[str, Any]) -> str:
    """A program of a page, driven with seed 1: its poses, and the channels each time that they changed."""
    block = [one for one in BLOCKS if one.page == animation["page"]][animation["program"]]
    room = block.word("room", "room")
    place = World(usable_arena(named_world(room), "world"), KOBUKI, 1)
    poses: list[str] = []
    looks: list[tuple[float, dict[str, Any]]] = []

    def observe(run: Lockstep) -> None:
        if (run.step - 1) % STEPS_PER_POSE == 0:
            numbers = (run.time, place.x, place.y, place.theta)
            poses.append(json.dumps([round(number, 4) for number in numbers]))
        channels = {name: list(values) for name, values in place.channels().items() if name in SHOWN_CHANNELS}
        if not looks or looks[-1][1] != channels:
            looks.append((round(run.time, 2), channels))

    settings = RunSettings(animation["seconds"], seed=1, limits=LIMITS)
    run_program(worker, block.source, place, settings, RunOutput(observe=observe))
    lines = [json.dumps({"time": time, "channels": channels}) for time, channels in looks]
    return (
        f'{{"room": {json.dumps(named_world(room))},\n"seconds": {animation["seconds"]},\n"poses": [\n'
        + ",\n".join(poses)
        + '\n],\n"looks": [\n'
        + ",\n".join(lines)
        + "\n]}\n"
    )
