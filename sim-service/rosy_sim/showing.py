"""
What one page is shown of its robot: frames, words, sounds, goals, and where a run is.

As much as a page can show and no more: a program that talks without end must not fill our memory.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from .budget import Budget
from .outbox import Outbox
from .wire import page
from .wire.holder import FrameLine
from .wire.link import Kept
from .wire.problem import Problem
from .world.goals import GoalState
from .world.world import World

__all__ = ["Ended", "Showing"]

Ended = Literal["done", "error", "stuck", "stopped", "time", "refused"]

_MAX_FIRED = 200
"""Firings told in one frame; the latest ones."""

_DIGITS = 5
"""Digits after the point of what is drawn, m and rad: a hundredth of a millimetre. All would double the bytes."""

_MAX_WORDS = 10_000
"""Characters of one `Say` that reach the page."""

_MAX_SOUNDS = 10
"""Sounds of one step that reach the page."""


class Showing:
    """Puts answers into a page's outbox."""

    def __init__(self, outbox: Outbox, world: World, frame_rate: float, now: Callable[[], float]) -> None:
        self._outbox = outbox
        self._now = now
        # What is drawn; renew() and enter() change it.
        self._world = world
        # A real robot is shown instead of the world.
        self.elsewhere = False
        # The run whose number is on what is shown, and its latest step.
        self.run = 0
        self.step = 0
        # Where the page was last told that the movable things are, and how the goals stood.
        self._boxes: list[tuple[float, float, float]] = []
        self._goals: list[page.Goal] = []
        # Says and sounds that may still go to the page: 100 a second, 300 at once.
        self._words = Budget(100.0, 300.0, now())
        # Frames that may still go out, a few at once so that a step that is late gets one too; and what fired since.
        self._frames = Budget(frame_rate, 3.0, now())
        self._fired: list[str] = []
        # What the program remembers now, when the page has not been told yet.
        self._memory: list[Kept] | None = None

    def enter(self, world: World) -> None:
        """Another room; the page does not know where its things are."""
        self._world = world
        self._boxes = []

    def renew(self, world: World) -> None:
        """The same room as it was at the start, before a run or after a reset."""
        self.enter(world)
        self._goals = []
        self._fired = []
        self._memory = None
        self.step = 0

    def room(self, world_json: Any) -> None:
        """The room to draw, as JSON gave it."""
        self._outbox.put(page.WorldShown(world_json))
        self.frame(force=True)

    def state(self, state: Literal["compiling", "running"], problems: list[Problem] | None = None) -> None:
        """Where the run is."""
        self._outbox.put(page.RunState(self.run, state, problems or []))

    def queued(self, place: int) -> None:
        """The run waits for a place."""
        self._outbox.put(page.RunState(self.run, "queued", [], place=place))

    def over(self, run: int, ended: Ended, problems: list[Problem]) -> None:
        """A run, which need not be the latest, has ended."""
        self._outbox.put(page.RunState(run, "ended", problems, ended))

    def fired(self, names: list[str]) -> None:
        """Functions have fired; the next frame says so."""
        self._fired = (self._fired + names)[-_MAX_FIRED:]

    def memory(self, kept: list[Kept]) -> None:
        """The program remembers something else; the next frame says so."""
        self._memory = kept

    def words(self, time: float, said: list[str], sounds: list[int]) -> None:
        """What a step of the run was heard to say."""
        for text in said:
            if self._words.spend(1, self._now()):
                self.said(time, text[:_MAX_WORDS])
        for sound in sounds[:_MAX_SOUNDS]:
            if self._words.spend(1, self._now()):
                self.sound(time, sound)

    def said(self, time: float, text: str) -> None:
        """A line for the console."""
        self._outbox.put(page.Said(time, text, run=self.run))

    def sound(self, time: float, sound: int) -> None:
        """A sound to play."""
        self._outbox.put(page.SoundPlayed(time, sound, run=self.run))

    def goals(self, states: list[GoalState]) -> None:
        """How the goals stand; the page is told when something has changed visibly."""
        goals = [page.Goal(s.kind, s.title, s.state, round(s.progress, 2), s.time) for s in states]
        if goals != self._goals:
            self._goals = goals
            self._outbox.put(page.GoalsShown(self.run, goals))

    def frame(self, force: bool = False) -> None:
        """The simulated robot as it is now, unless the last frame was too recent."""
        if self.elsewhere:
            return
        if not force and not self._frames.spend(1, self._now()):
            return
        world = self._world
        bits = world.bits
        fired, self._fired = self._fired, []
        memory, self._memory = self._memory, None
        self._outbox.put(
            page.Frame(
                self.step / 50,
                round(world.x, _DIGITS),
                round(world.y, _DIGITS),
                round(world.theta, _DIGITS),
                round(world.v, _DIGITS),
                round(world.w, _DIGITS),
                bits.bumpers,
                bits.cliffs,
                bits.wheels,
                bits.buttons,
                world.leds[0],
                world.leds[1],
                fired,
                run=self.run,
                step=self.step,
                boxes=self._moved_boxes(),
                ghost=_drawn(world.ghost()),
                memory=memory,
            )
        )

    def telemetry(self, line: FrameLine) -> None:
        """A real robot as it says it is, unless the last frame was too recent."""
        if not self._frames.spend(1, self._now()):
            self.fired(line.fired)
            return
        self.step = int(line.time * 50)
        fired, self._fired = self._fired + line.fired, []
        self._outbox.put(
            page.Frame(
                line.time,
                line.x,
                line.y,
                line.theta,
                line.v,
                line.w,
                line.bumpers,
                line.cliffs,
                line.wheels,
                line.buttons,
                line.led1,
                line.led2,
                fired[-_MAX_FIRED:],
                run=self.run,
                step=self.step,
            )
        )

    def _moved_boxes(self) -> list[tuple[float, float, float]] | None:
        """Where the movable things are, when they are not where the page knows them."""
        if not self._world.room.movables:
            return None
        poses = self._world.room.poses()
        if poses == self._boxes:
            return None
        self._boxes = poses
        return [(round(x, _DIGITS), round(y, _DIGITS), round(theta, _DIGITS)) for x, y, theta in poses]


def _drawn(pose: tuple[float, float, float] | None) -> tuple[float, float, float] | None:
    return None if pose is None else (round(pose[0], _DIGITS), round(pose[1], _DIGITS), round(pose[2], _DIGITS))
