"""
Robot run: a program on a real robot that a page watches. The counterpart of ``run.simulated_run``.
"""

from __future__ import annotations

import socket
from collections.abc import Callable
from functools import partial
from pathlib import Path

import msgspec

from ..recordings.mcap_file import RunDetails
from ..recordings.recording_folder import PendingRecording
from ..run.page_run import OnObservedStep, PageRun, RunView
from ..run.problems import broken_link, died, lost_robot
from ..run.steps.command_conflicts import Action, CommandConflicts
from ..run.worker_session import RunServices
from ..wire import page
from ..wire.robot_process import CommandsLine, EndedLine, SentCommand, read_observed
from ..wire.topics import CHANNELS, TopicMessage
from ..wire.worker import Started
from ..worker.prepared_runs import PreparedRun
from ..world.events import Command
from ..world.time_step import STEPS_PER_SECOND
from .robot_parts import missing_parts_problem
from .robot_process import RobotProcess
from .run_recorder import RunRecorder

__all__ = ["RobotRun"]


class RobotRun(PageRun):
    """
    Ends by itself, by stop(), or at once by end_now(). A real robot has neither another speed nor a pause. Implements
    ``RunListener``.
    """

    def __init__(
        self,
        request: page.Run,
        robot_process: RobotProcess,
        services: RunServices,
        view: RunView,
        on_over: Callable[[PageRun], None],
        on_step: OnObservedStep,
        on_unobserved: Callable[[], None],
        observes: bool = False,
        prepared: PreparedRun | None = None,
        recorder: RunRecorder | None = None,
        robot_name: str = "",
        on_begun: Callable[[], None] = lambda: None,
        on_recorded: Callable[[int, Path], None] = lambda _, __: None,
    ) -> None:
        # Called with the number of the run and its recording, when that is made.
        self._on_recorded = on_recorded
        # Called when the program is about to drive the robot.
        self._on_begun = on_begun
        self._recorder = recorder
        self._details = RunDetails(request.source, robot_process.address, robot_name)
        # The recording of the run from its start on.
        self._recording: PendingRecording | None = None
        self._robot_process = robot_process
        self._commands_in_force = CommandConflicts()
        self._on_step = on_step
        # Called when the run begins or goes on without being observed: its steps without commands are not told then.
        self._on_unobserved = on_unobserved
        self._is_observed = False
        # Whether the program runs on the robot, or has run.
        self._has_begun = False
        self._on_finished = on_over
        self._observed = services.observed
        # Whether the next step that is told is the first of the run.
        self._is_first = observes
        self.observe(observes)
        super().__init__(request, services, view, self._finish, prepared)

    def stop(self) -> None:
        """Let the program end in good order; the wheels stop at once."""
        if self._session.is_compiling:
            self.end_now()
        else:
            self._robot_process.stop()

    def end_now(self) -> None:
        """End without waiting for anything; the page is told."""
        if self._session.is_compiling:
            self._session.cancel()
        else:
            self._robot_process.stop()
            self._session.kill()
        self._end("stopped", [])

    def set_speed(self, speed: page.Speed) -> None:
        """Not possible on a real robot."""

    def pause(self) -> None:
        """Not possible on a real robot."""

    def resume(self) -> None:
        """Not possible on a real robot."""

    def forward(self) -> None:
        """Not possible on a real robot."""

    def observe(self, on: bool) -> None:
        """Whether the firings are told with their provenance, from the next step on."""
        is_observed = on and self._observed.admit(self)
        if not is_observed:
            self._observed.runs.discard(self)
            self._is_first = False
        self._is_observed = is_observed
        self._robot_process.observe(is_observed)
        if self._has_begun and not is_observed:
            self._on_unobserved()

    def _finish(self, run: PageRun) -> None:
        self._observed.runs.discard(self)
        self._on_finished(run)

    # CompilationListener

    def on_started(self, link: socket.socket, started: Started) -> None:
        """The program runs, if the robot has what it uses."""
        missing = missing_parts_problem(self._robot_process.address, started.uses)
        if missing is not None:
            link.close()
            self._session.kill()
            self._end("error", [missing])
            return
        self._view.show_started(started.problems, started.branches)
        if self._recorder is not None:
            self._recording = self._recorder.begin(self._details)
        if self._recording is not None:
            self._robot_process.record(self._recording.log)
        self._on_begun()
        self._robot_process.run(link, self)
        self._has_begun = True
        if not self._is_observed:
            self._on_unobserved()

    # RunListener

    def on_commands(self, line: CommandsLine) -> None:
        """The program has done a step."""
        if self._is_over:
            return
        try:
            # A step may be told with its firings after the observation has ended.
            observed = read_observed(line) if self._is_observed else None
        except msgspec.ValidationError as error:
            self._robot_process.stop()
            self._session.kill()
            self._end("error", [broken_link(str(error), line.time)])
            return
        step = round(line.time * STEPS_PER_SECOND)
        actions = [_action(command) for command in line.commands]
        for conflict in self._commands_in_force.observe(step, line.fired, line.sent, actions):
            self._view.show_conflict(line.time, conflict)
        if observed is not None:
            self._view.add_firings(line.time, observed.firings)
            if observed.memory is not None:
                self._view.set_memory(observed.memory)
        commands = [action for action in actions if isinstance(action, Command)]
        is_first, self._is_first = self._is_first, False
        self._on_step(line.time, observed, commands, is_first=is_first, is_overridden=line.backing is True)

    def on_ended(self, line: EndedLine) -> None:
        """The program has ended."""
        self._finish_recording(line.how)
        if self._is_over:
            return
        if line.how == "stuck" or line.how == "died":
            self._end_silent(line.how, line.time)
            return
        self._session.kill()
        match line.how:
            case "done" | "stopped":
                self._end(line.how, [])
            case "error":
                self._end("error", [line.problem if line.problem is not None else died(None, line.time)])
            case "broken":
                self._end("error", [broken_link("", line.time)])
            case "lost":
                self._end("error", [lost_robot(line.time)])

    def on_lost(self) -> None:
        """The connection to the robot is lost."""
        self._finish_recording("lost")
        self._session.kill()
        self._end("error", [lost_robot(self._view.step / STEPS_PER_SECOND)])

    def _finish_recording(self, how: str) -> None:
        recording, self._recording = self._recording, None
        if recording is not None and self._recorder is not None:
            self._recorder.finish(recording, how, partial(self._on_recorded, self._run))


def _action(sent: SentCommand) -> Action:
    """What the simulator would have been told. It does not have every channel of every robot."""
    if sent.channel is not None and sent.channel in CHANNELS:
        return Command(sent.channel, tuple(sent.values))
    return TopicMessage(sent.channel or "", {})
