"""
One run in the simulator that a page watches, from the press of Run to its end: compile, live, and say how it ended.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from typing import Literal

from .config import Limits
from .execution import Execution
from .live import Ending, Lateness, LiveRun
from .lockstep import Lockstep
from .places import Places
from .sentences import broken_link, died, too_much
from .showing import Showing
from .wire import page
from .wire.problem import Problem
from .worker.client import Worker
from .world.events import Event, Velocity
from .world.world import World

__all__ = ["Running"]


class Running:
    """
    Ends by itself, by stop(), or at once by end_now().

    Args:
        sensed: told what the robot senses in each step.
        over: called once, when the robot is free for the next run. The page may still be told why this one ended: that
            takes until ``done`` is done.
    """

    def __init__(
        self,
        request: page.Run,
        seed: int,
        world: World,
        worker: Worker,
        places: Places,
        limits: Limits,
        late: Lateness,
        showing: Showing,
        sensed: Callable[[list[Event]], None],
        over: Callable[[Running], None],
    ) -> None:
        self._run = request.run
        self._seed = seed
        self._world = world
        self._limits = limits
        self._late = late
        self._showing = showing
        self._sensed = sensed
        self._over = over
        self._speed: page.Speed = request.speed
        self._paused = False
        # Set once the program has started; None again when the run is over.
        self._live: LiveRun | None = None
        # Asks the worker why the program went silent.
        self._asking: asyncio.Task[None] | None = None
        showing.state("compiling")
        showing.frame(force=True)
        self._execution = Execution(worker, places, limits, request.source, self)

    # What the page may ask

    def stop(self) -> None:
        """Let the program end in good order, which takes a second at most."""
        if self._execution.compiling:
            self.end_now()
        elif self._live is not None:
            self._live.stop()

    def end_now(self) -> None:
        """End without waiting for anything; the page is told."""
        if self._execution.compiling:
            self._execution.cancel()
        elif self._live is not None:
            self._live.abandon()
            self._execution.kill()
            self._live = None
            self._showing.frame(force=True)
        self._end("stopped", [])

    def set_speed(self, speed: page.Speed) -> None:
        """Change the clock."""
        self._speed = speed
        if self._live is not None:
            self._live.set_speed(speed)

    def pause(self) -> None:
        """Stop the clock."""
        self._paused = True
        if self._live is not None:
            self._live.pause()

    def resume(self) -> None:
        """Let it go."""
        self._paused = False
        if self._live is not None:
            self._live.resume()

    def forward(self) -> None:
        """One step while it stands."""
        if self._live is not None:
            self._live.forward()

    def forget(self) -> None:
        """Nobody wants to know why it ended any more."""
        if self._asking is not None:
            self._asking.cancel()

    @property
    def explained(self) -> bool:
        """Whether the page has been told how it ended."""
        return self._asking is None or self._asking.done()

    # What the compilation tells (execution.Listener)

    def on_queued(self, place: int) -> None:
        """The room is full."""
        self._showing.queued(place)

    def on_turn(self) -> None:
        """There is a place."""
        self._showing.state("compiling")

    def on_started(self, link: socket.socket, problems: list[Problem]) -> None:
        """The program runs."""
        self._showing.state("running", problems)
        lockstep = Lockstep(self._world, self._seed)
        self._live = LiveRun(link, lockstep, self._speed, self._limits, self, self._late)
        if self._paused:
            self._live.pause()

    def on_failed(self, ended: Literal["refused", "error"], problems: list[Problem]) -> None:
        """There is nothing to run."""
        self._end(ended, problems)

    # What the run tells (live.Watcher)

    def on_step(self, lockstep: Lockstep) -> None:
        """A step has passed."""
        showing = self._showing
        showing.step = lockstep.step
        self._sensed(lockstep.events)
        showing.words(lockstep.time, lockstep.said(), lockstep.sounds())
        done = lockstep.settled or lockstep.ended
        if done is not None:
            showing.fired(done.fired)
        if lockstep.settled is not None and lockstep.settled.memory is not None:
            showing.memory(lockstep.settled.memory)
        showing.frame(force=self._paused)
        if lockstep.goals:
            showing.goals(lockstep.goals.states)

    def on_end(self, lockstep: Lockstep, ending: Ending, detail: str) -> None:
        """The run is over."""
        self._live = None
        self._world.command(Velocity(0.0, 0.0))
        self._showing.frame(force=True)
        time = lockstep.time
        if lockstep.goals:
            lockstep.goals.finish(time)
            self._showing.goals(lockstep.goals.states)
        if ending == "stuck" or ending == "died":
            self._asking = asyncio.get_running_loop().create_task(self._explain(ending, time))
            self._over(self)
            return
        self._execution.kill()
        if ending == "error":
            last = lockstep.ended
            problem = last.problem if last is not None and last.problem is not None else died(None, time)
            self._end("error", [problem])
        elif ending == "broken":
            self._end("error", [broken_link(detail, time)])
        elif ending == "loud":
            self._end("error", [too_much(detail, time)])
        else:
            self._end(ending, [])

    async def _explain(self, ending: Literal["stuck", "died"], time: float) -> None:
        problem = await self._execution.why(ending == "stuck", time)
        self._showing.over(self._run, "stuck" if ending == "stuck" else "error", [problem])

    def _end(self, ended: Literal["done", "error", "stopped", "refused"], problems: list[Problem]) -> None:
        self._showing.over(self._run, ended, problems)
        self._over(self)
