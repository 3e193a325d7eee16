"""Why was it sent? Questions about recorded runs, each with the sentences of its answer."""

from __future__ import annotations

import pytest

from rosy_sim.explain.causal_chain import MAX_LINKS, commands_at, explain
from rosy_sim.explain.recorded_run import RecordedRun
from rosy_sim.explain.recorded_step import ShownCommand
from rosy_sim.explain.why_not import RobotLimits
from rosy_sim.wire.firing import Branch, Cause, Firing, Given, Place

from .recorded import recorded

LIMITS = RobotLimits(0.7, 3.14)

FORWARD_BACKWARD = """
    3.40 forwardBackward <- Odometry | Memory False, Velocity 0.5 0.0 -> Velocity 1.0 0.0
    3.42 bump <- Bumper CenterBumper Pressed | Bumper CenterBumper Pressed -> Memory True
    3.50 forwardBackward <- Odometry | Memory True @1, Velocity 0.0 0.0 -> Velocity (-0.5) 0.0
"""

RANDOM_WALK = """
    0.00 change <- start -> event ChgDir
    0.00 turn <- event 0 | ChgDir, Seconds 0.0 -> Velocity 0.0 1.0
    1.10 watch <- tick | Seconds 1.1, Memory 1 -> event ChgDir
    1.10 turn <- event 2 | ChgDir, Seconds 1.1 -> Velocity 0.0 (-1.0)
"""

TASKS = """
    0.00 in 1 ahead <- start -> Velocity 0.5 0.0
    1.00 in 1 untilBump <- Bumper LeftBumper Pressed | Bumper LeftBumper Pressed -> Done ()
    1.00 in 2 say <- by 1 -> Say "ouch"
    3.00 in 3 red <- wait -> Led1 Red
    3.10 in 3 caller <- Button Button0 Pressed | Button Button0 Pressed -> call
    3.10 in 4 inside <- by 4 -> Led2 Green
    4.00 ! sent Velocity 0.0 0.0
    5.00 in 3 off <- end -> Led1 Black
"""

JOINED = """
    1.00 ! Button Button1 Pressed
    2.00 both <- Bumper RightBumper Released | Button Button1 Pressed, Bumper RightBumper Released -> Sound
"""

COUNTER = """
    0.00 count <- tick | Memory 0 -> Memory 1
    0.10 count <- tick | Memory 1 @0 -> Memory 2
    0.12 tell <- Cliff LeftCliff Hole | Cliff LeftCliff Hole, Memory 2 @1 -> Say "2"
"""

BLOCKED = """
    1.00 ! Bumper CenterBumper Pressed
    1.10 move <- tick -> Velocity 2.0 0.0
    1.20 move <- tick -> Velocity 0.5 0.0
"""

SILENT = """
    0.00 count <- tick | Memory 0 -> Memory 1
"""


PRESSED_TWICE = """
0.1 drive <- tick | Memory False -> Velocity 0.5 0.0
0.5 bump <- Bumper CenterBumper Released -> Memory False
1.0 drive <- tick | Memory False @1 -> Velocity 0.5 0.0
2.0 bump <- Bumper CenterBumper Pressed -> Memory True
3.0 press <- Button Button1 Pressed -> Memory True
4.9 bump <- Bumper CenterBumper Pressed -> Memory True
5.0 drive <- tick | Memory True @5 -> Velocity (-0.5) 0.0
"""


@pytest.mark.parametrize(
    ("story", "time", "answer"),
    [
        (
            BLOCKED,
            None,
            [
                "At 1.20 s **move** sent `Velocity 0.5 0.0`.",
                "Something is in its way: the centre bumper was pressed at 1.00 s, and has not been released.",
                "**move** ran at 1.20 s because it runs ten times a second.",
            ],
        ),
        (
            BLOCKED,
            1.1,
            [
                "At 1.10 s **move** sent `Velocity 2.0 0.0`.",
                "`Velocity 2.0 0.0` asks for 2 m/s; the robot's limit is 0.7 m/s.",
                "**move** ran at 1.10 s because it runs ten times a second.",
            ],
        ),
        (
            FORWARD_BACKWARD,
            None,
            [
                "At 3.50 s **forwardBackward** sent `Velocity (-0.5) 0.0` for `Memory True` and `Velocity 0.0 0.0`.",
                "`Memory Bool` was `True` since 3.42 s: **bump** remembered it.",
                "**forwardBackward** ran at 3.50 s because the robot reported its motion.",
                "**bump** ran at 3.42 s because the centre bumper was pressed.",
            ],
        ),
        (
            FORWARD_BACKWARD,
            3.4,
            [
                "At 3.40 s **forwardBackward** sent `Velocity 1.0 0.0` for `Memory False` and `Velocity 0.5 0.0`.",
                "`Velocity 1.0 0.0` asks for 1 m/s; the robot's limit is 0.7 m/s.",
                "`Memory Bool` was `False`, its first value: no function had written it.",
                "**forwardBackward** ran at 3.40 s because the robot reported its motion.",
            ],
        ),
        (
            FORWARD_BACKWARD,
            3.42,
            [
                "No command was sent at 3.42 s.",
                "At 3.40 s **forwardBackward** sent `Velocity 1.0 0.0` for `Memory False` and `Velocity 0.5 0.0`.",
                "`Velocity 1.0 0.0` asks for 1 m/s; the robot's limit is 0.7 m/s.",
                "`Memory Bool` was `False`, its first value: no function had written it.",
                "**forwardBackward** ran at 3.40 s because the robot reported its motion.",
            ],
        ),
        (FORWARD_BACKWARD, 1.0, ["No command was sent at 1.00 s."]),
        (FORWARD_BACKWARD, 9.0, ["The run had ended at 3.50 s."]),
        (FORWARD_BACKWARD, -1.0, ["The run had not begun."]),
        (
            RANDOM_WALK,
            None,
            [
                "At 1.10 s **turn** sent `Velocity 0.0 (-1.0)` for `ChgDir` and `Seconds 1.1`.",
                "**turn** ran at 1.10 s because **watch** sent `ChgDir`.",
                "`Memory Int` was `1`, its first value: no function had written it.",
                "**watch** ran at 1.10 s because it runs ten times a second.",
            ],
        ),
        (
            RANDOM_WALK,
            0.0,
            [
                "At 0.00 s **turn** sent `Velocity 0.0 1.0` for `ChgDir` and `Seconds 0.0`.",
                "**turn** ran at 0.00 s because **change** sent `ChgDir`.",
                "**change** ran at 0.00 s because the program began.",
            ],
        ),
        (
            TASKS,
            0.0,
            [
                "At 0.00 s **ahead** sent `Velocity 0.5 0.0`.",
                "**ahead** ran at 0.00 s because the program began.",
            ],
        ),
        (
            TASKS,
            1.0,
            [
                'At 1.00 s **say** sent `Say "ouch"`.',
                "**say** ran at 1.00 s because **untilBump** ended its task with `Done` at 1.00 s.",
                "**untilBump** ran at 1.00 s because the left bumper was pressed.",
            ],
        ),
        (TASKS, 3.0, ["At 3.00 s **red** sent `Led1 Red`.", "**red** ran at 3.00 s because a wait was over."]),
        (
            TASKS,
            3.1,
            [
                "At 3.10 s **inside** sent `Led2 Green`.",
                "**inside** ran at 3.10 s because **caller** called a task at 3.10 s.",
                "**caller** ran at 3.10 s because button 0 was pressed.",
            ],
        ),
        (
            TASKS,
            4.0,
            [
                "At 4.00 s the robot was told `Velocity 0.0 0.0`, "
                "because the task that had set it in motion was stopped."
            ],
        ),
        (TASKS, None, ["At 5.00 s **off** sent `Led1 Black`.", "**off** ran at 5.00 s because the program ended."]),
        (
            JOINED,
            None,
            [
                "At 2.00 s **both** sent `Sound` for `Button Button1 Pressed` and `Bumper RightBumper Released`.",
                "`Button Button1 Pressed` had come at 1.00 s.",
                "**both** ran at 2.00 s because the right bumper was released.",
            ],
        ),
        (
            COUNTER,
            None,
            [
                'At 0.12 s **tell** sent `Say "2"` for `Cliff LeftCliff Hole` and `Memory 2`.',
                "`Memory Int` was `2` since 0.10 s: **count** remembered it.",
                "**tell** ran at 0.12 s because the left cliff sensor saw a hole.",
                "`Memory Int` was `1` since 0.00 s: **count** remembered it.",
                "**count** ran at 0.10 s because it runs ten times a second.",
                "`Memory Int` was `0`, its first value: no function had written it.",
                "**count** ran at 0.00 s because it runs ten times a second.",
            ],
        ),
        (
            PRESSED_TWICE,
            None,
            [
                "At 5.00 s **drive** sent `Velocity (-0.5) 0.0` for `Memory True`.",
                "`Memory Bool` was `True` since 2.00 s: **bump** remembered it.",
                "**drive** ran at 5.00 s because it runs ten times a second.",
                "**bump** ran at 2.00 s because the centre bumper was pressed.",
            ],
        ),
        (
            PRESSED_TWICE,
            1.0,
            [
                "At 1.00 s **drive** sent `Velocity 0.5 0.0` for `Memory False`.",
                "`Memory Bool` was `False` from the start: what was remembered since then was the same.",
                "**drive** ran at 1.00 s because it runs ten times a second.",
                "**bump** ran at 0.50 s because the centre bumper was released.",
            ],
        ),
        (SILENT, None, ["The program has sent no command."]),
    ],
)
def test_the_answer_is(story: str, time: float | None, answer: list[str]) -> None:
    assert [link.sentence for link in explain(recorded(story), LIMITS, time)] == answer


def test_a_long_chain_ends() -> None:
    chain = "\n".join(
        f"{i / 10:.2f} f{i} <- tick | Memory {i} @{i - 1} -> Memory {i + 1}, Say {i}" for i in range(1, 100)
    )
    run = recorded("0.00 f0 <- tick | Memory 0 -> Memory 1\n" + chain)
    assert len(explain(run, LIMITS)) == MAX_LINKS


def test_a_command_is_matched_with_the_firing_that_sent_it() -> None:
    run = recorded("1.00 ! sent Velocity 0.0 0.0\n1.00 f <- tick -> Velocity 0.5 0.0\n1.00 ! sent Velocity 0.0 0.0")
    assert [(one.value, one.firing and one.firing.function) for one in commands_at(run, 1.0)] == [
        ("Velocity 0.0 0.0", None),
        ("Velocity 0.5 0.0", "f"),
        ("Velocity 0.0 0.0", None),
    ]


def test_an_empty_run_has_sent_nothing() -> None:
    assert [link.sentence for link in explain(RecordedRun(), LIMITS)] == ["The program has sent no command."]


def branch(kind: str, number: int, text: str, *names: str) -> Branch:
    return Branch(list(names), kind, number, text, Place(1, 1), Place(1, 9))  # type: ignore[arg-type]


def test_it_tells_the_branches_that_the_function_and_its_local_functions_took() -> None:
    run = RecordedRun()
    branches = [
        branch("equation", 1, "helper x", "helper"),
        branch("equation", 2, "play _", "play"),
        branch("guard", 1, "v > 0.5", "play", "slow"),
        branch("then", 1, "hit", "play"),
    ]
    firing = Firing(
        0, "play", 0, Cause("tick"), gave=[Given("command", "Velocity 0.0 0.0", "Velocity")], branches=branches
    )
    run.add_step(1.0, [firing], [], [ShownCommand("Velocity", "Velocity 0.0 0.0")])
    assert [link.sentence for link in explain(run, LIMITS)] == [
        "At 1.00 s **play** sent `Velocity 0.0 0.0`.",
        "Equation 2 of **play** matched: `play _`.",
        "In **slow** the guard `v > 0.5` held.",
        "**play** ran at 1.00 s because it runs ten times a second.",
    ]
