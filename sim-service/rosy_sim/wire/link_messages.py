"""Messages of a program on the robot link, as ``protocol/README.md`` section 2 has them."""

from __future__ import annotations

from typing import Any, Literal

import msgspec

from .problem import Problem

__all__ = [
    "NO_FIRINGS",
    "Advertise",
    "CallService",
    "CancelActionGoal",
    "Ended",
    "MemoryValue",
    "ProgramLine",
    "Publish",
    "Ready",
    "SendActionGoal",
    "Settled",
    "Subscribe",
]


class Publish(msgspec.Struct, tag="publish", tag_field="op"):
    """A command message, not yet read."""

    topic: str
    msg: msgspec.Raw


class SendActionGoal(msgspec.Struct, tag="send_action_goal", tag_field="op"):
    """A goal for a program of the robot. An action without a slash is one that the robot's description names."""

    id: str
    action: str
    args: dict[str, Any] = {}


class CancelActionGoal(msgspec.Struct, tag="cancel_action_goal", tag_field="op"):
    """The goal of this identifier is taken back."""

    id: str
    action: str


class CallService(msgspec.Struct, tag="call_service", tag_field="op"):
    """A request to a service."""

    id: str
    service: str


class MemoryValue(msgspec.Struct):
    """A value that the program remembers: its type and the value, as Haskell writes them."""

    type: str
    value: str


NO_FIRINGS = msgspec.Raw(b"[]")
"""``firings`` of a step that was not observed. What a program tells is read by ``firing.read_firings``."""


class Settled(msgspec.Struct, tag="settled", tag_field="op"):
    """
    The end of the program's batch. ``sent`` is the number of commands of each function in ``fired``, absent when one
    function sent all of them. ``commands`` and ``events`` only with trace; ``memory`` only when the step asked for it
    and it is not what the program told last; ``firings`` only when the step asked for them. ``quiet`` is the number of
    the next steps in which nothing can fire as long as no event happens and no message arrives, ``listens`` the
    channels measured on demand that it takes.
    """

    step: int
    fired: list[str] = []
    sent: list[int] = []
    sensed: list[str] = []
    events: list[str] = []
    commands: list[str] = []
    memory: list[MemoryValue] | None = None
    firings: msgspec.Raw = NO_FIRINGS
    quiet: int = 0
    listens: list[str] = []


class Ended(msgspec.Struct, tag="ended", tag_field="op"):
    """The program's last line, in place of the last step's ``Settled``."""

    how: Literal["done", "error", "stopped"]
    problem: Problem | None = None
    fired: list[str] = []
    sent: list[int] = []
    sensed: list[str] = []
    events: list[str] = []
    commands: list[str] = []
    firings: msgspec.Raw = NO_FIRINGS


class Advertise(msgspec.Struct, tag="advertise", tag_field="op"):
    """The program will give commands on a topic."""

    topic: str
    type: str = ""


class Subscribe(msgspec.Struct, tag="subscribe", tag_field="op"):
    """The program wants a sensor topic."""

    topic: str
    type: str = ""


class Ready(msgspec.Struct, tag="ready", tag_field="op"):
    """The program has said what it wants, and whether it uses its mailbox."""

    mailbox: bool = False


ProgramLine = (
    Publish | SendActionGoal | CancelActionGoal | CallService | Settled | Ended | Advertise | Subscribe | Ready
)
"""What a program says in a line."""
