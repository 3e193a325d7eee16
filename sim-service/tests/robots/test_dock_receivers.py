"""The infrared receivers: which region in front of the dock each of them sees."""

from __future__ import annotations

import math

import pytest

from ..conftest import hall

NEAR_LEFT, NEAR_CENTER, NEAR_RIGHT, FAR_CENTER, FAR_LEFT, FAR_RIGHT = 1, 2, 4, 8, 16, 32


@pytest.mark.parametrize(
    ("dock", "seen"),
    [
        # The robot stands at (10, 10) and looks along x: docks ahead of it that face it.
        ((10.5, 10.0, 0.0), (0, NEAR_CENTER, 0)),
        ((13.0, 10.0, 0.0), (0, FAR_CENTER, 0)),
        ((16.0, 10.0, 0.0), (0, 0, 0)),
        ((13.0, 9.5, 0.0), (0, FAR_LEFT, 0)),
        ((13.0, 10.5, 0.0), (0, FAR_RIGHT, 0)),
        ((13.0, 11.5, 0.0), (0, 0, 0)),
        # To the left of it, and between two receivers.
        ((10.0, 10.8, math.pi / 2), (NEAR_CENTER, 0, 0)),
        ((10.5, 10.3, math.atan2(0.3, 0.5)), (NEAR_CENTER, NEAR_CENTER, 0)),
        # Behind it, where no receiver looks, and facing away from it.
        ((9.0, 10.0, math.pi), (0, 0, 0)),
        ((11.0, 10.0, math.pi), (0, 0, 0)),
    ],
)
def test_the_regions(dock: tuple[float, float, float], seen: tuple[int, int, int]) -> None:
    world = hall(dock=dict(zip(("x", "y", "theta"), dock, strict=True)))
    assert world.channels()["DockInfraRed"] == seen


@pytest.mark.parametrize(
    ("hidden", "things"),
    [
        (True, {"walls": [{"from": [11.5, 8], "to": [11.5, 12]}]}),
        (True, {"boxes": [{"x": 11.5, "y": 10, "w": 0.3, "h": 0.3}]}),
        (False, {"walls": [{"from": [11.5, 10.5], "to": [11.5, 12]}]}),
        # Behind the dock, and the wall at which it stands.
        (False, {"walls": [{"from": [13.6, 8], "to": [13.6, 12]}]}),
        (False, {"walls": [{"from": [13.02, 8], "to": [13.02, 12]}]}),
    ],
)
def test_what_stands_between_hides_the_dock(hidden: bool, things: dict[str, object]) -> None:
    world = hall(dock={"x": 13.0, "y": 10.0, "theta": 0.0}, **things)
    assert world.channels()["DockInfraRed"] == (0, 0 if hidden else FAR_CENTER, 0)


@pytest.mark.parametrize("thing", ["wall", "box", "drum", "loose box"])
@pytest.mark.parametrize(
    ("covered", "seen"),
    [
        (0.5, (0, FAR_CENTER, FAR_RIGHT)),
        (0.0, (FAR_LEFT, 0, FAR_RIGHT)),
        (-0.5, (FAR_LEFT, FAR_CENTER, 0)),
    ],
)
def test_of_a_dock_that_is_partly_hidden_the_free_regions_are_seen(
    thing: str, covered: float, seen: tuple[int, int, int]
) -> None:
    # The robot stands in one region after the other; what hides the dock stands a quarter of the way before it.
    for side, expected in zip((0.5, 0.0, -0.5), seen, strict=True):
        dock = 10.0 - side
        x, y = 12.25, dock + 0.25 * covered
        things: dict[str, dict[str, object]] = {
            "wall": {"walls": [{"from": [x, y - 0.05], "to": [x, y + 0.05]}]},
            "box": {"boxes": [{"x": x, "y": y, "w": 0.1, "h": 0.1}]},
            "drum": {"rounds": [{"x": x, "y": y, "r": 0.05}]},
            "loose box": {"boxes": [{"x": x, "y": y, "w": 0.1, "h": 0.1, "mass": 1}]},
        }
        world = hall(dock={"x": 13.0, "y": dock, "theta": 0.0}, **things[thing])
        assert world.channels()["DockInfraRed"] == (0, expected, 0)


def test_a_room_without_a_dock_has_no_signal() -> None:
    assert hall().channels()["DockInfraRed"] == (0, 0, 0)
