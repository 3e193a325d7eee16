"""Why not? Questions about recorded runs, each with its answer."""

# ruff: noqa: E501 (one question with its answer per line)

from __future__ import annotations

import pytest

from rosy_sim.explain.answers import why_event
from rosy_sim.explain.recorded_run import RecordedRun
from rosy_sim.explain.recorded_step import ShownCommand
from rosy_sim.explain.why_not import (
    FunctionType,
    RobotLimits,
    Window,
    hindrance,
    why_no_effect,
    why_not_received,
    why_not_run,
    why_not_sent,
)
from rosy_sim.robot_description import type_roles
from rosy_sim.robots.kobuki.facts import MAX_ANGULAR_SPEED, MAX_SPEED

from .recorded import recorded

LIMITS = RobotLimits(MAX_SPEED, MAX_ANGULAR_SPEED)

FUNCTIONS = [
    FunctionType("play", ("Bumper",), ("Sound", "Led1")),
    FunctionType("left", ("BumperLeft",), ("Led1", "Led2")),
    FunctionType("alarm", ("Either Cliff Wheel", "Memory Bool"), ("Sound",)),
    FunctionType("nested", ("Either (Either Bumper Cliff) (Maybe Wheel)",), ("Sound",)),
    FunctionType("pair", ("Bumper", "Button"), ("Led2",)),
    FunctionType("drive", ("Seconds",), ("Velocity",)),
    FunctionType("avoid", ("Velocity", "Bumper"), ("Velocity",)),
    FunctionType("change", ("Button",), ("ChgDir",)),
    FunctionType("turn", ("ChgDir", "StdGen"), ("Velocity",)),
    FunctionType("shout", ("Button",), ("Lost",)),
    FunctionType("never", ("Button",), ("Found",)),
    FunctionType("ahead", ("Seconds",), ("Velocity",)),
    FunctionType("untilBump", ("Bumper",), ("Done ()",)),
    FunctionType("hear", ("Late",), ("Say",)),
    FunctionType("late", ("Button",), ("Late",)),
    FunctionType("begin", ("Position",), ("Memory Int",), ("begin", "go"), is_start=True),
    FunctionType("go", ("Position",), ("Velocity",), ("begin", "go")),
    FunctionType("listen", ("Button",), ("Memory Int",), ("listen", "follow"), is_start=True),
    FunctionType("follow", ("Position",), ("Velocity",), ("listen", "follow")),
]

BUMPS = """
    1.00 play <- Bumper LeftBumper Pressed | Bumper LeftBumper Pressed -> Sound
    1.00 left <- Bumper LeftBumper Pressed | BumperLeft Pressed -> Led1 Red
    1.20 play <- Bumper LeftBumper Released | Bumper LeftBumper Released
    5.00 play <- Bumper RightBumper Pressed | Bumper RightBumper Pressed -> Sound
    5.10 alarm <- Cliff LeftCliff Hole | Cliff LeftCliff Hole, Memory False -> Sound
    6.00 ! Button Button0 Pressed
"""

REPLACED = """
    3.40 avoid <- Bumper CenterBumper Pressed | Velocity 0.5 0.0, Bumper CenterBumper Pressed -> Velocity (-0.5) 0.0
    3.42 drive <- tick | Seconds 3.4 -> Velocity 0.5 0.0
    4.00 avoid <- Bumper CenterBumper Released | Velocity 0.5 0.0, Bumper CenterBumper Released -> Velocity 0.1 0.0
    4.00 drive <- tick | Seconds 4.0 -> Velocity 0.5 0.0
    4.10 drive <- tick | Seconds 4.1 -> Velocity 0.5 0.0
"""

TASKS = """
    0.00 in 1 ahead <- tick | Seconds 0.0 -> Velocity 0.5 0.0
    3.10 in 1 untilBump <- Bumper LeftBumper Pressed | Bumper LeftBumper Pressed -> Done ()
    3.10 ! sent Velocity 0.0 0.0
    4.00 in 2 play <- Bumper RightBumper Pressed | Bumper RightBumper Pressed -> Sound, Led1 Red
"""

EVENTS = """
    1.00 change <- Button Button0 Pressed | Button Button0 Pressed -> event ChgDir
    1.00 turn <- event 0 | ChgDir -> Velocity 0.0 1.0
    2.00 shout <- Button Button1 Pressed | Button Button1 Pressed -> event Lost
    2.10 in 7 hear <- tick | Seconds 2.1 -> Say "soon"
    2.20 in 7 untilBump <- Bumper LeftBumper Pressed | Bumper LeftBumper Pressed -> Done ()
    2.30 late <- Button Button2 Pressed | Button Button2 Pressed -> event Late
"""

STARTS = """
    2.00 in 1 begin <- by 0 | Position 0.0 0.0 -> Memory 0
    2.02 in 1 go <- Odometry | Position 1.0 0.0 -> Velocity 0.5 0.0
"""

ROBOT = """
    1.00 ! Bumper LeftBumper Pressed
    1.10 drive <- tick | Seconds 1.1 -> Velocity 0.3 0.0
    2.00 ! Bumper LeftBumper Released
    2.10 ! Wheel RightWheel Air
    2.20 avoid <- Bumper LeftBumper Released | Velocity 0.0 0.0, Bumper LeftBumper Released -> Velocity (-0.3) 0.0
    3.00 ! Wheel RightWheel Ground
    3.10 ahead <- tick | Seconds 3.1 -> Velocity 2.0 0.0
    3.20 drive <- tick | Seconds 3.2 -> Velocity 0.0 9.0
    3.30 ahead <- tick | Seconds 3.3 -> Velocity 0.2 0.0
"""


def run(story: str) -> RecordedRun:
    return recorded(story, end=10.0)


@pytest.mark.parametrize(
    ("story", "name", "start", "end", "answer"),
    [
        (BUMPS, "play", 2, 4, "**play** takes a `Bumper`; none came between 2.00 s and 4.00 s. The last came at 1.20 s."),
        (BUMPS, "play", 0, 0.5, "**play** takes a `Bumper`; none came between 0.00 s and 0.50 s. None had come before."),
        (BUMPS, "play", 0.9, 1.1, "**play** did run, at 1.00 s for `Bumper LeftBumper Pressed`."),
        (BUMPS, "left", 4, 6, "**left** takes a `BumperLeft`; none came between 4.00 s and 6.00 s. The last came at 1.20 s."),
        (BUMPS, "alarm", 0, 5, "**alarm** takes a `Cliff` or a `Wheel`; none came between 0.00 s and 5.00 s. None had come before."),
        (BUMPS, "alarm", 6, 7, "**alarm** takes a `Cliff` or a `Wheel`; none came between 6.00 s and 7.00 s. The last came at 5.10 s."),
        (BUMPS, "pair", 4, 5.5, "**pair** takes a `Button`; none came between 4.00 s and 5.50 s. None had come before."),
        (BUMPS, "pair", 5.5, 7, "**pair** takes a `Bumper`; none came between 5.50 s and 7.00 s. The last came at 5.00 s."),
        (BUMPS, "nested", 2, 4, "**nested** takes a `Bumper` or a `Cliff`; none came between 2.00 s and 4.00 s. The last came at 1.20 s."),
        (BUMPS, "turn", 0, 9, "**turn** takes a `ChgDir`; none came between 0.00 s and 9.00 s. None had come before."),
        (BUMPS, "gone", 0, 9, "**gone** is not part of `simulate`."),
        (BUMPS, "play", 11, 12, "The run had ended at 10.00 s."),
        (BUMPS, "play", -2, -1, "The run had not begun."),
        (BUMPS, "drive", 0, 9, "**drive** has not run between 0.00 s and 9.00 s; the record does not tell why."),
        (TASKS, "ahead", 3.2, 9, "The task of **ahead** had ended at 3.10 s: **untilBump** gave `Done`."),
        (TASKS, "untilBump", 3.5, 9, "The task of **untilBump** had ended at 3.10 s: **untilBump** gave `Done`."),
        (TASKS, "ahead", 1, 2, "**ahead** ran at 0.00 s, and not between 1.00 s and 2.00 s; the record does not tell why."),
        (TASKS, "untilBump", 1, 2, "**untilBump** takes a `Bumper`; none came between 1.00 s and 2.00 s. None had come before."),
        (STARTS, "begin", 0, 1, "**begin** belongs to a task that had not begun by 1.00 s."),
        (STARTS, "go", 0, 1.9, "**go** belongs to a task that had not begun by 1.90 s."),
        (STARTS, "go", 1, 3, "**go** did run, at 2.02 s for `Position 1.0 0.0`."),
        (STARTS, "begin", 3, 5, "**begin** runs once, when its task begins. That was at 2.00 s."),
        (STARTS, "follow", 0, 1, "**follow** has not run between 0.00 s and 1.00 s; the record does not tell why."),
        (REPLACED, "drive", 4.02, 4.08, "**drive** runs ten times a second: it ran at 4.00 s, and then again at 4.10 s."),
        ("", "play", 0, 1, "**play** takes a `Bumper`; none came between 0.00 s and 1.00 s. None had come before."),
    ],
)  # fmt: skip
def test_why_a_function_did_not_run(story: str, name: str, start: float, end: float, answer: str) -> None:
    assert why_not_run(run(story), FUNCTIONS, name, Window(start, end)).sentence == answer


@pytest.mark.parametrize("state", sorted(type_roles().states))
def test_a_state_is_always_there(state: str) -> None:
    functions = [FunctionType("watch", (state,), ("Say",)), FunctionType("both", (state, "Bumper"), ("Say",))]
    for name in ("watch", "both"):
        told = str(why_not_run(run(BUMPS), functions, name, Window(2, 4)).sentence)
        assert f"`{state}`; none came" not in told


@pytest.mark.parametrize("view", sorted(type_roles().views))
def test_an_event_on_one_side_has_come_when_that_side_told_it(view: str) -> None:
    whole, place = type_roles().views[view].split(" ")
    functions = [FunctionType("watch", (view,), ("Say",))]
    story = f"1.00 ! {whole} {place} Yes\n2.00 ! {whole} Elsewhere Yes"
    answer = f"**watch** takes a `{view}`; none came between 1.50 s and 2.50 s. The last came at 1.00 s."
    assert why_not_run(run(story), functions, "watch", Window(1.5, 2.5)).sentence == answer


@pytest.mark.parametrize("command", sorted(type_roles().commands))
def test_every_command_of_a_robot_is_known(command: str) -> None:
    functions = [FunctionType("play", ("Bumper",), ("Mine",))]
    told = str(why_not_sent(run(BUMPS), functions, "play", command, Window(0, 5)).sentence)
    assert told.startswith("**play** never sends a")
    assert told.endswith(f" `{command}`: it gives a `Mine`.")


@pytest.mark.parametrize(
    ("story", "name", "command", "start", "end", "answer"),
    [
        (BUMPS, "play", "Sound", 1.1, 1.3, "At 1.20 s **play** ran for `Bumper LeftBumper Released` and gave nothing."),
        (BUMPS, "play", "Sound", 0.9, 1.1, "**play** did send `Sound`, at 1.00 s."),
        (BUMPS, "play", "Sound", 2, 4, "**play** takes a `Bumper`; none came between 2.00 s and 4.00 s. The last came at 1.20 s."),
        (BUMPS, "left", "Led2", 0, 2, "At 1.00 s **left** ran for `BumperLeft Pressed` and gave `Led1 Red`."),
        (TASKS, "play", "Velocity", 3, 5, "**play** never sends a `Velocity`: it gives a `Sound` or a `Led1`."),
        (TASKS, "untilBump", "Sound", 3, 5, "**untilBump** never sends a `Sound`: it gives a `Done ()`."),
        (EVENTS, "change", "Lost", 0, 5, "**change** never sends a `Lost`: it gives a `ChgDir`."),
        (EVENTS, "change", "Elsewhere", 0, 5, "At 1.00 s **change** ran for `Button Button0 Pressed` and gave `ChgDir`."),
        (EVENTS, "change", "Velocity", 0, 5, "**change** never sends a `Velocity`: it gives a `ChgDir`."),
        (REPLACED, "avoid", "Velocity", 3, 3.5, "It was sent at 3.40 s, and **drive** replaced it with `Velocity 0.5 0.0` 0.02 s later."),
        (REPLACED, "avoid", "Velocity", 4, 4, "It was sent at 4.00 s, and **drive** replaced it with `Velocity 0.5 0.0` in the same instant."),
        (REPLACED, "drive", "Velocity", 4.05, 4.2, "**drive** did send `Velocity 0.5 0.0`, at 4.10 s."),
        (REPLACED, "avoid", "Velocity (-0.5) 0.0", 3, 5, "It was sent at 3.40 s, and **drive** replaced it with `Velocity 0.5 0.0` 0.02 s later."),
        (TASKS, "ahead", "Velocity", 0, 1, "It was sent at 0.00 s, and at 3.10 s the robot was told `Velocity 0.0 0.0`, because **untilBump** ended its task with `Done`."),
    ],
)  # fmt: skip
def test_why_a_function_did_not_send(
    story: str, name: str, command: str, start: float, end: float, answer: str
) -> None:
    assert why_not_sent(run(story), FUNCTIONS, name, command, Window(start, end)).sentence == answer


@pytest.mark.parametrize(
    ("time", "answer"),
    [
        (1.1, "It was sent at 1.10 s, and **avoid** replaced it with `Velocity (-0.3) 0.0` 1.10 s later."),
        (3.1, "It was sent at 3.10 s, and **drive** replaced it with `Velocity 0.0 9.0` 0.10 s later."),
        (3.3, "`Velocity 0.2 0.0` has been in force since 3.30 s."),
    ],
)
def test_why_a_command_had_no_effect(time: float, answer: str) -> None:
    [sent] = [one for one in run(ROBOT).commands() if one.time == time]
    assert why_no_effect(run(ROBOT), sent, LIMITS).sentence == answer


@pytest.mark.parametrize(
    ("lines", "answer"),
    [
        (2, "Something is in its way: the left bumper was pressed at 1.00 s, and has not been released."),
        (5, "It could not drive: the right wheel lost the ground at 2.10 s, and has not found it again."),
        (7, f"`Velocity 2.0 0.0` asks for 2 m/s; the robot's limit is {MAX_SPEED:g} m/s."),
        (8, f"`Velocity 0.0 9.0` asks for 9 rad/s; the robot's limit is {MAX_ANGULAR_SPEED:g} rad/s."),
        (9, "`Velocity 0.2 0.0` has been in force since 3.30 s."),
    ],
)
def test_why_the_robot_could_not(lines: int, answer: str) -> None:
    story = run("\n".join(ROBOT.strip().splitlines()[:lines]))
    assert why_no_effect(story, story.commands()[-1], LIMITS).sentence == answer


@pytest.mark.parametrize(
    ("event", "answer"),
    [
        ("ChgDir", "**turn** did receive a `ChgDir`, at 1.00 s."),
        ("Lost", "**shout** sent a `Lost` at 2.00 s, and no function takes it."),
        ("Found", "No `Found` was sent between 0.00 s and 10.00 s: **never** did not give one."),
        ("Nowhere", "No function sends a `Nowhere`."),
        ("Late", "The first `Late` came at 2.30 s, and the task of **hear** had ended at 2.20 s."),
    ],
)
def test_why_an_event_was_not_received(event: str, answer: str) -> None:
    assert why_not_received(run(EVENTS), FUNCTIONS, event, Window(0, 10)).sentence == answer


def test_an_event_that_came_later_was_not_sent_before() -> None:
    answer = why_not_received(run(EVENTS), FUNCTIONS, "ChgDir", Window(0, 0.5))
    assert answer.sentence == "No `ChgDir` was sent between 0.00 s and 0.50 s: **change** did not give one."


def test_an_event_is_found_by_its_constructor_as_well() -> None:
    story = recorded("1.00 back <- Bumper LeftBumper Pressed -> Velocity (-0.5) 0.0")
    for named in ("Bumper", "Bumper LeftBumper Pressed"):
        links = why_event(story, named, 2.0).links
        assert [link.sentence for link in links] == [
            "At 1.00 s the left bumper was pressed.",
            "At 1.00 s **back** ran and gave `Velocity (-0.5) 0.0`.",
        ]
    assert [link.sentence for link in why_event(story, "Cliff", 2.0).links] == ["No `Cliff` had come by 2.00 s."]


def test_the_safety_rules_may_drive_instead_of_the_program() -> None:
    story = RecordedRun()
    for step in range(150, 200):
        story.add_step(step / 50, [], [], [ShownCommand("Velocity", "Velocity 0.2 0.0")], is_overridden=step >= 160)
    [before, after] = [one for one in story.commands() if one.time in (3.18, 3.5)]
    assert hindrance(story, before, LIMITS) is None
    found = hindrance(story, after, LIMITS)
    assert found is not None
    assert found.sentence == "The safety rules drove the robot from 3.20 s on, and not `Velocity 0.2 0.0`."
