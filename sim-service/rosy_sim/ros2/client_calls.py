"""Calls and goals of one client of the bridge, as frames of rosbridge; its goals end with it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from typing import Any

from .calls import CallFailed, Calls
from .goal import Goal

__all__ = ["ClientCalls"]


class ClientCalls:
    """``send`` takes frames for the client."""

    def __init__(self, calls: Calls, send: Callable[[dict[str, Any]], None]) -> None:
        self._calls = calls
        self._send = send
        # By the client's names for them.
        self._goals: dict[Any, Goal] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    def call(self, message: dict[str, Any], service: str, args: Any, known: dict[str, Any] | None) -> None:
        """Answers a `call_service`; ``known`` is the response if the bridge itself has it."""
        answer = {"op": "service_response", "service": service}
        answer |= {"id": message["id"]} if "id" in message else {}
        if known is not None:
            self._send(answer | {"values": known, "result": True})
        else:
            self._start(self._call(answer, args))

    def pursue(self, message: dict[str, Any], action: str) -> None:
        """Answers a `send_action_goal`, with feedback before that."""
        ident = message.get("id")
        frame = {"id": ident, "action": message.get("action")}
        goal = Goal(
            self._calls, action, lambda values: self._send({"op": "action_feedback", **frame, "values": values})
        )
        self._goals[ident] = goal
        self._start(self._pursue(goal, {"op": "action_result", **frame}, message.get("args") or {}))

    def cancel(self, ident: Any) -> None:
        """Carries out a `cancel_action_goal`; the goal's own answer still comes."""
        if ident in self._goals:
            self._goals[ident].cancel()

    def leave(self) -> None:
        """Cancels what is pursued for the client, which hears no more of it."""
        self._send = lambda _frame: None
        for goal in self._goals.values():
            goal.cancel()

    async def _call(self, answer: dict[str, Any], args: Any) -> None:
        try:
            values = await self._calls.call(answer["service"], args, "id" in answer)
        except CallFailed as why:
            self._send(answer | {"values": str(why), "result": False})
        else:
            self._send(answer | {"values": values, "result": True})

    async def _pursue(self, goal: Goal, answer: dict[str, Any], content: Any) -> None:
        try:
            status, values = await goal.pursue(content)
        except CallFailed as why:
            self._send(answer | {"values": str(why), "status": 0, "result": False})
        else:
            self._send(answer | {"values": values, "status": status, "result": True})
        finally:
            self._goals.pop(answer["id"], None)

    def _start(self, work: Coroutine[Any, Any, None]) -> None:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
