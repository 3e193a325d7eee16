"""
A goal of an action of ROS 2, from its start to its result: an action is three services and two topics below ``_action``
(design.ros2.org, "Actions").

Where answers of services may be those to other programs, the action's status topic, which names goals, says how this
one goes on.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
from collections.abc import Callable
from typing import Any

from .calls import CallFailed, Calls
from .transports.dds_messages import BadMessage, message_class, to_json
from .transports.transport import Reader

__all__ = ["Goal"]

_AGAIN = 1.0
"""Until a goal of which nothing was heard is sent again, s."""

_ATTEMPTS = 30

_FIRST_ENDED = 4
"""action_msgs, GoalStatus: from here on a goal has ended; 4 succeeded, 5 cancelled, 6 aborted."""


class Goal:
    """``on_feedback`` is told what the action says of it meanwhile."""

    def __init__(self, calls: Calls, action: str, on_feedback: Callable[[dict[str, Any]], None]) -> None:
        self._calls = calls
        self._place = f"{action}/_action"
        self._on_feedback = on_feedback
        self._ident = secrets.token_bytes(16)
        self._kind = ""
        self._readers: list[Reader] = []
        self._accepted = self._cancelled = False
        # By the status topic; 0 while it does not know the goal.
        self._status = 0
        self._moved_on = asyncio.Event()

    async def pursue(self, content: Any) -> tuple[int, dict[str, Any]]:
        """
        How it ended (action_msgs, GoalStatus), and with what.

        Raises:
            CallFailed: it was not pursued.
        """
        self._kind = self._calls.kind(f"{self._place}/send_goal").removesuffix("_SendGoal")
        if message_class(f"{self._kind}_FeedbackMessage") is None:
            raise CallFailed(f"there is no definition of {self._kind}")
        # All are opened first: cancelling must not wait.
        for part in ("cancel_goal", "get_result"):
            await self._calls.open(f"{self._place}/{part}")
        is_exact = await self._calls.open(f"{self._place}/send_goal")
        self._read("feedback", f"{self._kind}_FeedbackMessage", self._take_feedback)
        try:
            if not is_exact:
                self._read("status", "action_msgs/GoalStatusArray", self._take_status)
            await self._send({"goal_id": self._goal_id(), "goal": content}, is_exact)
            if not self._accepted:
                raise CallFailed("Action goal was rejected")
            if self._cancelled:
                self.cancel()
            return await self._result(is_exact)
        finally:
            for reader in self._readers:
                reader.close()

    def cancel(self) -> None:
        """Asks the action to give it up; how it ended is still said by the action."""
        self._cancelled = True
        if self._accepted:
            self._calls.tell(f"{self._place}/cancel_goal", {"goal_info": {"goal_id": self._goal_id()}})

    async def _send(self, goal: dict[str, Any], is_exact: bool) -> None:
        """A goal may be sent again: the action rejects one whose number it knows."""
        service = f"{self._place}/send_goal"
        if is_exact:
            self._accepted = (await self._calls.ask(service, goal))["accepted"]
            return
        for attempt in range(_ATTEMPTS):
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(_AGAIN):
                    self._accepted = (await self._calls.ask(service, goal))["accepted"]
                    if self._accepted or attempt == 0:
                        return
                    await self._moved_on.wait()
            if self._status:
                self._accepted = True
                return
        raise CallFailed("it has not answered")

    async def _result(self, is_exact: bool) -> tuple[int, dict[str, Any]]:
        service, request = f"{self._place}/get_result", {"goal_id": self._goal_id()}
        if is_exact:
            answer = await self._calls.ask(service, request)
            return answer["status"], answer["result"]
        while self._status < _FIRST_ENDED:
            self._moved_on.clear()
            # An action that is gone says nothing more.
            self._calls.kind(service)
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(_AGAIN):
                    await self._moved_on.wait()
        for _ in range(_ATTEMPTS):
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(_AGAIN):
                    return self._status, (await self._calls.ask(service, request))["result"]
        raise CallFailed("it has not answered")

    def _read(self, part: str, kind: str, use: Callable[[Any], None]) -> None:
        reader: Reader | None = None

        def take() -> None:
            for message in reader.take() if reader is not None else ():
                if not isinstance(message, BadMessage):
                    use(message)

        reader = self._calls.reader(f"{self._place}/{part}", kind, take)
        self._readers.append(reader)

    def _take_feedback(self, message: Any) -> None:
        if bytes(message.goal_id.uuid) == self._ident:
            self._on_feedback(to_json(f"{self._kind}_Feedback", message.feedback))

    def _take_status(self, message: Any) -> None:
        for known in message.status_list:
            if bytes(known.goal_info.goal_id.uuid) == self._ident:
                self._status = known.status
                self._moved_on.set()

    def _goal_id(self) -> dict[str, Any]:
        return {"uuid": list(self._ident)}
