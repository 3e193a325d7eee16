"""The input file of ``./rosy run``: actions of a user on the robot and messages on topics, with their times."""

from __future__ import annotations

import math
from pathlib import Path

import msgspec

from ..errors import BadInput
from ..files import read_text
from ..sentences.sentence import tr
from ..wire.topics import BadMessage
from ..wire.user_input import Published, TimedInput, published, user_actions
from ..world.events import UserAction

__all__ = ["read_inputs"]


def read_inputs(path: Path) -> list[tuple[float, UserAction | Published]]:
    """
    The actions of an input file, by time.

    Raises:
        BadInput: a line is not an input; the sentence says which.
    """
    found: list[tuple[float, UserAction | Published]] = []
    decoder = msgspec.json.Decoder(TimedInput)
    for number, line in enumerate(read_text(path, tr("list of inputs")).split("\n"), 1):
        if not line.strip():
            continue
        try:
            message = decoder.decode(line)
            actions: list[UserAction | Published] = [*user_actions(message), *published(message)]
        except (msgspec.DecodeError, RecursionError, BadMessage) as error:
            raise BadInput(
                tr("Line {number} of {path} is not an input: {why}.", number=number, path=path, why=error)
            ) from error
        if not actions or not (math.isfinite(message.t) and message.t >= 0):
            raise BadInput(
                tr(
                    "Line {number} of {path} is not an input: it needs a time t and something to do.",
                    number=number,
                    path=path,
                )
            )
        found += [(message.t, action) for action in actions]
    return sorted(found, key=lambda item: item[0])
