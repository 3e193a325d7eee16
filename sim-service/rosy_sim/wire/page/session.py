"""Messages of a page about its connection and its room. ``protocol/README.md``, section 4."""

from __future__ import annotations

from typing import Any, Literal

import msgspec

from ...errors import WorkerFailed
from ...sentences import sentence
from ..problem import Sentences, sentences

__all__ = [
    "PROTOCOL",
    "ChooseWorld",
    "Hello",
    "Refusal",
    "Visibility",
    "Visible",
    "WorkerState",
    "WorldShown",
    "refusal",
    "worker_state",
]

PROTOCOL = 1

Visible = Literal["focused", "visible", "hidden"]
"""How much of a page its user sees."""


class ChooseWorld(msgspec.Struct, tag="world", tag_field="op"):
    """A room by name or as JSON."""

    world: Any


class Visibility(msgspec.Struct, tag="visibility", tag_field="op"):
    """Whether the page has the focus, is only visible, or is hidden, as the browser says: it decides about frames."""

    state: Visible


class Hello(msgspec.Struct, tag="hello", tag_field="op", kw_only=True, rename={"in_class": "class"}):
    """The session exists. In class mode ``class`` is true; otherwise it is absent."""

    protocol: int = PROTOCOL
    session: str
    in_class: Literal[True] | msgspec.UnsetType = msgspec.UNSET


class WorkerState(msgspec.Struct, tag="worker", tag_field="op", omit_defaults=True):
    """Status of the worker; ``message`` says why one that has failed cannot start."""

    state: Literal["starting", "ready", "restarting", "failed"]
    message: str = ""
    sentences: Sentences | None = None


def worker_state(
    state: Literal["starting", "ready", "restarting", "failed"], fault: sentence.Sentence | None
) -> WorkerState:
    """The status with the sentence for the learner, where ``fault`` is why no worker can be started."""
    if fault is None:
        return WorkerState(state)
    said = WorkerFailed(fault).sentence
    return WorkerState(state, str(said), sentences(said, None))


class WorldShown(msgspec.Struct, tag="world", tag_field="op"):
    """The room to draw."""

    world: Any


class Refusal(msgspec.Struct, tag="refusal", tag_field="op", omit_defaults=True):
    """The last message could not be served."""

    message: str
    hint: str
    sentences: Sentences | None = None


def refusal(message: sentence.Sentence, hint: sentence.Sentence | None = None) -> Refusal:
    """A refusal in English with its sentences for other languages."""
    return Refusal(str(message), str(hint or ""), sentences(message, hint))
