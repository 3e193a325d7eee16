"""
One page: its room, its run, its requests. Turns requests into runs and what happens into answers.

Everything here happens on the event loop without waiting, except compiling and checking, which are tasks. What is
shown is ``showing``'s, a run ``running``'s, the robot at rest ``idle``'s; the page's socket is ``app``'s.
"""

from __future__ import annotations

import asyncio
import contextlib
import random
from pathlib import Path
from typing import Any

import msgspec

from .bridge import Bridge, Client
from .config import Limits
from .driving import Driving
from .errors import BadInput, RosyError, WorkerLost
from .fleet import Fleet
from .helm import Helm
from .idle import IdleClock
from .library import DEFAULT_WORLD, named_world, usable_arena
from .live import Lateness
from .outbox import Outbox
from .places import Places
from .running import Running
from .showing import Showing
from .watched import WatchedRun
from .wire import page
from .wire.hands import hands_of
from .worker.client import Worker
from .world.events import Command, Event, Say, Sound, Velocity
from .world.world import HandRefused, World

__all__ = ["Session"]

_dice = random.SystemRandom()


class Session:
    """Lives as long as its page is connected; close() ends everything it started."""

    def __init__(
        self,
        ident: str,
        worker: Worker,
        places: Places,
        limits: Limits,
        late: Lateness,
        fleet: Fleet,
        speaker: Path | None,
    ) -> None:
        self.id = ident
        self.outbox = Outbox(limits.page_queue)
        self._worker = worker
        self._places = places
        self._limits = limits
        self._late = late
        self._loop = asyncio.get_running_loop()
        # The room as JSON gave it, for the page, and the world built from it.
        self._world_json: Any = named_world(DEFAULT_WORLD)
        self.world = World(usable_arena(self._world_json, DEFAULT_WORLD))
        self._showing = Showing(self.outbox, self.world, limits.frame_rate, self._loop.time)
        # The real robots, of which this page may have one.
        self.helm = Helm(speaker, ident, fleet, self.outbox, self._showing, self._show_room)
        # ROS clients of the simulated robot.
        self.bridge = Bridge()
        # Steps since the session began, with and without programs.
        self._clock = 0
        self._idle = IdleClock(self.bridge, self._showing, self._tell_bridge)
        # The run under way, and those that are over but not explained yet.
        self._running: WatchedRun | None = None
        self._unexplained: list[WatchedRun] = []
        self._checking: asyncio.Task[None] | None = None
        self._completing: asyncio.Task[None] | None = None
        # Set by close(): no clock may start any more.
        self.closed = asyncio.Event()
        self.outbox.put(page.Hello(session=self.id))
        self.outbox.put(page.WorkerState(self._worker.state))
        self._show_room()
        self.helm.tell()

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
        running = self._running
        match request:
            case page.Check():
                self._check(request)
            case page.Complete():
                self._complete(request)
            case page.Run():
                self._start(request)
            case page.Reset():
                self._end_now()
                self._renew()
                self._show_room()
            case page.ChooseWorld():
                self._choose(request.world)
            case page.Input():
                for hand in hands_of(request):
                    self.world.hand(hand)
                self._showing.frame(force=True)
                self._wake()
            case page.Unlock():
                self.helm.unlock(request.code)
            case page.Take():
                self._end_now()
                self.helm.take(request)
            case page.Leave():
                self._end_now()
                self.helm.leave()
            case page.EmergencyStop() | page.Free() | page.Alive():
                self._tell_robot(request)
            case _ if running is None:
                # The rest is about a run.
                pass
            case page.Stop():
                running.stop()
            case page.SetSpeed():
                running.set_speed(request.speed)
            case page.Pause():
                running.pause()
            case page.Resume():
                running.resume()
            case page.Forward():
                running.forward()

    def _show_room(self) -> None:
        self._showing.room(self._world_json)

    def _tell_robot(self, request: page.EmergencyStop | page.Free | page.Alive) -> None:
        holding = self.helm.holding
        if holding is None:
            return
        match request:
            case page.EmergencyStop():
                holding.emergency_stop()
            case page.Free():
                holding.free()
            case page.Alive():
                holding.alive()

    def _choose(self, wanted: object) -> None:
        value: object = named_world(wanted) if isinstance(wanted, str) else wanted
        arena = usable_arena(value, "This")
        self._end_now()
        self._world_json = value
        self.world = World(arena)
        self._showing.enter(self.world)
        self._show_room()

    def _renew(self, seed: int = 0) -> None:
        self.world = World(self.world.arena, seed)
        self._showing.renew(self.world)

    # Checking

    def _check(self, request: page.Check) -> None:
        if len(request.source) > self._limits.source:
            self._too_long()
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
        # The worker and the page number their questions each for themselves.
        self.outbox.put(msgspec.structs.replace(checked, id=request.id))

    def _complete(self, request: page.Complete) -> None:
        if self._completing is not None:
            self._completing.cancel()
        self._completing = self._loop.create_task(self._answer_complete(request))

    async def _answer_complete(self, request: page.Complete) -> None:
        # Nobody is told when there is nothing to offer: whoever types goes on.
        with contextlib.suppress(RosyError, TimeoutError):
            completed = await self._worker.complete(request.source, request.line, request.column)
            self.outbox.put(msgspec.structs.replace(completed, id=request.id))

    def _too_long(self) -> None:
        self.refuse("This program is too long.", f"A program can have at most {self._limits.source} characters.")

    # Running

    def _start(self, request: page.Run) -> None:
        self._end_now()
        if len(request.source) > self._limits.source:
            self._too_long()
            return
        self._showing.run = request.run
        holding = self.helm.holding
        if holding is not None:
            self._running = Driving(
                request, self._worker, self._places, self._limits, holding, self._showing, self._run_over
            )
            return
        seed = request.seed if request.seed is not None else _dice.randrange(2**31)
        self._renew(seed)
        self._idle.hold()
        self._running = Running(
            request,
            seed,
            self.world,
            self._worker,
            self._places,
            self._limits,
            self._late,
            self._showing,
            self._tell_bridge,
            self._run_over,
        )

    def _end_now(self) -> None:
        """End whatever runs, at once; the page is told."""
        if self._running is not None:
            self._running.end_now()
        self.world.command(Velocity(0.0, 0.0))
        self._wake()

    def _run_over(self, running: WatchedRun) -> None:
        self._running = None
        self._unexplained = [r for r in [*self._unexplained, running] if not r.explained]
        self._wake()

    def _wake(self) -> None:
        """Let the idle clock go when there is something for it to do."""
        if self._running is None:
            self._idle.wake(self.world)

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
                self._showing.said(self._clock / 50, text)
            case Sound(sound):
                self._showing.sound(self._clock / 50, sound)
            case _:
                self._showing.frame(force=self._running is None)

    def _tell_bridge(self, events: list[Event]) -> None:
        self._clock += 1
        if events or self.bridge:
            self.bridge.sensed(events, self.world.odometry(), self._clock / 50, self._loop.time())

    # The end

    async def close(self) -> None:
        """End everything this session started."""
        self.closed.set()
        self._idle.close()
        self._end_now()
        for question in (self._checking, self._completing):
            if question is not None:
                question.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await question
        for running in self._unexplained:
            running.forget()
        await self.helm.close()
