"""
What every run that a page watches has in common, wherever it drives: it compiles, may be ended, and the page is told
how it ended. ``running`` is one in the simulator, ``driving`` one on a real robot.
"""

from __future__ import annotations

import asyncio
import socket
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Literal

from .config import Limits
from .execution import Execution
from .places import Places
from .showing import Ended, Showing
from .wire import page
from .wire.problem import Problem
from .worker.client import Worker

__all__ = ["Silent", "WatchedRun"]

Silent = Literal["stuck", "died"]
"""A program that lives and does not answer, and one that is gone without a word; the worker knows more."""


class WatchedRun(ABC):
    """
    Compiles at once, and is an execution's listener.

    Args:
        over: called once, when the robot is free for the next run. The page may still be told why this one ended: that
            takes until it is ``explained``.
    """

    def __init__(
        self,
        request: page.Run,
        worker: Worker,
        places: Places,
        limits: Limits,
        showing: Showing,
        over: Callable[[WatchedRun], None],
    ) -> None:
        self._run = request.run
        self._limits = limits
        self._showing = showing
        self._over = over
        # The robot is free again, and the page has been told how it ended or will be.
        self._closed = False
        # Asks the worker why the program went silent.
        self._asking: asyncio.Task[None] | None = None
        showing.state("compiling")
        self._execution = Execution(worker, places, limits, request.source, self)

    # What the page may ask

    @abstractmethod
    def stop(self) -> None:
        """Let the program end in good order, which takes a second at most."""

    @abstractmethod
    def end_now(self) -> None:
        """End without waiting for anything; the page is told."""

    @abstractmethod
    def set_speed(self, speed: page.Speed) -> None:
        """Change the clock."""

    @abstractmethod
    def pause(self) -> None:
        """Stop the clock."""

    @abstractmethod
    def resume(self) -> None:
        """Let it go."""

    @abstractmethod
    def forward(self) -> None:
        """One step while it stands."""

    # What comes after the end

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

    @abstractmethod
    def on_started(self, link: socket.socket, problems: list[Problem]) -> None:
        """The program runs; its link is ours."""

    def on_failed(self, ended: Literal["refused", "error"], problems: list[Problem]) -> None:
        """There is nothing to run."""
        self._end(ended, problems)

    # How it ends

    def _end(self, ended: Ended, problems: list[Problem]) -> None:
        """The page is told, once."""
        if self._closed:
            return
        self._closed = True
        self._showing.over(self._run, ended, problems)
        self._over(self)

    def _find_out(self, silent: Silent, time: float) -> None:
        """The page is told as soon as the worker has said why."""
        if self._closed:
            return
        self._closed = True
        self._asking = asyncio.get_running_loop().create_task(self._explain(silent, time))
        self._over(self)

    async def _explain(self, silent: Silent, time: float) -> None:
        problem = await self._execution.why(silent == "stuck", time)
        self._showing.over(self._run, "stuck" if silent == "stuck" else "error", [problem])
