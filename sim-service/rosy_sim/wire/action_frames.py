"""
Frames of rosbridge v2 that answer calls of actions and services (rosbridge v2.0 Protocol Specification, 3.2.14, 3.2.15
and 3.3.9): on the robot link for programs, on a WebSocket for ROS clients.
"""

from __future__ import annotations

from typing import Any

from ..world.action_goals import ActionReply
from .link_messages import SendActionGoal

__all__ = ["NO_SERVICE", "has_substitute", "reply_frame", "service_failure"]

NO_SERVICE = "Service {service} does not exist"
"""What rosbridge_library, internal/services.py says of it."""

_SUBSTITUTED = ("undock", "drive_distance", "rotate_angle")
"""Actions in whose place a program drives by itself (Rosy.Action)."""


def has_substitute(goal: SendActionGoal) -> bool:
    """Whether the program goes on by itself when there is no server."""
    return goal.action in _SUBSTITUTED


def reply_frame(reply: ActionReply, action: str | None = None) -> dict[str, Any]:
    """The frame of a reply, with the action as the client has written it."""
    frame: dict[str, Any] = {"op": f"action_{reply.kind}", "id": reply.ident, "action": action or reply.action}
    frame["values"] = reply.values
    if reply.kind == "result":
        frame |= {"status": reply.status, "result": reply.succeeded}
    return frame


def service_failure(ident: str, service: str) -> dict[str, Any]:
    """The frame that says that there is no such service."""
    why = NO_SERVICE.format(service=service)
    return {"op": "service_response", "id": ident, "service": service, "values": why, "result": False}
