"""Why is the robot there? The way to a place in recorded runs, each with the sentences of its answer."""

from __future__ import annotations

import pytest

from rosy_sim.explain.answers import why_position
from rosy_sim.explain.recorded_run import RecordedRun
from rosy_sim.explain.recorded_step import ShownCommand
from rosy_sim.explain.why_not import RobotLimits

from .recorded import recorded

LIMITS = RobotLimits(0.7, 3.0)

WALK = """
    0.00 ! sent Velocity 0.0 0.0
    1.00 drive <- tick | Seconds 1.0 -> Velocity 0.5 0.0
    1.10 drive <- tick | Seconds 1.1 -> Velocity 0.5 0.0
    2.00 faster <- tick | Seconds 2.0 -> Velocity 0.6 0.0
    2.10 faster <- tick | Seconds 2.1 -> Velocity 0.9 0.0
    3.00 drive <- tick | Seconds 3.0 -> Velocity 0.5 0.0, Velocity 0.0 1.0
    4.00 drive <- tick | Seconds 4.0 -> Velocity 0.0 0.0
    4.50 ! sent Velocity 0.0 0.0
    5.00 drive <- tick | Seconds 5.0 -> Velocity (-0.2) 0.0
"""

TURNED = "From 3.00 s to 4.00 s the robot followed `Velocity 0.0 1.0` from **drive**."
FAST = (
    "From 2.00 s to 3.00 s the robot followed commands from **faster** between `Velocity 0.6 0.0` and "
    "`Velocity 0.9 0.0`."
)
STRAIGHT = "From 1.00 s to 2.00 s the robot followed `Velocity 0.5 0.0` from **drive**."


@pytest.mark.parametrize(
    ("time", "answer"),
    [
        (0.5, ["The robot is where it began: no `Velocity` had moved it before 0.50 s."]),
        (1.0, ["The robot is where it began: no `Velocity` had moved it before 1.00 s."]),
        (1.5, ["From 1.00 s to 1.50 s the robot followed `Velocity 0.5 0.0` from **drive**."]),
        (3.0, [FAST, "`Velocity 0.9 0.0` asks for 0.9 m/s; the robot's limit is 0.7 m/s.", STRAIGHT]),
        (4.0, [TURNED, FAST, STRAIGHT]),
        (
            4.8,
            [
                "From 4.00 s to 4.80 s the robot was told to stand still.",
                TURNED,
                FAST,
                "Before 2.00 s it followed other commands.",
            ],
        ),
        (
            99.0,
            [
                "From 5.00 s to 6.00 s the robot followed `Velocity (-0.2) 0.0` from **drive**.",
                "From 4.00 s to 5.00 s the robot was told to stand still.",
                TURNED,
                "Before 3.00 s it followed other commands.",
            ],
        ),
    ],
)
def test_the_way_to_a_place_is(time: float, answer: list[str]) -> None:
    found = why_position(recorded(WALK, end=6.0), time, LIMITS)
    assert [link.sentence for link in found.links] == answer


def test_the_way_begins_where_a_hand_put_the_robot() -> None:
    run = RecordedRun()
    for step in range(100):
        sent = [ShownCommand("Velocity", "Velocity 0.0 0.0")] if step == 0 else []
        run.add_step(step / 50, [], [], sent, is_placed=step in (20, 50))
    assert [link.sentence for link in why_position(run, 1.5, LIMITS).links] == [
        "From 1.00 s to 1.50 s the robot was told to stand still.",
        "At 1.00 s a hand put the robot in another place.",
    ]
    assert [link.sentence for link in why_position(run, 0.3, LIMITS).links] == [
        "The robot is where it began: no `Velocity` had moved it before 0.30 s."
    ]


def test_a_record_that_begins_later_says_so() -> None:
    run = recorded(WALK, end=6.0)
    run.known_since = 3.5
    assert [link.sentence for link in why_position(run, 3.8, LIMITS).links] == [
        "From 3.50 s to 3.80 s the robot followed `Velocity 0.0 1.0` from **drive**.",
        "What happened before 3.50 s is not known any more.",
    ]


def test_the_path_has_the_firings_of_the_way() -> None:
    found = why_position(recorded(WALK, end=6.0), 4.0, LIMITS)
    assert [firing.function for firing in found.path] == ["drive", "faster", "drive"]
