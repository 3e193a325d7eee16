"""
A page's place among the robots: whether it may have one, which it has, and what the page is told of it.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path

import msgspec

from .errors import BadInput
from .fleet import Fleet
from .holding import Holding
from .outbox import Outbox
from .showing import Showing
from .wire import page
from .wire.holder import FrameLine, HoldingLine, Line, LinkLine, SaidLine, SoundLine, StoppedLine

__all__ = ["Helm"]


class Helm:
    """Lives as long as the page's session; close() leaves the robot standing."""

    def __init__(
        self,
        speaker: Path | None,
        session: str,
        fleet: Fleet,
        outbox: Outbox,
        showing: Showing,
        back: Callable[[], None],
    ) -> None:
        self._speaker = speaker
        self._session = session
        self._fleet = fleet
        self._outbox = outbox
        self._showing = showing
        # Called when the simulated robot is shown again.
        self._back = back
        self._locked = True
        # The robot in our hands, and what the page was last told of it; None while there is none.
        self.holding: Holding | None = None
        self._state: page.RobotState | None = None
        # Robots that are being let go of.
        self._leaving: set[asyncio.Task[None]] = set()

    def tell(self) -> None:
        """What robots there are, if there are any at all."""
        if self._fleet:
            shown = [] if self._locked else self._fleet.shown(self._session)
            self._outbox.put(page.Robots(self._locked, shown))

    def unlock(self, code: str) -> None:
        """
        A page wants at the robots.

        Raises:
            BadInput: it does not know the code.
        """
        if not self._fleet.opens(code):
            raise BadInput("This is not the code of the robots; it is printed where Rosy was started.")
        self._locked = False
        self.tell()

    def take(self, request: page.Take) -> None:
        """
        Have a robot; one that the page had is left.

        Raises:
            BadInput: it cannot be had.
        """
        if self._locked:
            raise BadInput("The robots are locked; ask the person who started Rosy for their code.")
        if self._speaker is None:
            raise BadInput("The part of Rosy that speaks to robots is not built yet; ./rosy start --robot builds it.")
        address = self._fleet.take(request.robot, self._session, request.who)
        self.leave()
        self._showing.elsewhere = True
        self._showing.run = request.run
        self._state = page.RobotState(request.robot, "connecting", "", True, False, False, 0.0, 0.0)
        self._outbox.put(self._state)
        self.holding = Holding(self._speaker, address, self)

    def leave(self) -> None:
        """The robot stands, and others may have it as soon as it does."""
        holding, self.holding = self.holding, None
        state = self._forget("")
        if holding is not None and state is not None:
            task = asyncio.get_running_loop().create_task(self._let_go(holding, state.name))
            self._leaving.add(task)
            task.add_done_callback(self._leaving.discard)

    async def close(self) -> None:
        """Leave; returns when the robot has been told to stand."""
        self.leave()
        if self._leaving:
            await asyncio.wait(self._leaving)

    async def _let_go(self, holding: Holding, name: str) -> None:
        await holding.close()
        self._fleet.leave(name, self._session)

    def _forget(self, why: str) -> page.RobotState | None:
        """The page has no robot any more; returns what it had."""
        state, self._state = self._state, None
        if state is not None:
            self._showing.elsewhere = False
            self._outbox.put(msgspec.structs.replace(state, link="gone", why=why, stopped=False, backing=False))
            self._back()
        return state

    # What the robot tells (holding.Listener)

    def on_line(self, line: Line) -> None:
        """A line of rosy-robot."""
        state, showing = self._state, self._showing
        if state is None:
            return
        match line:
            case HoldingLine(safety, max_speed, max_turn):
                self._now(safety=safety, max_speed=max_speed, max_turn=max_turn)
            case LinkLine(link, why):
                self._now(link=link, why=why)
            case StoppedLine(stopped):
                self._now(stopped=stopped)
            case FrameLine():
                if line.backing != state.backing:
                    self._now(backing=line.backing)
                showing.telemetry(line)
            case SaidLine(time, text):
                showing.words(time, [text], [])
            case SoundLine(time, sound):
                showing.words(time, [], [sound])

    def _now(self, **changes: object) -> None:
        """The page is told of the robot as it is now."""
        assert self._state is not None
        before, self._state = self._state, msgspec.structs.replace(self._state, **changes)
        if self._state != before:
            self._outbox.put(self._state)

    def on_gone(self) -> None:
        """rosy-robot has ended by itself."""
        self.holding = None
        state = self._forget("The part of Rosy that speaks to the robot has ended.")
        if state is not None:
            self._fleet.leave(state.name, self._session)
