"""
Trial of a program in one room: a headless run that is judged by properties, and ends when they are decided.

The outcome is a pure function of the program, the room, its seed, the time and the properties, so it has no wall-clock
time in it.
"""

from __future__ import annotations

import socket
from collections.abc import Sequence
from typing import Any, Literal

import msgspec

from ..config import Limits
from ..robots import robot_in
from ..run.headless_run import Program, RunOutput, RunSettings, run_over_link
from ..run.steps.lockstep import Lockstep
from ..run.steps.velocity_guard import OFF, SafetySettings
from ..wire.problem import Problem
from ..world.arena import read_arena
from ..world.properties import Property, PropertyTracker, Verdict
from ..world.time_step import STEP
from ..world.world import World

__all__ = ["Finding", "Outcome", "judge_run", "refused"]

_POINT_DISTANCE = 0.05
"""Between two points of a path, m: less than a pixel of a small picture."""


class Finding(msgspec.Struct, frozen=True):
    """A verdict as it is sent and printed; ``property`` are its words. ``world.properties`` explains the numbers."""

    property: str
    state: Literal["open", "held", "failed"]
    time: float | None
    amount: float
    shortfall: float


class Outcome(msgspec.Struct, frozen=True):
    """How a program did in a room. Times are in simulated s, the pose and the path in m and rad."""

    room: int
    seed: int
    ended: Literal["time", "done", "error", "stuck", "refused"]
    time: float
    pose: tuple[float, float, float]
    findings: list[Finding]
    problems: list[Problem]
    path: list[tuple[float, float]]

    @property
    def has_crashed(self) -> bool:
        """Whether the program itself failed."""
        return self.ended in ("error", "stuck")

    @property
    def has_passed(self) -> bool:
        """Whether the program went well and every property holds."""
        return self.ended in ("time", "done") and not self.failed

    @property
    def failed(self) -> list[Finding]:
        """The properties that do not hold."""
        return [finding for finding in self.findings if finding.state != "held"]

    def fails_like(self, other: Outcome) -> bool:
        """Whether it fails in a way in which the other one failed."""
        if other.has_crashed:
            return self.has_crashed
        kinds = {finding.property for finding in other.failed}
        return any(finding.property in kinds for finding in self.failed)


class _Recorder:
    """Follows a run: the verdicts and the path."""

    def __init__(self, properties: Sequence[Property], world: World) -> None:
        self.tracker = PropertyTracker(properties, world.arena, world.robot.body)
        self.path = [(round(world.x, 3), round(world.y, 3))]

    def observe(self, lockstep: Lockstep) -> bool:
        """Take a step; returns whether the run may end. The step in which the program ended is none."""
        if lockstep.state == "ended":
            return False
        now = lockstep.observation()
        self.tracker.observe(now)
        x, y = self.path[-1]
        if abs(now.x - x) + abs(now.y - y) >= _POINT_DISTANCE:
            self.path.append((round(now.x, 3), round(now.y, 3)))
        return self.tracker.is_decided


def judge_run(
    link: socket.socket,
    program: Program,
    room: tuple[int, dict[str, Any], int],
    seconds: float,
    properties: Sequence[Property],
    limits: Limits,
    safety: SafetySettings = OFF,
) -> Outcome:
    """Run a program that waits at the other end of a link in a room: its number, its world and its seed."""
    number, json, seed = room
    arena = read_arena(json)
    world = World(arena, robot_in(arena), seed)
    recorder = _Recorder(properties, world)
    settings = RunSettings(seconds, seed, limits=limits, safety=safety)
    result = run_over_link(link, world, settings, RunOutput(observe=recorder.observe), program)
    time = round(result.steps * STEP, 2)
    recorder.tracker.finish(time)
    return Outcome(
        number,
        seed,
        result.ended,
        time,
        (world.x, world.y, world.theta),
        [_finding(verdict) for verdict in recorder.tracker.verdicts],
        result.problems,
        recorder.path,
    )


def refused(number: int, seed: int, problems: list[Problem]) -> Outcome:
    """The outcome of a program that does not compile."""
    return Outcome(number, seed, "refused", 0.0, (0.0, 0.0, 0.0), [], problems, [])


def _finding(verdict: Verdict) -> Finding:
    time = None if verdict.time is None else round(verdict.time, 2)
    return Finding(str(verdict.property), verdict.state, time, round(verdict.amount, 6), round(verdict.shortfall, 6))
