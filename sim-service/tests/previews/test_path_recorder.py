"""The path recorder: what it tells of the pen."""

from __future__ import annotations

import json

from rosy_sim.previews.path_recorder import PathRecorder
from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.world.events import Command

from ..conftest import hall

CHANGES = {2: Command("PenColor", (1,)), 3: Command("Pen", (1,)), 6: Command("Pen", (1,)), 9: Command("Pen", (0,))}
"""What the program's robot does with its pen, by step: red ink, down, down again, up."""


def recorded(changes: dict[int, Command]) -> PathRecorder:
    """A drive of twelve steps of 20 ms with these commands."""
    lockstep = Lockstep(hall(), seed=1)
    lockstep.feed(b'{"op":"ready"}\n')
    lockstep.world.drive(0.2, 0.0)
    recorder = PathRecorder(lockstep.world, lambda: False)
    for step in range(12):
        lockstep.sense()
        lockstep.feed(json.dumps({"op": "settled", "step": step, "fired": []}).encode() + b"\n")
        if step in changes:
            lockstep.world.command(changes[step])
        recorder.observe(lockstep)
        lockstep.integrate()
    return recorder


def test_each_change_of_the_pen_is_told_with_a_point_of_the_path() -> None:
    recorder = recorded(CHANGES)
    assert recorder.pen == [(0.04, 0, 1, 0.03), (0.06, 1, 1, 0.03), (0.18, 0, 1, 0.03)]
    assert {time for time, *_ in recorder.pen} <= {time for time, *_ in recorder.path}


def test_a_pen_that_does_not_change_is_not_told() -> None:
    assert recorded({3: Command("Led1", (1,))}).pen == []
