"""
Runs of one page, one at a time: of the simulated robot, of the page's real robot with its twin, and of recordings.

Starts them, ends them, and connects them with what the page is told about them: its view, explanations, the checks of a
lesson.
"""

from __future__ import annotations

import asyncio
import random
from dataclasses import replace

from ...errors import BadInput
from ...explain.why_not import RobotLimits
from ...ownership.robot_ownership import RobotOwnership
from ...ownership.robot_run import RobotRun
from ...recordings.recorded_run import RecordedRun
from ...recordings.recording_stream import RecordingStream
from ...robots import robot_in
from ...run.page_run import PageRun
from ...run.simulated_run import SimulatedRun
from ...run.step_display import Simulation
from ...run.steps.lockstep import Lockstep
from ...run.steps.replay import NO_REPLAY
from ...run.worker_session import RunServices
from ...sentences.sentence import Sentence, tr
from ...wire import page
from ...world.arena import Pose
from ...world.events import velocity
from .lesson_checks import LessonChecks
from .outbox import Outbox
from .page_preparation import PagePreparation
from .page_recordings import PageRecordings
from .page_twin import PageTwin
from .page_view import PageView
from .run_explanations import RunExplanations
from .safety_switch import SafetySwitch
from .simulator.room_building import BuiltRoom
from .simulator.simulated_robot import SimulatedRobot, default_room

__all__ = ["PageRuns"]

_random = random.SystemRandom()


class PageRuns:
    """
    Of one page.

    Args:
        services: of all runs.
        preparation: has the page's programs that are compiled already.
        outbox: of the page.
    """

    def __init__(self, services: RunServices, preparation: PagePreparation, outbox: Outbox) -> None:
        self._services = services
        self._preparation = preparation
        self._outbox = outbox
        self._now = asyncio.get_running_loop().time
        self.explanations = RunExplanations(outbox.put)
        room = default_room()
        self.view = PageView(outbox, room, services.frame_rate, self._now, self.explanations.on_branches)
        self.simulator = SimulatedRobot(self.view, room, lambda: self._run, self.refuse)
        # Holds for the simulator and for the real robot.
        self.safety = SafetySwitch(outbox.put, lambda: self.view.run)
        self.lesson = LessonChecks(outbox.put)
        # The same program in the simulator, beside the real robot.
        self.twin = PageTwin(services, outbox, self._now)
        # What the page may look at again.
        self.recordings = PageRecordings(outbox.put)
        # Whether the firings are recorded.
        self._observes = False
        # The current run, and those that are over but not explained yet.
        self._run: PageRun | None = None
        self._unexplained: list[PageRun] = []

    def refuse(self, message: Sentence, hint: Sentence | None = None) -> None:
        """Tell the page that its last message changed nothing."""
        self._outbox.put(page.refusal(message, hint))

    # Starts

    def start(self, request: page.Run, built: BuiltRoom, ownership: RobotOwnership) -> None:
        """Run a program: on the robot that the page owns, or else in the room."""
        self.view.run = request.run
        if ownership.process is not None:
            self._start_on_robot(request, built, ownership)
        else:
            self._start_simulated(request, built)

    def _start_on_robot(self, request: page.Run, built: BuiltRoom, ownership: RobotOwnership) -> None:
        assert ownership.process is not None
        self._prepare_twin(request, built, ownership)
        self.view.await_robot()
        self.explanations.start(request.run, request.source, ownership.limits)
        self._run = RobotRun(
            request,
            ownership.process,
            self._services,
            self.view,
            self._on_over,
            self.explanations.on_robot_step,
            self.explanations.on_robot_unobserved,
            self._observes,
            self._preparation.take(request.source),
            ownership.recorder,
            ownership.name,
            self._on_robot_begun,
            self.recordings.add,
        )

    def _prepare_twin(self, request: page.Run, built: BuiltRoom, ownership: RobotOwnership) -> None:
        """The real robot drives in the room of the page if a twin drives there beside it, and else from its origin."""
        if request.twin is None:
            self.view.origin = Pose(0.0, 0.0, 0.0)
            return
        self.view.origin = built.arena.start
        seed = _seed_of(request)
        robot = robot_in(built.arena)
        usual, most = robot.limits, ownership.limits
        # They are 0 until the robot process has told them.
        limits = replace(usual, speed=most.speed or usual.speed, angular_speed=most.turn or usual.angular_speed)
        room = built.with_robot(seed, replace(robot, limits=limits))
        self.twin.prepare(request, request.twin, room, seed)

    def _start_simulated(self, request: page.Run, built: BuiltRoom) -> None:
        limits = robot_in(built.arena).limits
        self.explanations.start(request.run, request.source, RobotLimits.of_motors(limits))
        robot, safety = self.simulator, self.safety
        if request.after is not None:
            try:
                recorded, replay = robot.hands.branch(request, request.after, safety.settings)
            except BadInput as error:
                self.refuse(error.sentence, tr("Press Run for a new run."))
                self.view.show_ended(request.run, "stopped", [])
                return
            seed, settings, companions = recorded.seed, recorded.safety, recorded.companions
            room = built.with_robots(seed, companions)
        else:
            seed, replay, settings = _seed_of(request), NO_REPLAY, safety.settings
            companions = tuple(request.companions)
            try:
                room = built.with_robots(seed, companions)
            except BadInput as error:
                self.refuse(error.sentence)
                self.view.show_ended(request.run, "stopped", [])
                return
            robot.hands.begin(seed, settings, request.run, companions)
        robot.begin_run(room)
        self.lesson.start(request.run, request.source, robot.world.arena)
        simulation = Simulation(
            robot.world,
            seed,
            robot.on_events,
            robot.on_message,
            settings,
            safety.report,
            self._on_step,
            self.lesson.on_over,
            self._observes,
            replay,
            companions,
        )
        prepared = self._preparation.take(request.source)
        self._run = SimulatedRun(request, simulation, self._services, self.view, self._on_over, prepared)

    def replay(self, request: page.Replay) -> None:
        """Look at a recorded run."""
        self.recordings.open(request, self._begin_replay, self._on_no_replay)

    def _begin_replay(self, request: page.Replay, stream: RecordingStream) -> RecordedRun:
        details = stream.heading.details
        self._outbox.put(page.ReplayBegun(request.run, details.program, details.name))
        explanations = self.explanations
        robot = self.simulator
        explanations.start(request.run, details.program, RobotLimits.of_motors(robot.world.robot.limits))
        view = PageView(self._outbox, robot.room, self._services.frame_rate, self._now, explanations.on_branches)
        view.run = request.run
        view.shows_firings = self.view.shows_firings
        view.origin = robot.world.arena.start if request.room else Pose(0.0, 0.0, 0.0)
        run = RecordedRun(
            request.run, stream, self._services, view, self._on_over, explanations.on_robot_step, self.refuse
        )
        self._run = run
        return run

    def _on_no_replay(self, run: int, why: Sentence) -> None:
        self.refuse(why)
        self.view.show_ended(run, "stopped", [])

    # While they run

    def control(self, request: page.Stop | page.SetSpeed | page.Pause | page.Resume | page.Forward) -> None:
        """Stop the run, or its clock."""
        run = self._run
        if run is None:
            if isinstance(request, page.Stop):
                self.recordings.cancel()
            return
        match request:
            case page.Stop():
                run.stop()
            case page.SetSpeed():
                run.set_speed(request.speed)
            case page.Pause():
                run.pause()
            case page.Resume():
                run.resume()
            case page.Forward():
                run.forward()

    def observe(self, request: page.Observe) -> None:
        """Whether firings are recorded and shown."""
        self._observes = request.on
        showed, shows = self.view.shows_firings, request.on and request.frames
        self.view.shows_firings = shows
        if isinstance(self._run, SimulatedRun | RobotRun):
            self._run.observe(request.on)
        self.twin.observe(request.on)
        simulated = self.simulator.run()
        if shows and not showed and not (simulated is not None and simulated.is_replaying):
            # A page that begins to show values in a run that stands still or is over has those of now, too.
            latest = self.explanations.latest_firings(self.view.run)
            for time, firing in latest:
                self.view.add_firings(time, [firing])
            if latest:
                self.view.show_frame(force=True)

    def answer(self, request: page.Why | page.WhyNot) -> None:
        """Explain something of a run."""
        is_twin = self.twin.explanations.knows(request.run)
        (self.twin.explanations if is_twin else self.explanations).answer(request)

    def on_checked(self, source: str, checked: page.Checked) -> None:
        """The compiler has answered about a program."""
        self._preparation.on_checked(source, checked.problems)
        self.lesson.on_checked(source, checked, self.simulator.world.arena)
        self.explanations.on_checked(source, checked)
        self.twin.explanations.on_checked(source, checked)

    def _on_robot_begun(self) -> None:
        self.view.begin_robot()
        self.twin.begin(self.safety.settings)

    def _on_step(self, lockstep: Lockstep) -> None:
        self.lesson.on_step(lockstep)
        self.explanations.on_step(lockstep)
        self.simulator.on_step(lockstep)

    # Ends

    def end_now(self) -> None:
        """End the current run at once; the page is told."""
        if self._run is not None:
            self._run.end_now()
        self.recordings.cancel()
        self.twin.end_now()
        self.simulator.world.command(velocity(0.0, 0.0))
        self.simulator.wake()

    def _on_over(self, run: PageRun) -> None:
        self._run = None
        if isinstance(run, RobotRun):
            self.view.end_robot()
            self.twin.finish(self.view.step)
        self._unexplained = [r for r in [*self._unexplained, run] if not r.is_explained]
        self.simulator.hands.after_step()
        self.simulator.wake()

    async def close(self) -> None:
        """End everything: the page is gone."""
        self.twin.close()
        await self.recordings.close()
        for run in self._unexplained:
            run.cancel_explanation()

    def free(self) -> None:
        """Drop what is large."""
        self._unexplained = []
        self.simulator.free()


def _seed_of(request: page.Run) -> int:
    return request.seed if request.seed is not None else _random.randrange(2**31)
