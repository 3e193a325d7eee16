"""
A program in the worker, from its text to its end: compiled, started with one end of a socket, killed, asked why.

Knows nothing of robots: who holds the other end of the socket is the owner's business.
"""

from __future__ import annotations

import asyncio
import socket
from typing import Literal, Protocol

from .config import Limits
from .errors import RosyError
from .places import Places
from .sentences import died, stuck, worker_lost
from .wire.problem import Problem
from .wire.worker import Gone, Refused, Started
from .worker.client import RunningProgram, Worker

__all__ = ["Execution", "Listener"]


class Listener(Protocol):
    """Who is told what became of the compilation; called on the loop, exactly one of the last two."""

    def on_queued(self, place: int) -> None:
        """All places are taken; ours in the queue, 1 for the next."""

    def on_turn(self) -> None:
        """There is a place now."""

    def on_started(self, link: socket.socket, problems: list[Problem]) -> None:
        """The program runs; our end of the link is the listener's now. The problems are warnings."""

    def on_failed(self, ended: Literal["refused", "error"], problems: list[Problem]) -> None:
        """There is nothing to run."""


class Execution:
    """
    Compiles as soon as there is a place. cancel() while that goes on, kill() afterwards; a cancelled one says
    nothing any more.
    """

    def __init__(self, worker: Worker, places: Places, limits: Limits, source: str, listener: Listener) -> None:
        self._worker = worker
        self._places = places
        self._limits = limits
        self._listener = listener
        # As the worker sees it; set once the worker has taken the text.
        self._program: RunningProgram | None = None
        # None once compiling is over.
        self._compiling: asyncio.Task[None] | None = asyncio.get_running_loop().create_task(self._compile(source))

    @property
    def compiling(self) -> bool:
        """Neither started nor failed yet."""
        return self._compiling is not None

    def cancel(self) -> None:
        """Give the compilation up."""
        if self._compiling is not None:
            self._compiling.cancel()
            self._compiling = None

    def kill(self) -> None:
        """End the program at once, if it still runs."""
        if self._program is not None:
            self._worker.kill(self._program)

    async def _enter(self) -> None:
        waited = False

        def told(place: int) -> None:
            nonlocal waited
            waited = True
            self._listener.on_queued(place)

        await self._places.enter(told)
        if waited:
            self._listener.on_turn()

    async def _compile(self, source: str) -> None:
        await self._enter()
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        answer: Started | Refused | Gone
        try:
            async with asyncio.timeout(self._limits.worker_ready + self._limits.compile):
                self._program = await self._worker.start(source, theirs)
                # However it ends, and the worker with it: then somebody else has the place.
                self._program.gone.add_done_callback(lambda _: self._places.leave())
                answer = await asyncio.shield(self._program.started)
        except asyncio.CancelledError:
            self._give_up(ours)
            raise
        except (RosyError, TimeoutError):
            self._give_up(ours)
            self._compiling = None
            self._listener.on_failed("error", [worker_lost()])
            return
        self._compiling = None
        if isinstance(answer, Started):
            self._listener.on_started(ours, answer.problems)
            return
        ours.close()
        if isinstance(answer, Refused):
            self._listener.on_failed("refused", answer.problems)
        else:
            self._listener.on_failed("error", [died(answer, 0.0)])

    def _give_up(self, link: socket.socket) -> None:
        link.close()
        if self._program is None:
            self._places.leave()
        self.kill()

    async def why(self, busy: bool, time: float) -> Problem:
        """What a silent program was doing, which the worker knows; ``busy``: it lives, but does not answer."""
        gone: Gone | None = None
        if self._program is not None:
            if busy:
                self.kill()
            try:
                async with asyncio.timeout(self._limits.gone):
                    gone = await asyncio.shield(self._program.gone)
            except TimeoutError:
                self.kill()
            except RosyError:
                return worker_lost(time)
        if busy:
            return stuck(gone.firing if gone is not None else None, self._limits.settle, time)
        return died(gone, time)
