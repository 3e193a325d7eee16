"""
One run on a real robot that a page watches, from the press of Run to its end. The brother of ``running``.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from typing import Literal

from .config import Limits
from .execution import Execution
from .holding import Holding
from .places import Places
from .sentences import broken_link, died, lost_robot
from .showing import Showing
from .wire import page
from .wire.holder import EndedLine
from .wire.problem import Problem
from .worker.client import Worker

__all__ = ["Driving"]


class Driving:
    """Ends by itself, by stop(), or at once by end_now(). A real robot has no other speed and no pause."""

    def __init__(
        self,
        request: page.Run,
        worker: Worker,
        places: Places,
        limits: Limits,
        holding: Holding,
        showing: Showing,
        over: Callable[[Driving], None],
    ) -> None:
        self._run = request.run
        self._holding = holding
        self._showing = showing
        self._over = over
        # Nobody follows it any more, or the page has been told how it ended.
        self._closed = False
        self._asking: asyncio.Task[None] | None = None
        showing.state("compiling")
        self._execution = Execution(worker, places, limits, request.source, self)

    def stop(self) -> None:
        """Let the program end in good order; the wheels stand at once."""
        if self._execution.compiling:
            self.end_now()
        else:
            self._holding.stop()

    def end_now(self) -> None:
        """End without waiting for anything; the page is told."""
        if self._execution.compiling:
            self._execution.cancel()
        else:
            self._holding.stop()
            self._execution.kill()
        self._end("stopped", [])

    def set_speed(self, speed: page.Speed) -> None:
        """Real time has one speed."""

    def pause(self) -> None:
        """Real time does not stand."""

    def resume(self) -> None:
        """It always goes on."""

    def forward(self) -> None:
        """Nor does it go in steps."""

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
        """As many programs run as may."""
        self._showing.queued(place)

    def on_turn(self) -> None:
        """There is a place."""
        self._showing.state("compiling")

    def on_started(self, link: socket.socket, problems: list[Problem]) -> None:
        """The program runs."""
        self._showing.state("running", problems)
        self._holding.run(link, self)

    def on_failed(self, ended: Literal["refused", "error"], problems: list[Problem]) -> None:
        """There is nothing to run."""
        self._end(ended, problems)

    # What the robot tells (holding.RunListener)

    def on_ended(self, line: EndedLine) -> None:
        """The run is over."""
        if self._closed:
            return
        if line.how == "stuck" or line.how == "died":
            self._closed = True
            self._asking = asyncio.get_running_loop().create_task(self._explain(line.how, line.time))
            self._over(self)
            return
        self._execution.kill()
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
        """The robot is no longer ours."""
        self._execution.kill()
        self._end("error", [lost_robot(self._showing.step / 50)])

    async def _explain(self, how: Literal["stuck", "died"], time: float) -> None:
        problem = await self._execution.why(how == "stuck", time)
        self._showing.over(self._run, "stuck" if how == "stuck" else "error", [problem])

    def _end(self, ended: Literal["done", "error", "stopped", "refused"], problems: list[Problem]) -> None:
        if self._closed:
            return
        self._closed = True
        self._showing.over(self._run, ended, problems)
        self._over(self)
