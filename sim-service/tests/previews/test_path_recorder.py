"""The path recorder: what it tells of the pen."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from rosy_sim.previews.path_recorder import PathRecorder

UP: dict[str, tuple[Any, ...]] = {"Pen": (0,), "PenColor": (0,), "PenWidth": (0.03,)}
RED = {**UP, "Pen": (1,), "PenColor": (1,)}


def recorded(first: dict[str, Any], *steps: tuple[float, float, dict[str, Any]]) -> PathRecorder:
    """A drive along x: each step is a time, a place and the outputs of the robot."""

    def world(x: float, outputs: dict[str, Any]) -> Any:
        return SimpleNamespace(x=x, y=1.0, outputs=outputs, is_blocked=False, has_contacts=False)

    recorder = PathRecorder(world(1.0, first), lambda: False)
    for time, x, outputs in steps:
        recorder.observe(SimpleNamespace(state="settled", time=time, world=world(x, outputs)))  # type: ignore[arg-type]
    return recorder


def test_each_change_of_the_pen_is_told_with_a_point_of_the_path() -> None:
    recorder = recorded(UP, (0.02, 1.0, UP), (0.04, 1.004, RED), (0.06, 1.008, {**RED}), (0.08, 1.012, {**UP}))
    assert recorder.pen == [(0.04, 1, 1, 0.03), (0.08, 0, 0, 0.03)]
    assert recorder.path == [(0.0, 1.0, 1.0), (0.04, 1.004, 1.0), (0.08, 1.012, 1.0)]


def test_a_robot_without_a_pen_draws_nothing() -> None:
    recorder = recorded({"MotorPower": (1,)}, (0.02, 1.01, {"MotorPower": (0,)}))
    assert recorder.pen == []
