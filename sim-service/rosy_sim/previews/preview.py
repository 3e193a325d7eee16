"""
Preview of one program: a headless run with the inputs of another run, and what a page draws of it.

The path, the collisions, the final pose and the ink are those that a run in the page would have with the same program,
room, seed and hands.
"""

from __future__ import annotations

import socket
from collections.abc import Callable
from typing import Any

import msgspec

from ..config import Limits
from ..robots import robot_in
from ..run.headless_run import Program, RunOutput, RunResult, RunSettings, run_over_link
from ..run.steps.hands import Hand, read_hands
from ..run.steps.velocity_guard import SafetySettings
from ..wire.page import Goal, Previewed
from ..wire.problem import Problem
from ..worker.mailbox import Mailbox
from ..world.arena import Arena, read_arena
from ..world.obstacles import Obstacles
from ..world.time_step import STEP
from ..world.world import World
from .path_recorder import PathRecorder, point_of

__all__ = ["PreviewTask", "RoomCache", "preview_over_link", "preview_settings", "refused_preview"]


class PreviewTask(msgspec.Struct, frozen=True):
    """What to run: ``seconds`` are simulated, ``world`` is a room as JSON that has been read before."""

    id: int
    source: str
    world: Any
    seed: int
    seconds: float
    safety: SafetySettings
    hands: list[Hand]


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
        world = World(self._arena, robot_in(self._arena), seed, self._obstacles)
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
        settings: those of ``preview_settings``.
        is_over: called every few steps; true when the result is no longer needed, or has taken too long: then the path
            ends early.
    """
    recorder = PathRecorder(world, is_over)
    result = run_over_link(link, world, settings, RunOutput(observe=recorder.observe), program, mailbox)
    return _previewed(task.id, result, world, recorder)


def refused_preview(ident: int, problems: list[Problem]) -> Previewed:
    """The result for a program that does not compile."""
    return Previewed(ident, "refused", 0.0, (0.0, 0.0, 0.0), [], [], [], problems)


def _previewed(ident: int, result: RunResult, world: World, recorder: PathRecorder) -> Previewed:
    last = point_of(result.steps * STEP, world)
    return Previewed(
        ident,
        result.ended,
        last[0],
        (round(world.x, 5), round(world.y, 5), round(world.theta, 5)),
        recorder.path if recorder.path[-1][1:] == last[1:] else [*recorder.path, last],
        recorder.collisions,
        [Goal(g.kind, g.title, g.state, round(g.progress, 2), g.time) for g in result.goals],
        result.problems,
        recorder.pen,
    )
