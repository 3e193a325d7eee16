"""
Goals that clients give to the robot's own programs (ROS actions), such as driving into the dock.

In: goals and cancellations of clients, one step after the other. Out: velocities while a goal is pursued, and replies
for each client. One goal is pursued at a time; another one is rejected, as upstream's programs do.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

from .robot import CANCELED, ActionDrive, Finished, Surroundings

__all__ = ["ActionGoals", "ActionReply", "RejectedGoal"]


class RejectedGoal(ValueError):
    """A goal that makes no sense; the text says why."""


class ActionReply(NamedTuple):
    """What a client is told of its goal; the values of a goal that was not pursued are the reason."""

    kind: Literal["feedback", "result"]
    ident: str
    action: str
    values: dict[str, Any] | str
    status: int = 0
    succeeded: bool = True


FEEDBACK_STEPS = 10
"""Steps between two messages of feedback: 5 Hz. Our choice; upstream sends one for each of its sensor messages."""


@dataclass(slots=True)
class _Pursued:
    client: str
    ident: str
    action: str
    drive: ActionDrive
    steps: int = 0


class ActionGoals:
    """
    Of one robot.

    Args:
        actions: what makes the drive of each action from the message of a goal, by the name of the action.
    """

    def __init__(self, actions: Mapping[str, Callable[[Mapping[str, Any]], ActionDrive]]) -> None:
        self._actions = actions
        self._pursued: _Pursued | None = None
        self._replies: dict[str, list[ActionReply]] = {}

    @property
    def names(self) -> Collection[str]:
        """The actions that there are."""
        return self._actions.keys()

    def pursued_for(self, client: str) -> str | None:
        """The identifier of the client's goal that is pursued, if there is one."""
        return self._pursued.ident if self._pursued is not None and self._pursued.client == client else None

    @property
    def is_pursuing(self) -> bool:
        """Whether a goal drives the robot."""
        return self._pursued is not None

    def send(self, client: str, ident: str, action: str, goal: Mapping[str, Any]) -> bool:
        """A client gives a goal, a message as JSON. Whether the robot has such an action."""
        make = self._actions.get(action)
        if make is None:
            self._reply(client, ActionReply("result", ident, action, "No action server available", succeeded=False))
        elif self._pursued is not None:
            self._reply(client, ActionReply("result", ident, action, "Action goal was rejected", succeeded=False))
        else:
            try:
                self._pursued = _Pursued(client, ident, action, make(goal))
            except RejectedGoal as why:
                text = f"Action goal was rejected: {why}"
                self._reply(client, ActionReply("result", ident, action, text, succeeded=False))
        return make is not None

    def cancel(self, client: str, ident: str | None = None) -> bool:
        """A client takes back a goal, or leaves. Whether the robot was driven by it and must stand now."""
        pursued = self._pursued
        if pursued is None or pursued.client != client or ident not in (None, pursued.ident):
            return False
        self._pursued = None
        self._reply(client, ActionReply("result", pursued.ident, pursued.action, pursued.drive.canceled(), CANCELED))
        return True

    def step(self, robot: Surroundings) -> tuple[float, float] | None:
        """The velocity of the next step, m/s and rad/s; none while no goal is pursued."""
        pursued = self._pursued
        if pursued is None:
            return None
        now = pursued.drive.step(robot)
        if isinstance(now, Finished):
            self._pursued = None
            self._reply(pursued.client, ActionReply("result", pursued.ident, pursued.action, now.result, now.status))
            return (0.0, 0.0)
        if pursued.steps % FEEDBACK_STEPS == 0:
            self._reply(pursued.client, ActionReply("feedback", pursued.ident, pursued.action, now.feedback))
        pursued.steps += 1
        return (now.linear, now.angular)

    def take_replies(self, client: str) -> list[ActionReply]:
        """The replies to a client since the last call."""
        return self._replies.pop(client, [])

    def _reply(self, client: str, reply: ActionReply) -> None:
        self._replies.setdefault(client, []).append(reply)
