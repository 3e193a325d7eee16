"""
One page: its room, its run, its requests. Turns requests into runs and what happens into answers.

Everything here happens on the event loop without waiting, except compiling and checking, which are tasks of
the session. The page's socket is somebody else's business (``app``).
"""

from __future__ import annotations

import asyncio
import contextlib
import random
import socket
from typing import Any

from .bridge import Bridge, Client
from .budget import Budget
from .config import Limits
from .errors import BadInput, RosyError, WorkerLost
from .library import DEFAULT_WORLD, named_world, usable_arena
from .live import Ending, Lateness, LiveRun
from .lockstep import Lockstep
from .outbox import Outbox
from .sentences import broken_link, died, stuck, worker_lost
from .wire import page
from .wire.hands import hands_of
from .wire.problem import Problem
from .wire.worker import Gone, Refused, Started
from .worker.client import RunningProgram, Worker
from .world.events import Command, Event, Say, Sound, Velocity
from .world.facts import STEP
from .world.goals import GoalState
from .world.world import HandRefused, World

__all__ = ["Session"]

_dice = random.SystemRandom()

_MAX_FIRED = 200
"""Firings told in one frame; the latest ones."""

_MAX_WORDS = 10_000
"""Characters of one `Say` that reach the page."""

_MAX_SOUNDS = 10
"""Sounds of one step that reach the page."""


class Session:
    """Lives as long as its page is connected; close() ends everything it started."""

    def __init__(self, ident: str, worker: Worker, limits: Limits, late: Lateness) -> None:
        self.id = ident
        self.outbox = Outbox(limits.page_queue)
        self._worker = worker
        self._limits = limits
        self._late = late
        self._loop = asyncio.get_running_loop()
        # The room as JSON gave it, for the page, and the world built from it.
        self._world_json: Any = named_world(DEFAULT_WORLD)
        self.world = World(usable_arena(self._world_json, DEFAULT_WORLD))
        # The run under way: its number, its compilation, its program and its loop. Set by _start().
        self._run = 0
        self._compiling: asyncio.Task[None] | None = None
        self._program: RunningProgram | None = None
        self._live: LiveRun | None = None
        self._lockstep: Lockstep | None = None
        self._speed: page.Speed = 1.0
        self._paused = False
        self._checking: asyncio.Task[None] | None = None
        # Tasks that see a finished run to its grave.
        self._burials: set[asyncio.Task[None]] = set()
        # Where the page was last told that the movable things are.
        self._shown_boxes: list[tuple[float, float, float]] = []
        # The goals as the page was last told.
        self._shown_goals: list[page.Goal] = []
        # Says and sounds that may still go to the page: 100 a second, 300 at once.
        self._words = Budget(100.0, 300.0, self._loop.time())
        # Frames that may still go out, a few at once so that a step that is late gets one too; and what fired since.
        self._frames = Budget(limits.frame_rate, 3.0, self._loop.time())
        self._fired: list[str] = []
        # Set by close(): no clock may start any more.
        self.closed = asyncio.Event()
        # ROS clients of this robot.
        self.bridge = Bridge()
        # The clock of a robot without a program: rolls it to rest, and serves ROS clients.
        self._idle: asyncio.Handle | None = None
        self._due = 0.0
        # Steps since the session began, with and without programs; and of the last run.
        self._clock = 0
        self._step = 0
        self._greet()

    def _greet(self) -> None:
        self.outbox.put(page.Hello(session=self.id))
        self.outbox.put(page.WorkerState(self._worker.state))
        self._show_world()

    def _show_world(self) -> None:
        self.outbox.put(page.WorldShown(self._world_json))
        self._frame(force=True)

    # Requests

    def receive(self, text: str | bytes) -> None:
        """Serve one message of the page, or refuse it."""
        try:
            self._serve(page.read_request(text))
        except page.BadRequest as error:
            self.refuse("The page sent something Rosy does not understand.", str(error))
        except (BadInput, HandRefused) as error:
            self.refuse(str(error))

    def refuse(self, message: str, hint: str = "") -> None:
        """Say that the last message changed nothing."""
        self.outbox.put(page.Refusal(message, hint))

    def _serve(self, request: page.Request) -> None:
        match request:
            case page.Check():
                self._check(request)
            case page.Run():
                self._start(request)
            case page.Stop():
                self._stop()
            case page.Reset():
                self._end_now()
                self._renew()
                self._show_world()
            case page.ChooseWorld():
                self._choose(request.world)
            case page.SetSpeed():
                self._speed = request.speed
                if self._live is not None:
                    self._live.set_speed(request.speed)
            case page.Pause():
                self._paused = True
                if self._live is not None:
                    self._live.pause()
            case page.Resume():
                self._paused = False
                if self._live is not None:
                    self._live.resume()
            case page.Forward():
                if self._live is not None:
                    self._live.forward()
            case page.Input():
                for hand in hands_of(request):
                    self.world.hand(hand)
                self._frame(force=True)
                self._wake()

    def _choose(self, wanted: object) -> None:
        value: object = named_world(wanted) if isinstance(wanted, str) else wanted
        arena = usable_arena(value, "This")
        self._end_now()
        self._world_json = value
        self.world = World(arena)
        self._shown_boxes = []
        self._show_world()

    def _renew(self, seed: int = 0) -> None:
        self.world = World(self.world.arena, seed)
        self._shown_boxes = []
        self._shown_goals = []
        self._fired = []
        self._step = 0

    # Checking

    def _check(self, request: page.Check) -> None:
        if len(request.source) > self._limits.source:
            self.refuse("This program is too long.", f"A program can have at most {self._limits.source} characters.")
            return
        if self._checking is not None:
            self._checking.cancel()
        self._checking = self._loop.create_task(self._answer_check(request))

    async def _answer_check(self, request: page.Check) -> None:
        try:
            checked = await self._worker.check(request.source)
        except WorkerLost:
            # The page is told that the worker restarts, and asks again.
            return
        except (RosyError, TimeoutError) as error:
            self.refuse("This program could not be checked.", str(error))
            return
        self.outbox.put(page.Checked(request.id, checked.problems, checked.declarations, checked.graph))

    # Running

    def _start(self, request: page.Run) -> None:
        self._end_now()
        if len(request.source) > self._limits.source:
            self.refuse("This program is too long.", f"A program can have at most {self._limits.source} characters.")
            return
        self._run = request.run
        self._speed = request.speed
        self._paused = False
        seed = request.seed if request.seed is not None else _dice.randrange(2**31)
        self._renew(seed)
        self._tell("compiling")
        self._frame(force=True)
        self._compiling = self._loop.create_task(self._compile(request.run, request.source, seed))

    async def _compile(self, run: int, source: str, seed: int) -> None:
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        program: RunningProgram | None = None
        try:
            async with asyncio.timeout(self._limits.worker_ready + self._limits.compile):
                program = await self._worker.start(source, theirs)
                self._program = program
                answer = await asyncio.shield(program.started)
        except asyncio.CancelledError:
            ours.close()
            if program is not None:
                self._worker.kill(program)
            raise
        except (RosyError, TimeoutError):
            ours.close()
            if program is not None:
                self._worker.kill(program)
            self._program = self._compiling = None
            self._over(run, "error", [worker_lost()])
            return
        self._compiling = None
        self._begin(run, ours, answer, seed)

    def _begin(self, run: int, link: socket.socket, answer: Started | Refused | Gone, seed: int) -> None:
        if isinstance(answer, Started):
            self._tell("running", answer.problems)
            self._lockstep = Lockstep(self.world, seed)
            self._live = LiveRun(link, self._lockstep, self._speed, self._limits, self, self._late)
            if self._paused:
                self._live.pause()
            return
        link.close()
        self._program = None
        if isinstance(answer, Refused):
            self._over(run, "refused", answer.problems)
        else:
            self._over(run, "error", [died(answer, 0.0)])

    def _stop(self) -> None:
        if self._compiling is not None:
            self._end_now()
        elif self._live is not None:
            self._live.stop()

    def _end_now(self) -> None:
        """End whatever runs, at once; the page is told."""
        if self._compiling is not None:
            self._compiling.cancel()
            self._compiling = self._program = None
            self._over(self._run, "stopped", [])
        elif self._live is not None:
            self._live.abandon()
            self._bury(self._program)
            self._live = self._program = None
            self._frame(force=True)
            self._over(self._run, "stopped", [])
        self.world.command(Velocity(0.0, 0.0))
        self._wake()

    def _bury(self, program: RunningProgram | None) -> None:
        if program is not None:
            self._worker.kill(program)

    # What the run tells (live.Watcher)

    def on_step(self, lockstep: Lockstep) -> None:
        """A step has passed."""
        self._step = lockstep.step
        self._tell_bridge(lockstep.events)
        self._relay(lockstep)
        if lockstep.settled is not None:
            self._fired = (self._fired + lockstep.settled.fired)[-_MAX_FIRED:]
        self._frame(force=self._paused)
        if lockstep.goals:
            self._show_goals(lockstep.goals.states)

    def _relay(self, lockstep: Lockstep) -> None:
        """Words and sounds, as many as a page can show: a program that talks without end must not fill our memory."""
        for text in lockstep.said():
            if self._words.spend(1, self._loop.time()):
                self.outbox.put(page.Said(self._run, lockstep.time, text[:_MAX_WORDS]))
        for sound in lockstep.sounds()[:_MAX_SOUNDS]:
            if self._words.spend(1, self._loop.time()):
                self.outbox.put(page.SoundPlayed(self._run, lockstep.time, sound))

    def on_end(self, ending: Ending, detail: str) -> None:
        """The run is over."""
        assert self._lockstep is not None
        program, lockstep, run = self._program, self._lockstep, self._run
        self._live = self._program = None
        self.world.command(Velocity(0.0, 0.0))
        self._frame(force=True)
        time = lockstep.time
        if lockstep.goals:
            lockstep.goals.finish(time)
            self._show_goals(lockstep.goals.states)
        if ending in ("done", "stopped"):
            self._bury(program)
            self._over(run, "done" if ending == "done" else "stopped", [])
        elif ending == "error":
            self._bury(program)
            last = lockstep.ended
            problem = last.problem if last is not None and last.problem is not None else died(None, time)
            self._over(run, "error", [problem])
        elif ending == "broken":
            self._bury(program)
            self._over(run, "error", [broken_link(detail, time)])
        else:
            task = self._loop.create_task(self._ask_why(program, run, ending, time))
            self._burials.add(task)
            task.add_done_callback(self._burials.discard)
        self._wake()

    async def _ask_why(self, program: RunningProgram | None, run: int, ending: Ending, time: float) -> None:
        """The worker knows what a silent program was doing."""
        gone: Gone | None = None
        lost = False
        if program is not None:
            if ending == "stuck":
                self._worker.kill(program)
            try:
                async with asyncio.timeout(self._limits.gone):
                    gone = await asyncio.shield(program.gone)
            except TimeoutError:
                self._worker.kill(program)
            except RosyError:
                lost = True
        if lost:
            problem = worker_lost(time)
        elif ending == "stuck":
            problem = stuck(gone.firing if gone is not None else None, self._limits.settle, time)
        else:
            problem = died(gone, time)
        self._over(run, "stuck" if ending == "stuck" else "error", [problem])

    def _show_goals(self, states: list[GoalState]) -> None:
        """Tell the page about goals when something about them has changed visibly."""
        goals = [page.Goal(s.kind, s.title, s.state, round(s.progress, 2), s.time) for s in states]
        if goals != self._shown_goals:
            self._shown_goals = goals
            self.outbox.put(page.GoalsShown(self._run, goals))

    def _tell(self, state: Any, problems: list[Problem] | None = None) -> None:
        self.outbox.put(page.RunState(self._run, state, problems or []))

    def _over(self, run: int, ended: Any, problems: list[Problem]) -> None:
        self.outbox.put(page.RunState(run, "ended", problems, ended))

    # Frames and the idle clock

    def _frame(self, force: bool = False) -> None:
        now = self._loop.time()
        if not force and not self._frames.spend(1, now):
            return
        world = self.world
        bits = world.bits
        fired, self._fired = self._fired, []
        self.outbox.put(
            page.Frame(
                self._run,
                self._step,
                self._step / 50,
                world.x,
                world.y,
                world.theta,
                world.v,
                world.w,
                bits.bumpers,
                bits.cliffs,
                bits.wheels,
                bits.buttons,
                world.leds[0],
                world.leds[1],
                fired,
                self._moved_boxes(),
                self.world.ghost(),
            )
        )

    def _moved_boxes(self) -> list[tuple[float, float, float]] | None:
        """Where the movable things are, when they are not where the page knows them."""
        if not self.world.room.movables:
            return None
        poses = self.world.room.poses()
        if poses == self._shown_boxes:
            return None
        self._shown_boxes = poses
        return poses

    def _wake(self) -> None:
        """Let the idle clock go when there is something for it to do."""
        if self._idle is None and not self.closed.is_set():
            self._due = self._loop.time()
            self._idle = self._loop.call_soon(self._roll)

    def _roll(self) -> None:
        """Without a program: 20 ms at a time until the robot is at rest and no ROS client listens."""
        self._idle = None
        world = self.world
        moving = world.v or world.w or world.room.awake
        if self._live is not None or self._compiling is not None or not (moving or self.bridge):
            return
        events = world.sense()
        world.integrate()
        self._tell_bridge(events)
        self._frame(force=bool(moving) and not (world.v or world.w))
        self._due = max(self._due + STEP, self._loop.time() - STEP)
        self._idle = self._loop.call_at(self._due, self._roll)

    # ROS clients

    def join(self) -> Client:
        """A ROS client connects."""
        client = self.bridge.join()
        self._wake()
        return client

    def leave(self, client: Client) -> None:
        """A ROS client is gone."""
        self.bridge.leave(client)

    def receive_ros(self, client: Client, text: str | bytes) -> None:
        """Serve one message of a ROS client."""
        for command in self.bridge.receive(client, text, self._loop.time()):
            self._obey(command)

    def _obey(self, command: Command) -> None:
        self.world.command(command)
        match command:
            case Say(text):
                self.outbox.put(page.Said(self._run, self._clock / 50, text))
            case Sound(sound):
                self.outbox.put(page.SoundPlayed(self._run, self._clock / 50, sound))
            case _:
                self._frame(force=self._live is None)

    def _tell_bridge(self, events: list[Event]) -> None:
        self._clock += 1
        if events or self.bridge:
            self.bridge.sensed(events, self.world.odometry(), self._clock / 50, self._loop.time())

    # The end

    async def close(self) -> None:
        """End everything this session started."""
        self.closed.set()
        if self._idle is not None:
            self._idle.cancel()
        self._end_now()
        if self._checking is not None:
            self._checking.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._checking
        for task in list(self._burials):
            task.cancel()
