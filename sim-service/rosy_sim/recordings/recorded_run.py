"""
Playback of a recorded run for a page. The counterpart of ``run.simulated_run`` and ``ownership.robot_run``.

The recorded input is sent to the recorded program again, step by step and as fast as it answers. The page is shown the
recorded poses and channels of the robot, and the functions and firings that the program reports during playback. A
program is a function of its input (language rule R13), so these firings are those of the run. Its commands are compared
with the recorded ones; playback ends at the first difference.
"""

from __future__ import annotations

import asyncio
import math
import socket
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, Protocol

import msgspec

from ..run.page_run import OnObservedStep, PageRun, RunView
from ..run.problems import broken_link, died, too_much_output
from ..run.worker_session import RunServices
from ..sentences.sentence import Sentence, tr
from ..wire import page
from ..wire.firing import read_firings
from ..wire.line_splitter import LineSplitter, LineTooLong
from ..wire.link_messages import Ended, Ready, Settled
from ..wire.problem import Problem
from ..wire.robot_link import MAX_LINE, LimitExceeded, LinkError, Request, SimulatorLink, step_line
from ..wire.robot_process import ObservedStep
from ..wire.telemetry import Telemetry
from ..wire.topics import BadMessage, TopicMessage, read_command
from ..wire.worker import Started
from ..world.events import VELOCITY_CHANNEL, Command
from ..world.time_step import STEPS_PER_SECOND
from .link_log import publication
from .recording_stream import RecordingStream
from .replay import Exchange, ExchangeReader, difference_in, published
from .robot_state import RobotState

__all__ = ["MOST_FRAMES", "RecordedRun", "RecordedView"]

MOST_FRAMES = 20_000
"""Frames of a recording: seven minutes at 50 a second; a longer run has fewer per second. A page keeps twice as many of
all its runs."""

_CURVE = 1e-6
"""Rounding of velocities, (m/s)²."""

_MEMORY_STEPS = 5
"""Steps between two reports of the program's memory: 10 Hz, as on a robot."""


class _StepOp(msgspec.Struct):
    op: str
    time: float = 0.0
    memory: bool = False


_step = msgspec.json.Decoder(_StepOp)


@dataclass(slots=True)
class _Answer:
    """Answer of a program to a batch."""

    lines: list[bytes] = field(default_factory=list)
    commands: list[Command] = field(default_factory=list)
    # None when the program has died.
    end: Ready | Settled | Ended | None = None


class RecordedView(RunView, Protocol):
    """Page view of a recorded run. ``web.sessions.page_view`` implements it."""

    def show_recorded(self, telemetry: Telemetry) -> None:
        """Show a recorded state of the robot. No frame is left out."""

    def show_text(self, time: float, text: str) -> None:
        """Show a line on the console."""

    def play_sound(self, time: float, sound: int) -> None:
        """Show that a sound was played."""

    async def is_sent(self) -> None:
        """Wait until all messages to the page are sent."""


class RecordedRun(PageRun):
    """
    Ends by itself, by stop(), or at once by end_now().

    Args:
        run: its number.
        stream: open until ``over`` is set.
        services: of all runs.
        view: of this run alone.
        on_over: called once.
        on_step: records the firings.
        on_note: called with notes about the recording for its user.
    """

    def __init__(
        self,
        run: int,
        stream: RecordingStream,
        services: RunServices,
        view: RecordedView,
        on_over: Callable[[PageRun], None],
        on_step: OnObservedStep,
        on_note: Callable[[Sentence], None],
    ) -> None:
        self.over = asyncio.Event()
        self._stream = stream
        self._shown = view
        self._state = RobotState()
        self._on_step = on_step
        self._on_note = on_note
        self._on_finished = on_over
        self._steps_per_frame = max(1, math.ceil(stream.heading.seconds * STEPS_PER_SECOND / MOST_FRAMES))
        self._may_go_on = asyncio.Event()
        self._may_go_on.set()
        self._playback: asyncio.Task[None] | None = None
        self._link: socket.socket | None = None
        self._lines = LineSplitter(MAX_LINE)
        self._messages = SimulatorLink()
        # Lines of the program that no exchange has taken yet.
        self._unread: list[bytes] = []
        # Time of the current step, s.
        self._time = 0.0
        self._is_first = True
        # The velocity that the program wants, and whether the robot was told another one.
        self._wanted = (0.0, 0.0)
        self._is_overridden = False
        super().__init__(page.Run(run, stream.heading.details.program), services, view, self._finish)

    def stop(self) -> None:
        """End the playback."""
        self.end_now()

    def end_now(self) -> None:
        """End without waiting for anything; the page is told."""
        if self._session.is_compiling:
            self._session.cancel()
        elif self._playback is not None:
            self._playback.cancel()
            self._session.kill()
        self._end("stopped", [])

    def set_speed(self, speed: page.Speed) -> None:
        """Playback has one speed."""

    def pause(self) -> None:
        """Stop the playback."""
        self._may_go_on.clear()

    def resume(self) -> None:
        """Continue the playback."""
        self._may_go_on.set()

    def forward(self) -> None:
        """Playback has no single steps; the page shows past ones."""

    def _finish(self, run: PageRun) -> None:
        self.over.set()
        self._on_finished(run)

    # CompilationListener

    def on_started(self, link: socket.socket, started: Started) -> None:
        """The program runs, on no robot."""
        link.setblocking(False)
        self._link = link
        self._view.show_started(started.problems, started.branches)
        self._playback = asyncio.get_running_loop().create_task(self._play(link))

    # The playback

    async def _play(self, link: socket.socket) -> None:
        reader = ExchangeReader()
        try:
            async for line in self._stream.lines():
                exchange = reader.feed(line)
                if exchange is not None and not await self._repeat(exchange):
                    return
            last = reader.last()
            if last is not None and not await self._repeat(last):
                return
            self._tell_gaps()
            self._close("stopped")
        except LimitExceeded as error:
            self._fail(too_much_output(str(error), self._time))
        except (LinkError, LineTooLong) as error:
            self._fail(broken_link(str(error), self._time))
        finally:
            link.close()

    def _tell_gaps(self) -> None:
        heading = self._stream.heading
        if not (self._stream.is_whole and heading.is_complete):
            self._on_note(tr("The end of the run is not in the recording."))
        elif heading.left_out:
            self._on_note(
                tr(
                    "The disk was too slow for the recording; batches of lines that are missing: {n}.",
                    n=heading.left_out,
                )
            )

    async def _repeat(self, exchange: Exchange) -> bool:
        """Repeat a step; whether the run goes on after it."""
        await self._may_go_on.wait()
        self._time = exchange.time
        for line in exchange.batch:
            self._state.hear(line)
        # The last batch may have had no answer: the program was ended, or the robot was lost.
        if not exchange.end:
            self._show(exchange, is_last=True)
            return True
        try:
            async with asyncio.timeout(self._services.limits.settle):
                answer = await self._ask(exchange)
        except TimeoutError:
            self._end_silent("stuck", self._time)
            return False
        end = answer.end
        if end is None:
            self._end_silent("died", self._time)
            return False
        difference = difference_in(exchange.time, published(exchange.answer), published(answer.lines))
        if difference is not None:
            self._show(exchange, is_last=True)
            self._on_note(
                tr(
                    "After {time} s the program no longer sends the recorded commands. The run is shown until then.",
                    time=round(exchange.time, 2),
                )
            )
            self._close("stopped")
            return False
        if isinstance(end, Ended):
            self._record(exchange, end, answer.commands)
            self._show(exchange, is_last=True)
            self._tell_gaps()
            if end.how == "error":
                self._fail(end.problem if end.problem is not None else died(None, self._time))
            else:
                self._close(end.how)
            return False
        if isinstance(end, Settled):
            self._record(exchange, end, answer.commands)
            self._show(exchange, is_last=False)
        await self._shown.is_sent()
        return True

    async def _ask(self, exchange: Exchange) -> _Answer:
        """Send a batch, and wait for the answer."""
        assert self._link is not None
        loop = asyncio.get_running_loop()
        self._messages.step = exchange.step
        batch = [*exchange.batch[:-1], _observed(exchange.batch[-1], exchange.step)]
        answer = _Answer()
        try:
            await loop.sock_sendall(self._link, b"".join(line + b"\n" for line in batch))
            while True:
                while self._unread:
                    line = self._unread.pop(0)
                    answer.lines.append(line)
                    for message in self._messages.feed(line + b"\n"):
                        if isinstance(message, Command):
                            answer.commands.append(message)
                        elif not isinstance(message, TopicMessage | Request):
                            answer.end = message
                            return answer
                data = await loop.sock_recv(self._link, 65536)
                if not data:
                    return answer
                self._unread = self._lines.feed(data)
        except ConnectionError:
            return answer

    def _record(self, exchange: Exchange, done: Settled | Ended, commands: list[Command]) -> None:
        """Record a step for questions, and show what the program did in it."""
        for command in commands:
            self._state.obey(command)
            if command.channel == VELOCITY_CHANNEL:
                self._wanted = float(command.values[0]), float(command.values[1])
            elif command.channel == "Say":
                self._shown.show_text(self._time, str(command.values[0]))
            elif command.channel == "Sound":
                self._shown.play_sound(self._time, int(command.values[0]))
        self._follow(exchange.sent)
        firings = read_firings(done.firings)
        self._view.add_fired(done.fired)
        self._view.add_sensed(self._time, done.sensed)
        self._view.add_firings(self._time, firings)
        memory = done.memory if isinstance(done, Settled) else None
        if memory is not None:
            self._view.set_memory(memory)
        observed = ObservedStep(firings, done.sensed, memory)
        is_first, self._is_first = self._is_first, False
        self._on_step(self._time, observed, commands, is_first=is_first, is_overridden=self._is_overridden)

    def _follow(self, sent: list[bytes]) -> None:
        """
        Find out from the commands sent to the robot whether the safety rules override the program. Limits scale a
        velocity and keep its curve; another curve, or the opposite direction, comes from the safety rules.
        """
        for line in sent:
            command = _command(line)
            if command is not None and command.channel == VELOCITY_CHANNEL:
                (v, w), (wanted_v, wanted_w) = command.values, self._wanted
                v, w = float(v), float(w)
                is_same_curve = math.isclose(v * wanted_w, w * wanted_v, abs_tol=_CURVE)
                self._is_overridden = not (is_same_curve and v * wanted_v + w * wanted_w >= -_CURVE)

    def _show(self, exchange: Exchange, *, is_last: bool) -> None:
        step = exchange.step
        if step % self._steps_per_frame and not is_last:
            return
        state = self._state
        self._view.step = step
        self._shown.show_recorded(Telemetry(self._time, state.pose, state.channels(), [], []))

    # The end

    def _close(self, how: Literal["done", "stopped"]) -> None:
        self._session.kill()
        self._end(how, [])

    def _fail(self, found: Problem) -> None:
        self._session.kill()
        self._end("error", [found])


def _command(line: bytes) -> Command | None:
    """None for a message on a topic of the program's own."""
    found = publication(line)
    if found is None:
        return None
    try:
        return read_command(*found)
    except BadMessage:
        return None


def _observed(line: bytes, step: int) -> bytes:
    """The last line of a batch, which asks for the firings of the step if it is one."""
    op = _step.decode(line)
    if op.op != "step":
        return line
    return step_line(step, op.memory or step % _MEMORY_STEPS == 0, firings=True, time=op.time)[:-1]
