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


def test_a_room_without_a_dock_has_no_signal() -> None:
    assert hall().channels()["DockInfraRed"] == (0, 0, 0)
