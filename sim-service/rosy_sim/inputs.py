"""The input file of ``./rosy run``: what hands do to the robot, and when."""

from __future__ import annotations

import math
from pathlib import Path

import msgspec

from .errors import BadInput
from .library import read_text
from .wire.hands import TimedHand, hands_of
from .world.events import Hand

__all__ = ["read_inputs"]


def read_inputs(path: Path) -> list[tuple[float, Hand]]:
    """
    The hands of an input file, by time.

    Raises:
        BadInput: a line is not an input; the sentence says which.
    """
    found: list[tuple[float, Hand]] = []
    decoder = msgspec.json.Decoder(TimedHand)
    for number, line in enumerate(read_text(path, "list of inputs").splitlines(), 1):
        if not line.strip():
            continue
        try:
            message = decoder.decode(line)
        except (msgspec.DecodeError, RecursionError) as error:
            raise BadInput(f"Line {number} of {path} is not an input: {error}.") from error
        hands = hands_of(message)
        if not hands or not (math.isfinite(message.t) and message.t >= 0):
            raise BadInput(f"Line {number} of {path} is not an input: it needs a time t and something to do.")
        found += [(message.t, hand) for hand in hands]
    return sorted(found, key=lambda item: item[0])
