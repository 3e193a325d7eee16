"""
Preview of one program: a headless run with the inputs of another run, and what a page draws of it.

The path, the collisions and the final pose are those that a run in the page would have with the same program, room,
seed and hands.
"""

from __future__ import annotations

import socket
from collections.abc import Callable
from typing import Any

import msgspec

from ..config import Limits
from ..robots import DEFAULT_ROBOT
from ..run.headless_run import Program, RunOutput, RunResult, RunSettings, run_over_link
from ..run.steps.hands import Hand, read_hands
from ..run.steps.lockstep import Lockstep
from ..run.steps.velocity_guard import SafetySettings
from ..wire.page import Goal, Previewed
from ..wire.problem import Problem
from ..worker.mailbox import Mailbox
from ..world.arena import Arena, read_arena
from ..world.obstacles import Obstacles
from ..world.time_step import STEP
from ..world.world import World
from .computing_budget import ComputingBudget

__all__ = ["PathRecorder", "PreviewTask", "RoomCache", "preview_over_link", "preview_settings", "refused_preview"]

_POINT_DISTANCE = 0.02
"""Between two points of a path, m: less than a pixel of a picture of a whole room."""

_MAX_POINTS = 2000
"""Points of a path; a longer one has its points farther apart. 40 m at the usual distance."""

_MAX_COLLISIONS = 100
"""Collisions that are told of one preview."""

_CONTACT_PAUSE = 0.2
"""Contacts closer together than this are one collision, s: the hold of the safety rules after a contact."""


class PreviewTask(msgspec.Struct, frozen=True):
    """What to run: ``seconds`` are simulated, ``world`` is a room as JSON that has been read before."""

    id: int
    source: str
    world: Any
    seed: int
    seconds: float
    safety: SafetySettings
    hands: list[Hand]


class PathRecorder:
    """Follows a run step by step: path and collisions, each point as time (s), x, y (m)."""

    def __init__(self, world: World) -> None:
        self.path: list[tuple[float, float, float]] = [_point(0.0, world)]
        self.collisions: list[tuple[float, float, float]] = []
        self._distance = _POINT_DISTANCE
        # When the robot last touched something; None before the first contact.
        self._touched: float | None = None

    def observe(self, lockstep: Lockstep) -> None:
        """Take the state after a step."""
        world = lockstep.world
        _, x, y = self.path[-1]
        if abs(world.x - x) + abs(world.y - y) >= self._distance:
            self._add(_point(lockstep.time, world))
        if world.is_blocked or (world.has_contacts and world.sensors.bumpers):
            now = lockstep.time
            begins = self._touched is None or now - self._touched > _CONTACT_PAUSE
            if begins and len(self.collisions) < _MAX_COLLISIONS:
                self.collisions.append(_point(now, world))
            self._touched = now

    def _add(self, point: tuple[float, float, float]) -> None:
        if len(self.path) >= _MAX_POINTS:
            self._distance *= 2
            self.path = self.path[::2]
        self.path.append(point)


def preview_settings(task: PreviewTask, limits: Limits) -> RunSettings:
    """How a preview is run."""
    hands = tuple((step * STEP, action) for step, action in read_hands(task.hands))
    return RunSettings(task.seconds, task.seed, None, hands, limits, task.safety, busy_waits=True)


class RoomCache:
    """Cache of one room, that of the latest preview: reading it and building its walls takes some milliseconds."""

    def __init__(self) -> None:
        self._json: Any = None
        self._arena: Arena | None = None
        self._obstacles: Obstacles | None = None

    def world(self, room: Any, seed: int) -> World:
        """A robot in a room, which is given as JSON."""
        if self._arena is None or room != self._json:
            self._arena = read_arena(room)
            self._json = room
            self._obstacles = None
        world = World(self._arena, DEFAULT_ROBOT, seed, self._obstacles)
        # Things that can be pushed do not stand where they stood.
        self._obstacles = None if world.obstacles.movables else world.obstacles
        return world


def preview_over_link(
    task: PreviewTask,
    settings: RunSettings,
    world: World,
    link: socket.socket,
    program: Program,
    is_over: Callable[[], bool],
    mailbox: Mailbox | None = None,
) -> Previewed:
    """
    Run a program that waits at the other end of a link.

    Args:
        settings: those of ``preview_settings``; their ``limits.preview`` bounds the processor time of this process and
            those below it; then the path ends early.
        is_over: called in each step; true when the result is no longer needed.
    """
    recorder = PathRecorder(world)
    budget = ComputingBudget(settings.limits.preview)

    def observe(lockstep: Lockstep) -> bool:
        if lockstep.state != "ended":
            recorder.observe(lockstep)
        return is_over() or budget.is_used_up()

    result = run_over_link(link, world, settings, RunOutput(observe=observe), program, mailbox)
    return _previewed(task.id, result, world, recorder)


def refused_preview(ident: int, problems: list[Problem]) -> Previewed:
    """The result for a program that does not compile."""
    return Previewed(ident, "refused", 0.0, (0.0, 0.0, 0.0), [], [], [], problems)


def _previewed(ident: int, result: RunResult, world: World, recorder: PathRecorder) -> Previewed:
    last = _point(result.steps * STEP, world)
    return Previewed(
        ident,
        result.ended,
        last[0],
        (round(world.x, 5), round(world.y, 5), round(world.theta, 5)),
        recorder.path if recorder.path[-1][1:] == last[1:] else [*recorder.path, last],
        recorder.collisions,
        [Goal(g.kind, g.title, g.state, round(g.progress, 2), g.time) for g in result.goals],
        result.problems,
    )


def _point(time: float, world: World) -> tuple[float, float, float]:
    return (round(time, 2), round(world.x, 3), round(world.y, 3))
