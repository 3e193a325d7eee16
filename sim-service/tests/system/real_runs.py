"""Runs through the real worker as the tests read them: what was sensed, commanded and driven, step by step."""

from __future__ import annotations

import io
import json
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from rosy_sim.config import Limits, discover
from rosy_sim.explain.recorded_run import RecordedRun
from rosy_sim.run.headless_run import RunOutput, RunResult, RunSettings, run_program
from rosy_sim.wire.user_input import Published
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import UserAction
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, usable_world

__all__ = ["LIMITS", "Ran", "example", "program", "ran", "velocities", "worker_started"]

LIMITS = Limits(
    settle=20.0, ready=60.0, unattended=60.0, stop=5.0, gone=60.0, compile=120.0, preview=120.0, worker_ready=120.0
)
"""Wall-clock limits that a busy machine keeps."""

_NUMBER = r"\(?(-?[0-9.]+(?:e-?[0-9]+)?)\)?"
_VELOCITY = re.compile(rf"Velocity {_NUMBER} {_NUMBER}")

Line = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Ran:
    """A finished run: how it ended, its trace, what it said and when, and the world as it was left."""

    outcome: RunResult
    lines: list[Line]
    said: list[str]
    world: World

    def at(self, time: float) -> Line:
        """The line of a step."""
        return self.lines[round(time * 50)]

    def between(self, begin: float, end: float) -> list[Line]:
        """The lines from one time on, up to another."""
        return self.lines[round(begin * 50) : round(end * 50)]

    def velocities(self) -> list[tuple[float, float, float]]:
        """Each velocity that was commanded, with its time."""
        return [(line["t"], v, w) for line in self.lines for v, w in velocities(line)]

    def heard(self, *words: str) -> list[float]:
        """The times at which an event with all these words came."""
        return [line["t"] for line in self.lines for event in line["events"] if all(word in event for word in words)]

    def rest(self) -> World:
        """The world a tenth of a second later: long enough to brake, too short for the base to stop by itself."""
        self.world.integrate(0.1)
        return self.world

    def longest_stay(self, radius: float) -> float:
        """The longest time spent within ``radius`` of one place, s."""
        longest, first = 0.0, self.lines[0]
        for line in self.lines:
            if math.hypot(line["x"] - first["x"], line["y"] - first["y"]) > radius:
                first = line
            longest = max(longest, line["t"] - first["t"])
        return longest


def velocities(line: Line) -> list[tuple[float, float]]:
    """What was commanded in one step, in order."""
    found = [_VELOCITY.fullmatch(command) for command in line["commands"]]
    return [(float(match[1]), float(match[2])) for match in found if match]


def worker_started() -> Iterator[BlockingWorker]:
    """The body of a fixture: a warm worker."""
    with BlockingWorker(discover().with_limits(LIMITS)) as started:
        started.ready()
        yield started


def program(name: str) -> tuple[str, str]:
    """The Haskell of an example and the world it names."""
    project = json.loads((discover().examples / name / "program.rosy").read_text("utf-8"))
    return project["haskell"], project["world"]


def example(
    worker: BlockingWorker,
    name: str,
    seconds: float,
    *hands: tuple[float, UserAction | Published],
    seed: int = 1,
    world: str | None = None,
) -> Ran:
    """Run an example in its own world, or in another."""
    source, own = program(name)
    return ran(worker, source, seconds, *hands, seed=seed, world=named_world(world or own))


def ran(
    worker: BlockingWorker,
    source: str,
    seconds: float,
    *hands: tuple[float, UserAction | Published],
    seed: int = 1,
    world: dict[str, Any] | None = None,
    limits: Limits = LIMITS,
    record: RecordedRun | None = None,
) -> Ran:
    """Run a program; ``record`` takes its firings."""
    place = usable_world(world if world is not None else named_world("empty"), "world", seed)
    trace = io.BytesIO()
    said: list[str] = []
    settings = RunSettings(seconds, seed, None, hands, limits)
    outcome = run_program(worker, source, place, settings, RunOutput(said.append, trace, record=record))
    return Ran(outcome, [json.loads(line) for line in trace.getvalue().splitlines()], said, place)
