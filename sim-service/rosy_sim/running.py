"""
One run in the simulator that a page watches, from the press of Run to its end: compile, live, and say how it ended.
"""

from __future__ import annotations

import socket
from collections.abc import Callable

from .config import Limits
from .live import Ending, Lateness, LiveRun
from .lockstep import Lockstep
from .places import Places
from .sentences import broken_link, died, too_much
from .showing import Showing
from .watched import WatchedRun
from .wire import page
from .wire.problem import Problem
from .worker.client import Worker
from .world.events import Event, Velocity
from .world.world import World

__all__ = ["Running"]


class Running(WatchedRun):
    """
    Ends by itself, by stop(), or at once by end_now().

    Args:
        sensed: told what the robot senses in each step.
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
        over: Callable[[WatchedRun], None],
    ) -> None:
        self._seed = seed
        self._world = world
        self._late = late
        self._sensed = sensed
        self._speed: page.Speed = request.speed
        self._paused = False
        # Set once the program has started; None again when the run is over.
        self._live: LiveRun | None = None
        super().__init__(request, worker, places, limits, showing, over)
        showing.frame(force=True)

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

    # What the compilation tells (execution.Listener)

    def on_started(self, link: socket.socket, problems: list[Problem]) -> None:
        """The program runs."""
        self._showing.state("running", problems)
        lockstep = Lockstep(self._world, self._seed)
        self._live = LiveRun(link, lockstep, self._speed, self._limits, self, self._late)
        if self._paused:
            self._live.pause()

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
            self._find_out(ending, time)
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
