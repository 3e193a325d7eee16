"""Functions that override each other's commands are found from the commands of a run alone."""

from __future__ import annotations

import pytest

from rosy_sim.run.steps.command_conflicts import CommandConflict, CommandConflicts, senders
from rosy_sim.wire.topics import TopicMessage
from rosy_sim.world.events import Command, velocity

Sent = tuple[int, str, Command]

FORWARD, BACK, SLOW = velocity(0.2, 0.0), velocity(-0.2, 0.0), velocity(0.1, 0.0)
TICK = 5
"""Steps between two ticks: 0.1 s."""


def found(sent: list[Sent]) -> list[CommandConflict]:
    """What is found in a run: a step, a function, and its command."""
    watch = CommandConflicts()
    by_step: dict[int, list[Sent]] = {}
    for one in sorted(sent, key=lambda one: one[0]):
        by_step.setdefault(one[0], []).append(one)
    return [
        conflict
        for step, those in by_step.items()
        for conflict in watch.observe(step, [name for _, name, _ in those], [1] * len(those), [c for *_, c in those])
    ]


def ticks(name: str, command: Command, last: int) -> list[Sent]:
    return [(step, name, command) for step in range(0, last, TICK)]


DRIVE_WINS = [CommandConflict("Velocity", "drive", "backOff")]


def test_a_command_that_the_next_tick_replaces_again_and_again() -> None:
    bumps = [(step, "backOff", BACK) for step in (33, 133, 233)]
    assert found(ticks("drive", FORWARD, 300) + bumps) == DRIVE_WINS


@pytest.mark.parametrize(
    ("why", "sent"),
    [
        ("twice may be chance", ticks("drive", FORWARD, 300) + [(s, "backOff", BACK) for s in (33, 133)]),
        ("the same value changes nothing", ticks("drive", FORWARD, 300) + [(s, "on", FORWARD) for s in (33, 133, 233)]),
        ("a function may change its mind", [(s, "drive", FORWARD if s % 2 else BACK) for s in range(50)]),
        (
            "what held longer than 0.2 s had its effect",
            [
                (s, name, c)
                for n in range(9)
                for s, name, c in ((n * 40, "drive", FORWARD), (n * 40 + 20, "backOff", BACK))
            ],
        ),
        (
            "most of its commands held",
            [(n * 100, "backOff", BACK) for n in range(10)]
            + [(n * 100 + (3 if n > 6 else 50), "drive", FORWARD) for n in range(10)],
        ),
        ("sounds do not hold", [(s, name, Command("Sound", (n,))) for s in range(9) for n, name in enumerate("ab")]),
        ("lights are not velocities", ticks("drive", FORWARD, 99) + ticks("shine", Command("Led1", (1,)), 99)),
    ],
)
def test_no_conflict(why: str, sent: list[Sent]) -> None:
    assert found(sent) == [], why


def test_a_pair_is_reported_once() -> None:
    both = [one for s in range(0, 500, TICK) for one in ((s, "drive", FORWARD), (s, "circle", SLOW))]
    assert found(both) == [CommandConflict("Velocity", "circle", "drive")]


def test_a_command_counts_that_belonged_to_nobody_before() -> None:
    watch = CommandConflicts()
    conflicts: list[CommandConflict] = []
    for step in range(0, 30, 3):
        # Counts that do not match.
        conflicts += watch.observe(step, ["f", "g"], [1], [FORWARD])
        conflicts += watch.observe(step + 1, ["f"], [], [FORWARD])
        conflicts += watch.observe(step + 2, ["g"], [], [BACK])
    assert CommandConflict("Velocity", "g", "f") in conflicts


def test_lights_conflict_too() -> None:
    red, green = Command("Led1", (3,)), Command("Led1", (1,))
    bumps = [(step, "bumpLamp", red) for step in (33, 133, 233)]
    assert found(ticks("glow", green, 300) + bumps) == [CommandConflict("Led1", "glow", "bumpLamp")]


def test_commands_are_counted_out_to_the_functions_that_fired() -> None:
    own = TopicMessage("/mine", {})
    assert senders(["a", "b", "c"], [1, 0, 2], [FORWARD, BACK, own]) == [("a", FORWARD), ("c", BACK), ("c", own)]


def test_one_function_sent_everything() -> None:
    assert senders(["a"], [], [FORWARD, BACK]) == [("a", FORWARD), ("a", BACK)]
    assert senders(["a", "b"], [], []) == []


def test_lines_that_main_prints_come_first_and_belong_to_no_function() -> None:
    printed = Command("Say", ("hello",))
    assert senders(["a", "b"], [1, 1], [printed, FORWARD, BACK]) == [("a", FORWARD), ("b", BACK)]


def test_counts_that_do_not_match_tell_nothing() -> None:
    assert senders(["a", "b"], [1, 2], [FORWARD]) == []
    assert senders(["a", "b"], [1], [FORWARD]) == []
