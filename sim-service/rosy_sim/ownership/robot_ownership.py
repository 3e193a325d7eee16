"""
Robot ownership of one page: whether the page may drive real robots, which one it owns, and what it is told about it.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Protocol

import msgspec

from ..config import Limits
from ..errors import BadInput
from ..explain.why_not import RobotLimits
from ..run.page_run import RunView
from ..run.steps.velocity_guard import SafetySettings
from ..sentences.sentence import Sentence, tr
from ..wire import page
from ..wire.problem import to_wire
from ..wire.robot_process import DriveSettingsLine, FrameLine, Line, LinkLine, SaidLine, SoundLine, StoppedLine
from .robot_process import RobotProcess
from .robot_registry import RobotRegistry
from .run_recorder import RunRecorder

__all__ = ["RobotOwnership", "RobotView", "SafetyView"]


class RobotView(RunView, Protocol):
    """Receives what a page is shown of a real robot. ``web.sessions.page_view`` implements it."""

    # The run number that frames carry; set by the owner.
    run: int

    def show_simulator(self) -> None:
        """Show the simulated robot in its room."""

    def hide_simulator(self) -> None:
        """Show no frames of the simulated robot."""

    def show_telemetry(self, line: FrameLine) -> None:
        """Show a real robot as it reports itself."""


class SafetyView(Protocol):
    """Receives the safety settings of the robot. ``web.sessions.safety_switch`` implements it."""

    def set(self, settings: SafetySettings) -> None:
        """How the robot is driven."""

    def report(self, overriding: bool, time: float) -> None:
        """Whether the safety rules override the program at ``time`` s of the run."""


class RobotOwnership:
    """Lives as long as the page's session; close() stops the robot. Implements ``RobotListener``."""

    def __init__(
        self,
        session: str,
        registry: RobotRegistry,
        limits: Limits,
        send: Callable[[page.Answer], None],
        view: RobotView,
        safety: SafetyView,
    ) -> None:
        self._session = session
        self._registry = registry
        self._limits = limits
        self._send = send
        self._view = view
        self._safety = safety
        self._locked = True
        # The robot that the page owns, and the page's last message about it; None while it owns none.
        self.process: RobotProcess | None = None
        self._state: page.RobotState | None = None
        # Robots that are being released.
        self._releases: set[asyncio.Task[None]] = set()

    @property
    def limits(self) -> RobotLimits:
        """The greatest speeds of the robot that the page owns."""
        assert self._state is not None
        return RobotLimits(self._state.max_speed, self._state.max_turn)

    @property
    def recorder(self) -> RunRecorder | None:
        """Records the runs on the robot; None if they are not to be recorded."""
        return self._registry.recorder

    @property
    def name(self) -> str:
        """What pages call the robot that the page owns."""
        return self._state.name if self._state is not None else ""

    def send_robots(self) -> None:
        """Tell the page which robots there are, if there are any."""
        if self._registry:
            robots = [] if self._locked else self._registry.robots_for(self._session)
            self._send(page.Robots(self._locked, robots, self._registry.discovers))

    def unlock(self, code: str, address: str) -> None:
        """
        Let the page at a client address choose robots.

        Raises:
            BadInput: the code is wrong, or the page or its address has tried too many.
        """
        accepted = self._registry.accepts_code(code, self._session, address)
        if accepted is None:
            raise BadInput(tr("Too many wrong codes came from here. Wait ten seconds, and try again."))
        if not accepted:
            raise BadInput(tr("This is not the code of the robots; it is printed where Rosy was started."))
        self._locked = False
        self.send_robots()

    def acquire(self, request: page.Take) -> None:
        """
        Own a robot; one that the page owned before is released.

        Raises:
            BadInput: the robot is not available.
        """
        if self._locked:
            raise BadInput(tr("The robots are locked; ask the person who started Rosy for their code."))
        executable = self._registry.executable
        if executable is None:
            raise BadInput(
                tr("The part of Rosy that speaks to robots is not built yet; ./rosy start --robot builds it.")
            )
        address = self._registry.acquire(request.robot, self._session, request.who)
        self.release()
        self._view.hide_simulator()
        self._view.run = request.run
        self._state = page.RobotState(request.robot, "connecting", "", False, 0.0, 0.0)
        self._send(self._state)
        self.process = RobotProcess(executable, address, self._limits, self)

    def release(self) -> None:
        """Stop the robot; other pages may own it as soon as it has stopped."""
        process, self.process = self.process, None
        state = self._clear_state()
        if process is not None and state is not None:
            task = asyncio.get_running_loop().create_task(self._end_process(process, state.name))
            self._releases.add(task)
            task.add_done_callback(self._releases.discard)

    async def close(self) -> None:
        """Release the robot; returns when it has been told to stop."""
        self.release()
        if self._releases:
            await asyncio.wait(self._releases)

    async def _end_process(self, process: RobotProcess, name: str) -> None:
        await process.close()
        self._registry.release(name, self._session)

    def _clear_state(self, why: Sentence | None = None) -> page.RobotState | None:
        """Tell the page that it owns no robot any more; returns the last state of the one it had."""
        state, self._state = self._state, None
        if state is not None:
            said, sentence = ("", None) if why is None else (str(why), to_wire(why))
            self._send(msgspec.structs.replace(state, link="gone", why=said, sentence=sentence, stopped=False))
            self._safety.report(False, 0.0)
            self._view.show_simulator()
        return state

    # RobotListener

    def on_line(self, line: Line) -> None:
        """A line of rosy-robot."""
        state, view = self._state, self._view
        if state is None:
            return
        match line:
            case DriveSettingsLine(safety, max_speed, max_turn):
                self._safety.set(SafetySettings(safety, max_speed, max_turn))
                self._update(max_speed=max_speed, max_turn=max_turn)
            case LinkLine(link, why, sentence):
                self._update(link=link, why=why, sentence=sentence)
            case StoppedLine(stopped):
                self._update(stopped=stopped)
            case FrameLine():
                self._safety.report(line.backing, line.time)
                view.show_telemetry(line)
            case SaidLine(time, text):
                view.show_output(time, [text], [])
            case SoundLine(time, sound):
                view.show_output(time, [], [sound])

    def _update(self, **changes: object) -> None:
        """Tell the page what has changed about its robot."""
        assert self._state is not None
        before, self._state = self._state, msgspec.structs.replace(self._state, **changes)
        if self._state != before:
            self._send(self._state)

    def on_gone(self) -> None:
        """rosy-robot has ended by itself."""
        self.process = None
        state = self._clear_state(tr("The part of Rosy that speaks to the robot has ended."))
        if state is not None:
            self._registry.release(state.name, self._session)
