"""Programs that differ in comments, layout and names of their own only have one fingerprint."""

from __future__ import annotations

import json

import pytest

from rosy_sim.classroom.program_fingerprint import fingerprint, source_of

PROGRAM = """
import Rosy

-- | Backs off.
backOff :: Bumper -> Velocity
backOff hit = Velocity speed 0
  where speed = -0.3 {- m/s {- backwards -} -}

main = simulate (backOff, \\tick -> "--no {- comment")
"""

SAME = [
    PROGRAM.replace("-- | Backs off.\n", ""),
    PROGRAM.replace("{- m/s {- backwards -} -}", "-- backwards"),
    PROGRAM.replace("\n  where", " where").replace("(", "( ").replace("\n\n", "\n \n\n"),
    PROGRAM.replace("backOff", "mine").replace("hit", "b").replace("speed", "v'").replace("tick", "x"),
]

OTHER = [
    PROGRAM.replace("-0.3", "-0.4"),
    PROGRAM.replace("Bumper", "Cliff"),
    PROGRAM.replace("simulate", "simulateTask"),
    PROGRAM.replace("--no {- comment", "--yes {- comment"),
    PROGRAM.replace("Velocity speed 0", "Velocity 0 speed"),
    PROGRAM.replace("-- | Backs off.\n", "x = 1\n"),
    "",
]


@pytest.mark.parametrize("source", SAME)
def test_comments_layout_and_names_of_ones_own_make_no_difference(source: str) -> None:
    assert source != PROGRAM
    assert fingerprint(source) == fingerprint(PROGRAM)


@pytest.mark.parametrize("source", OTHER)
def test_anything_else_does(source: str) -> None:
    assert fingerprint(source) != fingerprint(PROGRAM)


def test_two_names_are_not_one() -> None:
    assert fingerprint("f x y = x\n") == fingerprint("f y x = y\n")
    assert fingerprint("f x y = x\n") != fingerprint("f x y = y\n")


@pytest.mark.parametrize(
    "source", ["{-", "-}", '"', "{- -} -}", "\\", "'", "--", "\ud800", "{-" * 50_000, '"\\' * 50_000]
)
def test_nonsense_has_a_fingerprint(source: str) -> None:
    assert len(fingerprint(source)) == 64


def test_the_text_of_a_project_file_counts() -> None:
    assert source_of(json.dumps({"rosy": 1, "name": "walk", "haskell": PROGRAM})) == PROGRAM
    assert source_of(PROGRAM) == PROGRAM
    assert source_of('{"haskell": 1}') == '{"haskell": 1}'
