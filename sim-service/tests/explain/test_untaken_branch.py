"""Why not this case? Choices found from the places of branches, and the answers about branches that were not taken."""

from __future__ import annotations

import pytest

from rosy_sim.explain.recorded_run import RecordedRun
from rosy_sim.explain.untaken_branch import branch_at, choice_of, why_not_taken
from rosy_sim.explain.why_not import FunctionType, Window
from rosy_sim.wire.firing import Branch, Cause, Firing, Place


def branch(names: str, kind: str, number: int, text: str, start: tuple[int, int], end: tuple[int, int]) -> Branch:
    return Branch(names.split("."), kind, number, text, Place(*start), Place(*end))  # type: ignore[arg-type]


# play (Bumper _ Pressed)
#   | loud = case side of { LeftBumper -> (if low then 1 else 2) + (if high then 3 else 4); _ -> 5 }
#   | otherwise = go 1
#   where go 0 = 6
#         go _ = 7
# play (Bumper _ Released) = 8
LOUD = branch("play", "equation", 1, "play (Bumper _ Pressed) | loud", (2, 5), (2, 99))
QUIET = branch("play", "equation", 1, "play (Bumper _ Pressed) | otherwise", (3, 5), (3, 22))
RELEASED = branch("play", "equation", 2, "play (Bumper _ Released)", (6, 1), (6, 29))
LEFT = branch("play", "case", 1, "LeftBumper", (2, 20), (2, 80))
OTHER_SIDE = branch("play", "case", 2, "_", (2, 82), (2, 90))
LOW = branch("play", "then", 1, "low", (2, 40), (2, 41))
NOT_LOW = branch("play", "else", 2, "low", (2, 44), (2, 45))
HIGH = branch("play", "then", 1, "high", (2, 60), (2, 61))
NOT_HIGH = branch("play", "else", 2, "high", (2, 64), (2, 65))
GO_0 = branch("play.go", "equation", 1, "go 0", (4, 9), (4, 17))
GO_ANY = branch("play.go", "equation", 2, "go _", (5, 9), (5, 17))
# Inner branches are numbered before those around them.
ALL = [LOW, NOT_LOW, HIGH, NOT_HIGH, LEFT, OTHER_SIDE, LOUD, QUIET, GO_0, GO_ANY, RELEASED]

FUNCTIONS = [FunctionType("play", ("Bumper",), ("Sound",))]


@pytest.mark.parametrize(
    ("asked", "choice"),
    [
        (LOUD, [LOUD, QUIET, RELEASED]),
        (RELEASED, [LOUD, QUIET, RELEASED]),
        (OTHER_SIDE, [LEFT, OTHER_SIDE]),
        (LOW, [LOW, NOT_LOW]),
        (NOT_HIGH, [HIGH, NOT_HIGH]),
        (GO_ANY, [GO_0, GO_ANY]),
    ],
)
def test_a_choice_has_the_branches_that_can_be_taken_in_place_of_one(asked: Branch, choice: list[Branch]) -> None:
    assert choice_of(ALL, asked) == choice


def test_a_branch_is_found_by_its_place() -> None:
    assert branch_at(ALL, Place(2, 44), Place(2, 45)) == NOT_LOW
    assert branch_at(ALL, Place(2, 44), Place(2, 46)) is None


def run(*fired: tuple[float, list[Branch]]) -> RecordedRun:
    told = RecordedRun()
    for number, (time, branches) in enumerate(fired):
        told.add_step(time, [Firing(number, "play", 0, Cause("message", "Bumper"), [], [], branches)], [], [])
    told.add_step(9.0, [], [], [])
    return told


def answers(told: RecordedRun, asked: Branch, since: float = 0.0, until: float = 9.0) -> list[str]:
    return [link.sentence for link in why_not_taken(told, FUNCTIONS, ALL, asked, Window(since, until))]


def test_another_branch_of_the_choice_was_taken() -> None:
    told = run((1.0, [LOUD, LEFT, LOW, NOT_HIGH]), (2.0, [RELEASED]))
    ran = "At 2.00 s **play** ran and gave nothing."
    matched = "Equation 2 of **play** matched: `play (Bumper _ Released)`."
    assert answers(told, QUIET) == [ran, matched]
    assert answers(told, HIGH) == ["At 1.00 s **play** ran and gave nothing.", "In **play** `high` was not true."]
    # The choice around it was decided otherwise.
    assert answers(told, HIGH, since=1.5) == [ran, matched]
    assert answers(told, OTHER_SIDE)[1] == "In **play** case 1 matched: `LeftBumper`."


def test_it_was_taken() -> None:
    told = run((1.0, [LOUD, LEFT, LOW, HIGH]))
    assert answers(told, LOW) == ["**play** did take this case, at 1.00 s."]


def test_no_function_came_to_the_choice() -> None:
    told = run((1.0, [LOUD, LEFT, LOW, HIGH]))
    assert answers(told, GO_ANY) == ["Between 0.00 s and 9.00 s no function came to this choice in **go**."]


def test_the_function_did_not_run() -> None:
    told = run((1.0, [LOUD]))
    assert answers(told, QUIET, since=2.0, until=4.0) == [
        "**play** takes a `Bumper`; none came between 2.00 s and 4.00 s. None had come before."
    ]
    assert answers(told, GO_0, since=12.0, until=14.0) == ["The run had ended at 9.00 s."]
