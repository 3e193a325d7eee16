"""When a silent sender's velocity is stopped, and the two types of a velocity: pure."""

from __future__ import annotations

from typing import Any

import pytest

from rosy_sim.ros2.velocity_watch import MAX_REPEATS, STOPPED, VelocityWatch, as_type, is_moving

TWIST = {"linear": {"x": 0.2}, "angular": {"z": 0.0}}


def test_a_stop_is_due_after_the_limit_and_again_until_a_sign_of_life_or_often_enough() -> None:
    watch = VelocityWatch(10.0)
    assert not watch.due(10.59)
    assert watch.wait(10.5) == pytest.approx(0.1)
    assert [watch.due(10.6), watch.due(10.65), watch.due(10.7)] == [True, False, True]
    assert not watch.heard(10.75)
    assert not watch.due(11.3)
    assert sum(watch.due(11.5 + i) for i in range(100)) == MAX_REPEATS
    assert watch.wait(200.0) is None


def test_a_sign_of_life_that_comes_too_late_says_so() -> None:
    watch = VelocityWatch(0.0)
    assert [watch.heard(0.5), watch.heard(1.2), watch.heard(1.3)] == [False, True, False]


@pytest.mark.parametrize(
    ("message", "kind", "other"),
    [
        (TWIST, "geometry_msgs/Twist", TWIST),
        (TWIST, "geometry_msgs/TwistStamped", {"twist": TWIST}),
        ({"twist": TWIST}, "geometry_msgs/Twist", TWIST),
        (
            {"header": {"frame_id": "a"}, "twist": TWIST},
            "geometry_msgs/TwistStamped",
            {"header": {"frame_id": "a"}, "twist": TWIST},
        ),
        ({"header": {"frame_id": "a"}, "twist": TWIST}, "geometry_msgs/Twist", TWIST),
        ([], "geometry_msgs/Twist", []),
    ],
)
def test_a_velocity_of_either_type_is_one_of_the_other(message: Any, kind: str, other: Any) -> None:
    assert as_type(message, kind) == other


def test_whether_it_moves() -> None:
    assert is_moving(TWIST)
    assert is_moving({"twist": {"angular": {"z": -0.1}}})
    assert not any(map(is_moving, [STOPPED, {}, [], {"twist": STOPPED}, {"linear": {"x": 0.0}}, {"linear": 3}]))
