"""Synonyms of a program's types: under which name an explanation speaks of a memory."""

from __future__ import annotations

import json

import pytest

from rosy_sim.explain.function_types import with_synonyms, written_memories
from rosy_sim.explain.wording import english
from rosy_sim.wire.explanation import Sentence

HIT = {"type": "Memory Hit", "is": "Memory Bool"}
LIT = {"type": "Memory Lit", "is": "Memory Bool"}
PLAIN = {"type": "Memory Bool"}
TALLY = {"type": "Tally", "is": "Memory Int"}
NOTE = {"type": "Param Note", "is": "Param String"}
SPEED = {"type": "Go", "is": "Velocity"}


def graph(*shapes: object) -> bytes:
    function = {"kind": "function", "name": "f", "inputs": shapes[1:], "output": shapes[0]}
    return json.dumps({"parts": [{"kind": "task", "name": "t", "start": [], "parts": [function]}]}).encode()


@pytest.mark.parametrize(
    ("shapes", "names"),
    [
        ((HIT,), {"Memory Bool": "Memory Hit"}),
        ((HIT, {"maybe": HIT}), {"Memory Bool": "Memory Hit"}),
        # Where it writes the type itself as well, the one synonym says more.
        ((PLAIN, HIT), {"Memory Bool": "Memory Hit"}),
        ((HIT, LIT), {}),
        ((PLAIN,), {}),
        (
            ({"all": [TALLY, {"either": [SPEED, {"each": NOTE}]}]},),
            {"Memory Int": "Tally", "Param [Char]": "Param Note"},
        ),
    ],
)
def test_a_memory_has_the_one_synonym_under_which_the_program_writes_it(
    shapes: tuple[object, ...], names: dict[str, str]
) -> None:
    assert written_memories(graph(*shapes)) == names


def test_a_sentence_speaks_of_a_memory_by_its_synonym() -> None:
    names = written_memories(graph(HIT))
    said = with_synonyms(Sentence("remembered", type="Memory Bool", value="True", since=3.42, other="bump"), names)
    assert english(said) == "`Memory Hit` was `True` since 3.42 s: **bump** remembered it."
    never = with_synonyms(Sentence("lacks", function="f", types=["Bumper", "Memory Bool"], since=0, until=1), names)
    assert never.types == ["Bumper", "Memory Hit"]
