"""
The simulated robot's actions as ROS 1 has them: five topics (wiki.ros.org/actionlib/DetailedDescription).

Pure. In: messages of clients on ``goal`` and ``cancel``. Out: goals for the robot's own programs, and messages on
``status``, ``feedback`` and ``result``. All clients of these topics are one client of the robot: they hear each other.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

from ...world.action_goals import ActionReply
from ...world.events import GiveGoal, TakeBackGoal
from ...world.robot import ABORTED, CANCELED, SUCCEEDED
from ..topics import TopicMessage

__all__ = ["ACTIONLIB", "KEPT_RESULTS", "STATUS_STEPS", "goal_of", "reply_message", "status_message"]

ACTIONLIB = "actionlib"
"""The client of ``World.actions`` that all clients of these topics are."""

STATUS_STEPS = 10
"""Steps between two messages of ``status``: 5 Hz (actionlib, action_server_imp.h: ``status_frequency``)."""

KEPT_RESULTS = 5
"""Latest results that ``status`` still tells: clients wait for that (upstream keeps them for 5 s)."""

_ACTIVE, _PREEMPTED, _SUCCEEDED, _ABORTED, _REJECTED = 1, 2, 3, 4, 5
_ENDS = {SUCCEEDED: _SUCCEEDED, CANCELED: _PREEMPTED, ABORTED: _ABORTED}
"""Numbers of actionlib_msgs, msg/GoalStatus.msg, by those of ROS 2."""


def goal_of(message: TopicMessage, actions: Collection[str]) -> GiveGoal | TakeBackGoal | None:
    """What a message asks of one of these actions; None for other topics."""
    action, _, part = message.topic.rpartition("/")
    if action not in actions or not isinstance(message.msg, dict):
        return None
    if part == "goal":
        goal_id = message.msg.get("goal_id")
        return GiveGoal(ACTIONLIB, _ident(goal_id), action)
    if part == "cancel":
        # Without an identifier it means all goals.
        return TakeBackGoal(ACTIONLIB, _ident(message.msg) or None)
    return None


def _ident(goal_id: Any) -> str:
    ident = goal_id.get("id") if isinstance(goal_id, dict) else None
    return ident if isinstance(ident, str) else ""


def reply_message(reply: ActionReply, time: float) -> TopicMessage:
    """A message on ``feedback`` or ``result`` at simulated ``time``, s."""
    fields = reply.values if isinstance(reply.values, dict) else {}
    text = reply.values if isinstance(reply.values, str) else str(fields.get("text", ""))
    if reply.kind == "feedback":
        status = _status(reply.ident, _ACTIVE, "")
    else:
        status = _status(reply.ident, _ENDS[reply.status] if reply.succeeded else _REJECTED, text)
    message = {"header": _header(time), "status": status, reply.kind: fields}
    return TopicMessage(f"{reply.action}/{reply.kind}", message)


def status_message(action: str, pursued: str | None, ended: Sequence[TopicMessage], time: float) -> TopicMessage:
    """A message on ``status``: the identifier of the goal that is pursued, if there is one, and the latest results."""
    known = [message.msg["status"] for message in ended if message.topic == f"{action}/result"]
    if pursued is not None:
        known.append(_status(pursued, _ACTIVE, ""))
    return TopicMessage(f"{action}/status", {"header": _header(time), "status_list": known})


def _status(ident: str, status: int, text: str) -> dict[str, Any]:
    return {"goal_id": {"stamp": {"secs": 0, "nsecs": 0}, "id": ident}, "status": status, "text": text}


def _header(time: float) -> dict[str, Any]:
    return {"seq": 0, "stamp": {"secs": int(time), "nsecs": int(time % 1 * 1e9)}, "frame_id": ""}
