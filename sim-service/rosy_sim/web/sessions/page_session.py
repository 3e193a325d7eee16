"""
Page session: one connected page, its room, its run and its requests. Turns requests into runs and events into answers.

Everything happens on the event loop: a message is served in a turn of the page (``loop_scheduler.py``), and the room
that it asks for is built in several. Compilations and checks are tasks. The page's socket belongs to ``app``.
"""

from __future__ import annotations

import asyncio
import random
from dataclasses import replace
from functools import partial

import msgspec

from ...errors import BadInput
from ...ownership.robot_ownership import RobotOwnership
from ...ownership.robot_registry import RobotRegistry
from ...ownership.robot_run import RobotRun
from ...previews.preview_pool import PreviewPool
from ...recordings.recorded_run import RecordedRun
from ...recordings.recording_stream import RecordingStream
from ...robots import DEFAULT_ROBOT
from ...run.page_run import PageRun
from ...run.simulated_run import SimulatedRun, Simulation
from ...run.steps.lockstep import Lockstep
from ...run.steps.replay import NO_REPLAY
from ...run.steps.velocity_guard import SafetySettings
from ...run.worker_session import RunServices
from ...sentence import Sentence, tr, verbatim
from ...wire import page
from ...wire.topics import BadMessage, TopicMessage
from ...wire.user_input import published, user_actions
from ...worker.prepared_runs import PreparedRuns
from ...world.arena import Pose
from ...world.events import Command, Reading, velocity
from ...world.time_step import STEPS_PER_SECOND
from ...world.world import ActionRefused, World
from ...worlds.gallery import DEFAULT_WORLD, named_world, usable_world
from ..pacing.loop_scheduler import PageTurns
from .idle_simulation import IdleSimulation
from .lesson_checks import LessonChecks
from .outbox import Outbox
from .page_hands import PageHands
from .page_preparation import PagePreparation
from .page_previews import PagePreviews
from .page_recordings import PageRecordings
from .page_twin import PageTwin
from .page_view import PageView, Room
from .program_checks import ProgramChecks
from .room_building import BuiltRoom, build_room, rebuild_room
from .ros_bridge import RosBridge, RosClient
from .run_explanations import RunExplanations
from .safety_switch import SafetySwitch

__all__ = ["PageSession"]

_random = random.SystemRandom()


class PageSession:
    """Lives as long as its page is connected; close() ends everything it started."""

    def __init__(
        self,
        ident: str,
        services: RunServices,
        robots: RobotRegistry,
        previews: PreviewPool,
        prepared: PreparedRuns,
        turns: PageTurns,
        in_class: bool = False,
        address: str = "",
    ) -> None:
        self.id = ident
        self._turns = turns
        # The client's.
        self._address = address
        self._services = services
        self._limits = services.limits
        self._loop = asyncio.get_running_loop()
        self.outbox = Outbox(self._limits.page_queue)
        self._room = _default_room()
        self._explanations = RunExplanations(self.outbox.put)
        self._view = PageView(
            self.outbox, self._room, self._limits.frame_rate, self._loop.time, self._explanations.on_branches
        )
        self._checks = ProgramChecks(services.worker, services.scheduler, self.outbox, self._on_checked, address)
        self._preparation = PagePreparation(prepared)
        self._lesson = LessonChecks(self.outbox.put)
        self._previews = PagePreviews(previews, self.outbox.put, self._loop.time)
        self._hands = PageHands(self._simulated_run)
        # Holds for the simulator and for the real robot.
        self._safety = SafetySwitch(self.outbox.put, lambda: self._view.run)
        # The real robot that this page owns, if any.
        self.ownership = RobotOwnership(ident, robots, self._limits, self.outbox.put, self._view, self._safety)
        # The same program in the simulator, beside that robot.
        self._twin = PageTwin(services, self.outbox, self._loop.time)
        # What the page may look at again.
        self.recordings = PageRecordings(self.outbox.put)
        # ROS clients of the simulated robot.
        self.bridge = RosBridge()
        # Whether the firings of the page's runs are recorded.
        self._observes = False
        # Steps since the session began, with and without programs.
        self._steps = 0
        self._idle = IdleSimulation(self.bridge, self._view, self._on_events)
        # The current run, and those that are over but not explained yet.
        self._run: PageRun | None = None
        self._unexplained: list[PageRun] = []
        # Set by close(): nothing may start any more.
        self.closed = asyncio.Event()
        self.outbox.put(page.Hello(session=self.id, in_class=True if in_class else msgspec.UNSET))
        self.outbox.put(page.WorkerState(services.worker.state))
        self._view.show_room(self._room)
        self.ownership.send_robots()

    @property
    def safety(self) -> SafetySettings:
        """The safety rules of the page's simulated robot."""
        return self._safety.settings

    @property
    def world(self) -> World:
        """The simulated robot in its room."""
        return self._room.world

    @property
    def room_json(self) -> object:
        """The room as JSON: another object after each change."""
        return self._room.json

    def snapshot(self) -> page.Frame:
        """The simulated robot as it is now, for others than the page."""
        return self._view.snapshot()

    # Requests

    async def receive(self, text: str | bytes) -> None:
        """Serve one message of the page, or refuse it. There is one at a time."""
        try:
            async with self._turns.turn(len(text)):
                request = page.read_request(text)
                if not isinstance(request, page.ChooseWorld | page.Reset | page.Run):
                    self._serve(request)
                    return
            if isinstance(request, page.ChooseWorld):
                built = await build_room(request.world, self._turns)
            else:
                built = await rebuild_room(self._room, self._turns)
            async with self._turns.turn():
                if not self.closed.is_set():
                    self._serve_with_room(request, built)
        except page.BadRequest as error:
            # The hint is for developers.
            self.refuse(tr("The page sent something Rosy does not understand."), verbatim(str(error)))
        except (BadInput, ActionRefused) as error:
            self.refuse(error.sentence)
        except BadMessage as error:
            self.refuse(tr("This message cannot be published."), error.sentence)

    def refuse(self, message: Sentence, hint: Sentence | None = None) -> None:
        """Tell the page that its last message changed nothing."""
        self.outbox.put(page.refusal(message, hint))

    def _serve_with_room(self, request: page.ChooseWorld | page.Reset | page.Run, built: BuiltRoom) -> None:
        match request:
            case page.ChooseWorld():
                self._choose_world(built.with_robot())
            case page.Reset():
                self._end_now()
                self._forget_run()
                self._reset_world(built.with_robot())
                self._view.show_room(self._room)
            case page.Run():
                self._start(request, built)

    def _serve(self, request: page.Request) -> None:
        match request:
            case page.Check():
                if self._is_short_enough(request.source):
                    self._preparation.on_edited(request.source)
                    self._checks.check(request)
            case page.Complete():
                self._checks.complete(request)
            case page.Preview():
                self._preview(request)
            case page.ChooseLessonStep():
                self._lesson.choose(request.step, self.world.arena)
            case page.Input():
                self._hands.between_steps(lambda: self._serve_input(request))
            case page.Replay():
                self._replay(request)
            case page.Observe():
                self._observe(request)
            case page.Visibility():
                self._view.set_visibility(request.state)
            case page.Why() | page.WhyNot():
                is_twin = self._twin.explanations.knows(request.run)
                (self._twin.explanations if is_twin else self._explanations).answer(request)
            case page.Unlock():
                self.ownership.unlock(request.code, self._address)
            case page.Take():
                self._end_now()
                self.ownership.acquire(request)
            case page.Leave():
                self._end_now()
                self.ownership.release()
            case page.SwitchSafety():
                self._hands.between_steps(lambda: self._switch_safety(request.on))
            case page.EmergencyStop() | page.Free() | page.Alive():
                self._tell_robot(request)
            case page.Stop() | page.SetSpeed() | page.Pause() | page.Resume() | page.Forward():
                if self._run is not None:
                    _control(self._run, request)
                elif isinstance(request, page.Stop):
                    self.recordings.cancel()

    def _tell_robot(self, request: page.EmergencyStop | page.Free | page.Alive) -> None:
        robot = self.ownership.process
        if robot is None:
            return
        match request:
            case page.EmergencyStop():
                robot.emergency_stop()
            case page.Free():
                robot.free()
            case page.Alive():
                robot.alive()

    def _switch_safety(self, on: bool) -> None:
        robot = self.ownership.process
        if robot is not None:
            robot.switch_safety(on)
            self._twin.switch_safety(replace(self._safety.settings, on=on))
            return
        self._safety.set(replace(self._safety.settings, on=on))
        self._hands.record_safety(self._safety.settings)

    def _serve_input(self, request: page.Input) -> None:
        """Serve an input that may have waited for the end of a step."""
        try:
            self._apply(request)
        except ActionRefused as error:
            self.refuse(error.sentence)
        except BadMessage as error:
            self.refuse(tr("This message cannot be published."), error.sentence)

    def _apply(self, request: page.Input) -> None:
        for action in user_actions(request):
            self.world.apply(action)
            self._hands.record(action)
        for message in published(request):
            self._publish(message)
        self._view.show_frame(force=True)
        self._wake_idle()

    def _choose_world(self, room: Room) -> None:
        self._end_now()
        self._forget_run()
        self._hands.forget_room()
        self._room = room
        self._view.show_room(room)

    def _reset_world(self, room: Room) -> None:
        self._room = room
        self._view.reset(room)

    def _is_short_enough(self, source: str) -> bool:
        if len(source) <= self._limits.source:
            return True
        self.refuse(
            tr("This program is too long."),
            tr("A program can have at most {most} characters.", most=self._limits.source),
        )
        return False

    # Previews

    def _forget_run(self) -> None:
        """The last run is no longer what previews repeat."""
        self._previews.cancel()
        self._hands.begin(0, self._safety.settings)

    def _preview(self, request: page.Preview) -> None:
        # A real robot has neither this room nor a simulator's path.
        if self.ownership.process is not None or not self._is_short_enough(request.source):
            return
        if not self._hands.is_complete:
            self._previews.cancel()
            self.outbox.put(page.Previewed(request.id, "unrepeatable", 0.0, (0.0, 0.0, 0.0), [], [], [], []))
            return
        self._previews.request(self._hands.preview_task(request, self._room.json))

    # Runs

    def _start(self, request: page.Run, built: BuiltRoom) -> None:
        self._end_now()
        if not self._is_short_enough(request.source):
            return
        self._view.run = request.run
        robot = self.ownership.process
        if robot is not None:
            self._prepare_twin(request, built)
            self._view.await_robot()
            self._explanations.start(request.run, request.source, self.ownership.limits)
            self._run = RobotRun(
                request,
                robot,
                self._services,
                self._view,
                self._on_run_over,
                self._explanations.on_robot_step,
                self._explanations.on_robot_unobserved,
                self._observes,
                self._preparation.take(request.source),
                self.ownership.recorder,
                self.ownership.name,
                self._on_robot_begun,
                self.recordings.add,
            )
            return
        self._explanations.start(request.run, request.source)
        lesson, safety = self._lesson, self._safety
        if request.after is not None:
            try:
                recorded, replay = self._hands.branch(request, request.after, safety.settings)
            except BadInput as error:
                self.refuse(error.sentence, tr("Press Run for a new run."))
                self._view.show_ended(request.run, "stopped", [])
                return
            seed, settings = recorded.seed, recorded.safety
        else:
            seed = request.seed if request.seed is not None else _random.randrange(2**31)
            replay, settings = NO_REPLAY, safety.settings
            self._hands.begin(seed, settings, request.run)
        self._reset_world(built.with_robot(seed))
        self._idle.pause()
        lesson.start(request.run, request.source, self.world.arena)
        simulation = Simulation(
            self.world,
            seed,
            self._on_events,
            self._on_message,
            settings,
            safety.report,
            self._on_step,
            lesson.on_over,
            self._observes,
            replay,
        )
        self._run = SimulatedRun(
            request,
            simulation,
            self._services,
            self._view,
            self._on_run_over,
            self._preparation.take(request.source),
        )

    def _prepare_twin(self, request: page.Run, built: BuiltRoom) -> None:
        """The real robot drives in the room of the page if a twin drives there beside it, and else from its origin."""
        if request.twin is None:
            self._view.origin = Pose(0.0, 0.0, 0.0)
            return
        self._view.origin = built.arena.start
        seed = request.seed if request.seed is not None else _random.randrange(2**31)
        usual, most = DEFAULT_ROBOT.limits, self.ownership.limits
        # They are 0 until the robot process has told them.
        limits = replace(usual, speed=most.speed or usual.speed, angular_speed=most.turn or usual.angular_speed)
        room = built.with_robot(seed, replace(DEFAULT_ROBOT, limits=limits))
        self._twin.prepare(request, request.twin, room, seed)

    def _replay(self, request: page.Replay) -> None:
        self._end_now()
        self.recordings.open(request, self._begin_replay, self._on_no_replay)

    def _begin_replay(self, request: page.Replay, stream: RecordingStream) -> RecordedRun:
        details = stream.heading.details
        self.outbox.put(page.ReplayBegun(request.run, details.program, details.name))
        self._explanations.start(request.run, details.program)
        view = PageView(
            self.outbox, self._room, self._limits.frame_rate, self._loop.time, self._explanations.on_branches
        )
        view.run = request.run
        view.shows_firings = self._view.shows_firings
        view.origin = self.world.arena.start if request.room else Pose(0.0, 0.0, 0.0)
        run = RecordedRun(
            request.run,
            stream,
            self._services,
            view,
            self._on_run_over,
            self._explanations.on_robot_step,
            self.refuse,
        )
        self._run = run
        return run

    def _on_no_replay(self, run: int, why: Sentence) -> None:
        self.refuse(why)
        self._view.show_ended(run, "stopped", [])

    def _on_robot_begun(self) -> None:
        self._view.begin_robot()
        self._twin.begin(self._safety.settings)

    def _on_checked(self, source: str, checked: page.Checked) -> None:
        self._preparation.on_checked(source, checked.problems)
        self._lesson.on_checked(source, checked, self.world.arena)
        self._explanations.on_checked(source, checked)
        self._twin.explanations.on_checked(source, checked)

    def _observe(self, request: page.Observe) -> None:
        self._observes = request.on
        showed, shows = self._view.shows_firings, request.on and request.frames
        self._view.shows_firings = shows
        if isinstance(self._run, SimulatedRun | RobotRun):
            self._run.observe(request.on)
        self._twin.observe(request.on)
        simulated = self._simulated_run()
        if shows and not showed and not (simulated is not None and simulated.is_replaying):
            # A page that begins to show values in a run that stands still or is over has those of now, too.
            latest = self._explanations.latest_firings(self._view.run)
            for time, firing in latest:
                self._view.add_firings(time, [firing])
            if latest:
                self._view.show_frame(force=True)

    def _on_step(self, lockstep: Lockstep) -> None:
        self._lesson.on_step(lockstep)
        if self.bridge:
            for command in lockstep.commands:
                self.bridge.post_command(command, self._loop.time())
        self._explanations.on_step(lockstep)
        if lockstep.settled is not None:
            self._hands.record_step(lockstep)
        self._hands.after_step()

    def _end_now(self) -> None:
        """End the current run at once; the page is told."""
        self._previews.cancel()
        if self._run is not None:
            self._run.end_now()
        self.recordings.cancel()
        self._twin.end_now()
        self.world.command(velocity(0.0, 0.0))
        self._wake_idle()

    def _on_run_over(self, run: PageRun) -> None:
        self._run = None
        if isinstance(run, RobotRun):
            self._view.end_robot()
            self._twin.finish(self._view.step)
        self._unexplained = [r for r in [*self._unexplained, run] if not r.is_explained]
        self._hands.after_step()
        self._wake_idle()

    def _simulated_run(self) -> SimulatedRun | None:
        return self._run if isinstance(self._run, SimulatedRun) else None

    def _wake_idle(self) -> None:
        """Something may have changed for the simulation without a program."""
        if self._run is None:
            self._idle.wake(self.world)

    # ROS clients

    def join(self) -> RosClient:
        """A ROS client connects."""
        client = self.bridge.join()
        self._wake_idle()
        return client

    def leave(self, client: RosClient) -> None:
        """A ROS client has disconnected."""
        self.bridge.leave(client)

    def receive_ros(self, client: RosClient, text: str | bytes) -> None:
        """Serve one message of a ROS client."""
        for message in self.bridge.receive(client, text, self._loop.time()):
            self._hands.between_steps(partial(self._publish, message))

    def _publish(self, message: Command | TopicMessage) -> None:
        """A person or a ROS client publishes a message: a command, or for the program and all ROS clients."""
        self._hands.record(message)
        if isinstance(message, Command):
            self._obey(message)
            return
        if isinstance(self._run, SimulatedRun):
            self._run.post(message)
        self._on_message(message)

    def _on_message(self, message: TopicMessage) -> None:
        self.bridge.post(message, self._loop.time())

    def _obey(self, command: Command) -> None:
        self.world.command(command)
        time = self._steps / STEPS_PER_SECOND
        if command.channel == "Say":
            self._view.show_text(time, str(command.values[0]))
        elif command.channel == "Sound":
            self._view.play_sound(time, int(command.values[0]))
        else:
            self._view.show_frame(force=self._run is None)

    def _on_events(self, events: list[Reading]) -> None:
        self._steps += 1
        self.world.listen("ros", self.bridge.wanted() if self.bridge else ())
        if events or self.bridge:
            time = self._steps / STEPS_PER_SECOND
            self.bridge.publish(events, self.world.odometry(), time, self._loop.time())

    # The end

    async def close(self) -> None:
        """End everything this session started."""
        self.closed.set()
        self._preparation.close()
        self._idle.close()
        self._end_now()
        await self._checks.close()
        await self._previews.close()
        self._twin.close()
        await self.recordings.close()
        for run in self._unexplained:
            run.cancel_explanation()
        await self.ownership.close()
        # A large room is freed now, and not when the garbage collector finds the session.
        self._unexplained = []
        self._idle.pause()
        self._reset_world(_default_room())


def _default_room() -> Room:
    json = named_world(DEFAULT_WORLD)
    return Room(json, usable_world(json, DEFAULT_WORLD))


def _control(run: PageRun, request: page.Stop | page.SetSpeed | page.Pause | page.Resume | page.Forward) -> None:
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
