"""
Page view: what one page is shown of its robot, as messages in its outbox: frames, output, goals, and the state of runs.

Frames and output are limited to what a page can show, so a program that prints without end costs bounded memory.
Implements ``RunView`` and ``RobotView``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import zip_longest
from typing import Any, Literal

from ...run.frame_rate import FrameRate
from ...run.page_run import Ended
from ...run.steps.command_conflicts import CommandConflict
from ...token_bucket import TokenBucket
from ...wire import page
from ...wire.firing import Branch, Firing
from ...wire.link_messages import MemoryValue
from ...wire.problem import Problem
from ...wire.robot_process import FrameLine
from ...wire.telemetry import PoseShown, Shown, Telemetry
from ...world.arena import Pose
from ...world.goals import GoalState
from ...world.time_step import STEPS_PER_SECOND
from ...world.world import World
from .outbox import Outbox

__all__ = ["PageView", "Room"]

_MAX_FIRED = 200
"""Firings in one frame; the latest ones."""

_MAX_FIRINGS = 100
"""Firings with their provenance in one frame; the latest ones. A page shows the latest of each function."""

_MAX_SENSED = 50
"""Events told in one frame; the latest ones."""

_DIGITS = 5
"""Digits after the point of what is drawn, m and rad: a hundredth of a millimetre. All would double the bytes."""

_MAX_TEXT = 10_000
"""Characters of one `Say` that reach the page."""

_MAX_SOUNDS = 10
"""Sounds of one step that reach the page."""

_OUTPUT_RATE, _OUTPUT_BURST = 100.0, 300.0
"""Texts and sounds that reach the page, a second and at once."""

_BACKGROUND_RATE = 20.0
"""Frames per second of a page without the focus, which is beside the window in which its user works."""

_FRAME_BURST = 3.0
"""Frames that may go out at once, so that a step that is late gets one too."""


@dataclass(frozen=True, slots=True)
class Room:
    """The world's JSON, for the page to draw, and the world made from it."""

    json: Any
    world: World


class PageView:
    """
    Puts answers into a page's outbox.

    Args:
        frame_rate: that of the service.
        now: a clock in s that only goes forward.
    """

    def __init__(
        self,
        outbox: Outbox,
        room: Room,
        frame_rate: FrameRate,
        now: Callable[[], float],
        on_branches: Callable[[list[Branch]], None] = lambda _: None,
    ) -> None:
        self._outbox = outbox
        # Called with the branches of a program that begins to run.
        self._on_branches = on_branches
        self._now = now
        self._room = room
        self._shows_simulator = True
        # The run number on all messages, and the run's latest step.
        self.run = 0
        self.step = 0
        # Where the odometry of a real robot begins, in the room that the page draws: m, m, rad.
        self.origin = Pose(0.0, 0.0, 0.0)
        # Since when frames of a real robot may be those of this run, on the clock: those of the run before are later in
        # their run than that.
        self._robot_began = -math.inf
        # What the page was last told: poses of the movable things, and goals.
        self._boxes: list[tuple[float, float, float]] = []
        self._others: list[tuple[float, float, float]] = []
        self._goals: list[page.Goal] = []
        self._output_limit = TokenBucket(_OUTPUT_RATE, _OUTPUT_BURST, now())
        self._frame_rate = frame_rate
        # Frames a second that the page wants, and those of the service as far as it may have them.
        self._wanted_rate = math.inf
        self._frame_limit = TokenBucket(frame_rate.at(now()), _FRAME_BURST, now())
        # A hidden page gets the frames that show a change of its run's state only.
        self._is_hidden = False
        # For the next frame: functions that have fired, and the memory if it has changed.
        self._fired: list[str] = []
        # Events, each with its time, s.
        self._sensed: list[tuple[str, float]] = []
        # What the page was last told of each channel; empty when the next frame has to tell all.
        self._channels: dict[str, Shown] = {}
        self._channels_run = -1
        # The same before it was rounded, of the simulated robot.
        self._values: dict[str, tuple[float | int | str, ...]] = {}
        # The parts of the world's channels in the last frame: what is the same object is not compared.
        self._parts: list[Mapping[str, tuple[float | int | str, ...]]] = []
        self._memory: list[MemoryValue] | None = None
        # For the next frame: firings with their provenance, if the page asks for them.
        self._firings: list[page.FiringShown] = []
        self.shows_firings = False

    # The room

    def show_room(self, room: Room) -> None:
        """Show another room, as it is before a run."""
        self.reset(room)
        self._send_room()

    def reset(self, room: Room) -> None:
        """Show the same room as it is before a run; the page has it already."""
        self._room = room
        self._boxes = []
        self._others = []
        self._goals = []
        self._fired = []
        self._sensed = []
        self._forget_channels()
        self._memory = None
        self._firings = []
        self.step = 0

    def show_simulator(self) -> None:
        """Show the simulated robot in its room."""
        self._shows_simulator = True
        self._send_room()

    def _send_room(self) -> None:
        self._outbox.put(page.WorldShown(self._room.json))
        self.show_frame(force=True)

    def hide_simulator(self) -> None:
        """Show no frames of the simulated robot."""
        self._shows_simulator = False
        self.origin = Pose(0.0, 0.0, 0.0)
        self._robot_began = -math.inf

    def _forget_channels(self) -> None:
        """The next frame tells all."""
        self._channels = {}
        self._values = {}
        self._parts = []

    # States of runs

    def show_state(self, state: Literal["compiling", "running"], problems: list[Problem] | None = None) -> None:
        """Show where the run is."""
        self._outbox.put(page.RunState(self.run, state, problems or []))

    def show_started(self, problems: list[Problem], branches: list[Branch]) -> None:
        """Show that the program begins to run, with its warnings and branches."""
        self._on_branches(branches)
        self._outbox.put(page.RunState(self.run, "running", problems, branches=branches))

    def show_queued(self, place: int) -> None:
        """Show the position in the run queue."""
        self._outbox.put(page.RunState(self.run, "queued", [], place=place))

    def show_ended(self, run: int, ended: Ended, problems: list[Problem]) -> None:
        """Show that a run, which need not be the latest, has ended."""
        self._outbox.put(page.RunState(run, "ended", problems, ended))

    # What a run does

    def add_fired(self, names: list[str]) -> None:
        """Show these functions with the next frame."""
        if names:
            self._fired = (self._fired + names)[-_MAX_FIRED:]

    def add_sensed(self, time: float, texts: list[str]) -> None:
        """Show the events that the program sensed at a time, s, with the next frame."""
        if texts:
            self._sensed = (self._sensed + [(text, time) for text in texts])[-_MAX_SENSED:]

    def add_firings(self, time: float, firings: list[Firing]) -> None:
        """Show these firings of a step with the next frame, if the page asks for them."""
        if not self.shows_firings:
            return
        shown = [page.firing_shown(firing, time) for firing in firings[-_MAX_FIRINGS:]]
        self._firings = (self._firings + shown)[-_MAX_FIRINGS:]

    def set_memory(self, values: list[MemoryValue]) -> None:
        """Show what the program remembers with the next frame."""
        self._memory = values

    def show_conflict(self, time: float, conflict: CommandConflict) -> None:
        """Show that functions override each other's commands."""
        self._outbox.put(page.ConflictShown(self.run, time, conflict.channel, conflict.winner, conflict.loser))

    def show_blocked(self, time: float, has_bumped: bool) -> None:
        """Show that the robot pushes against something and does not move."""
        self._outbox.put(page.Blocked(self.run, time, has_bumped))

    def show_divergence(self, time: float) -> None:
        """Show when the program began to differ from the run that it repeats."""
        self._outbox.put(page.Diverged(self.run, time))

    def show_uncompared(self, time: float) -> None:
        """Show since when it is not known whether the program differs from the run that it repeats."""
        self._outbox.put(page.Uncompared(self.run, time))

    def show_output(self, time: float, texts: list[str], sounds: list[int]) -> None:
        """Show the texts and play the sounds of a step, as far as the limit allows."""
        for text in texts:
            if self._output_limit.spend(1, self._now()):
                self.show_text(time, text[:_MAX_TEXT])
        for sound in sounds[:_MAX_SOUNDS]:
            if self._output_limit.spend(1, self._now()):
                self.play_sound(time, sound)

    def show_text(self, time: float, text: str) -> None:
        """Show a line on the console."""
        self._outbox.put(page.Said(time, text, run=self.run))

    def play_sound(self, time: float, sound: int) -> None:
        """Play a sound."""
        self._outbox.put(page.SoundPlayed(time, sound, run=self.run))

    def show_companion_said(self, robot: int, time: float, texts: list[str], sounds: list[int]) -> None:
        """Show the texts and play the sounds of another robot, as far as the limit allows."""
        for text in texts:
            if self._output_limit.spend(1, self._now()):
                self._outbox.put(page.CompanionSaid(time, text[:_MAX_TEXT], run=self.run, robot=robot))
        for sound in sounds[:_MAX_SOUNDS]:
            if self._output_limit.spend(1, self._now()):
                self.play_sound(time, sound)

    def show_companion_ended(self, robot: int, time: float, problem: Problem | None) -> None:
        """Show that the program of another robot has ended before the run."""
        self._outbox.put(page.CompanionEnded(self.run, robot, time, problem))

    def show_goals(self, states: list[GoalState]) -> None:
        """Show the goals if they have changed visibly."""
        goals = [page.Goal(s.kind, s.title, s.state, round(s.progress, 2), s.time) for s in states]
        if goals != self._goals:
            self._goals = goals
            self._outbox.put(page.GoalsShown(self.run, goals))

    # Frames

    def set_visibility(self, visible: page.Visible) -> None:
        """How much of the page is seen: it decides how many frames it gets."""
        was_hidden, self._is_hidden = self._is_hidden, visible == "hidden"
        self._wanted_rate = math.inf if visible == "focused" else _BACKGROUND_RATE
        if was_hidden and not self._is_hidden:
            self.show_frame(force=True)

    def _may_show_frame(self) -> bool:
        if self._is_hidden:
            return False
        now = self._now()
        self._frame_limit.rate = min(self._wanted_rate, self._frame_rate.at(now))
        return self._frame_limit.spend(1, now)

    def show_frame(self, force: bool = False) -> None:
        """Show the simulated robot as it is now, unless the last frame was too recent."""
        if not self._shows_simulator:
            return
        if not force and not self._may_show_frame():
            return
        world = self._room.world
        pose = PoseShown(round(world.x, _DIGITS), round(world.y, _DIGITS), round(world.theta, _DIGITS))
        self._put_frame(
            self.step / STEPS_PER_SECOND,
            pose,
            self._changed_channels(world),
            boxes=self._moved_boxes(),
            others=self._moved_others(),
            ghost=_rounded(world.ghost()),
            **self._observations(),
        )

    def snapshot(self) -> page.Frame:
        """A frame with all that is drawn of the simulated robot, for others than the page."""
        world = self._room.world
        boxes = [_digits(pose) for pose in world.obstacles.poses()]
        others = [_digits((other.x, other.y, other.theta)) for other in world.others]
        return page.Frame(
            self.step / STEPS_PER_SECOND,
            PoseShown(round(world.x, _DIGITS), round(world.y, _DIGITS), round(world.theta, _DIGITS)),
            {
                name: [round(v, _DIGITS) if isinstance(v, float) else v for v in values]
                for name, values in world.channels().items()
            },
            [],
            [],
            run=self.run,
            step=self.step,
            boxes=boxes or None,
            others=others or None,
        )

    def show_telemetry(self, line: FrameLine) -> None:
        """Show a real robot as it reports itself, unless the last frame was too recent."""
        if line.time > self._now() - self._robot_began:
            return
        self.add_fired(line.fired)
        self.add_sensed(line.time, line.sensed)
        if not self._may_show_frame():
            return
        self.step = int(line.time * STEPS_PER_SECOND)
        self._begin_run()
        # The next frame of the simulated robot is compared with this one.
        self._values = {}
        self._parts = []
        self._put_frame(line.time, _placed(line.pose, self.origin), line.channels, **self._observations())

    def show_recorded(self, telemetry: Telemetry) -> None:
        """Show a robot as it was in a step of a recorded run. No frame is left out."""
        self._begin_run()
        self._put_frame(
            telemetry.time, _placed(telemetry.pose, self.origin), telemetry.channels, **self._observations()
        )

    async def is_sent(self) -> None:
        """Return when the page has been sent all that it was shown."""
        await self._outbox.is_sent()

    def await_robot(self) -> None:
        """A run on a real robot is about to begin: what the robot reports until then is not part of it."""
        self._robot_began = math.inf
        self.step = 0

    def begin_robot(self) -> None:
        """The program is told to drive the robot, whose clock and way begin anew then."""
        self._robot_began = self._now()

    def end_robot(self) -> None:
        """The run is over, or never began: all that the robot reports is shown."""
        self._robot_began = -math.inf

    def _begin_run(self) -> None:
        """The first frame of a run tells all."""
        if self._channels_run != self.run:
            self._channels_run = self.run
            self._forget_channels()

    def _changed_channels(self, world: World) -> dict[str, Shown]:
        """What the channels say, as far as it may differ from what the page was last told."""
        self._begin_run()
        changed: dict[str, Shown] = {}
        before = self._values
        parts = world.channel_parts()
        for part, told in zip_longest(parts, self._parts[: len(parts)]):
            if part is told:
                continue
            for name, values in part.items():
                if before.get(name) != values:
                    before[name] = values
                    changed[name] = [round(v, _DIGITS) if isinstance(v, float) else v for v in values]
        self._parts = parts
        return changed

    def _observations(self) -> dict[str, Any]:
        """Memory and firings that wait for a frame."""
        memory, self._memory = self._memory, None
        firings, self._firings = self._firings, []
        return {"memory": memory, "firings": firings or None}

    def _put_frame(self, time: float, pose: PoseShown, channels: dict[str, Shown], **more: Any) -> None:
        """Send a frame with the channels that differ from the last frame."""
        news = {name: values for name, values in channels.items() if self._channels.get(name) != values}
        self._channels.update(news)
        fired, self._fired = self._fired, []
        sensed, self._sensed = self._sensed, []
        more["times"] = [at for _, at in sensed] or None
        texts = [text for text, _ in sensed]
        self._outbox.put(page.Frame(time, pose, news, fired, texts, run=self.run, step=self.step, **more))

    def _moved_boxes(self) -> list[tuple[float, float, float]] | None:
        """Poses of the movable things if they differ from those that the page was told last."""
        obstacles = self._room.world.obstacles
        if not obstacles.movables:
            return None
        poses = obstacles.poses()
        if poses == self._boxes:
            return None
        self._boxes = poses
        return [_digits(pose) for pose in poses]

    def _moved_others(self) -> list[tuple[float, float, float]] | None:
        """Poses of the other robots if they differ from those that the page was told last."""
        poses = [(other.x, other.y, other.theta) for other in self._room.world.others]
        if poses == self._others:
            return None
        self._others = poses
        return [_digits(pose) for pose in poses]


def _placed(pose: PoseShown, origin: Pose) -> PoseShown:
    """A pose of the odometry in the room where the odometry begins at ``origin``."""
    if origin == Pose(0.0, 0.0, 0.0):
        return pose
    c, s = math.cos(origin.theta), math.sin(origin.theta)
    x, y = origin.x + c * pose.x - s * pose.y, origin.y + s * pose.x + c * pose.y
    return PoseShown(round(x, _DIGITS), round(y, _DIGITS), round(origin.theta + pose.theta, _DIGITS))


def _rounded(pose: tuple[float, float, float] | None) -> tuple[float, float, float] | None:
    return None if pose is None else _digits(pose)


def _digits(pose: tuple[float, float, float]) -> tuple[float, float, float]:
    return round(pose[0], _DIGITS), round(pose[1], _DIGITS), round(pose[2], _DIGITS)
