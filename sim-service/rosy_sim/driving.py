"""
One run on a real robot that a page watches, from the press of Run to its end. The brother of ``running``.
"""

from __future__ import annotations

import socket
from collections.abc import Callable

from .config import Limits
from .holding import Holding
from .places import Places
from .sentences import broken_link, died, lost_robot
from .showing import Showing
from .watched import WatchedRun
from .wire import page
from .wire.holder import EndedLine
from .wire.problem import Problem
from .worker.client import Worker

__all__ = ["Driving"]


class Driving(WatchedRun):
    """Ends by itself, by stop(), or at once by end_now(). A real robot has no other speed and no pause."""

    def __init__(
        self,
        request: page.Run,
        worker: Worker,
        places: Places,
        limits: Limits,
        holding: Holding,
        showing: Showing,
        over: Callable[[WatchedRun], None],
    ) -> None:
        self._holding = holding
        super().__init__(request, worker, places, limits, showing, over)

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

    # What the compilation tells (execution.Listener)

    def on_started(self, link: socket.socket, problems: list[Problem]) -> None:
        """The program runs."""
        self._showing.state("running", problems)
        self._holding.run(link, self)

    # What the robot tells (holding.RunListener)

    def on_ended(self, line: EndedLine) -> None:
        """The run is over."""
        if self._closed:
            return
        if line.how == "stuck" or line.how == "died":
            self._find_out(line.how, line.time)
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
