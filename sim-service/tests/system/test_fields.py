"""
Record fields with the names of 2019: access, update, construction and patterns; a program's own names go before them.
"""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker

from .real_runs import ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

FIELDS = {
    "Velocity": ("Velocity 0.1 0.2", {"velocityLinear": "0.1", "velocityAngular": "0.2"}),
    "Position": ("Position 1 2", {"positionX": "1.0", "positionY": "2.0"}),
    "Orientation": ("Orientation 1.5", {"orientation": "1.5"}),
    "Bumper": ("Bumper LeftBumper Pressed", {"bumperSide": "LeftBumper", "bumperStatus": "Pressed"}),
    "Cliff": ("Cliff RightCliff Hole", {"cliffSide": "RightCliff", "cliffStatus": "Hole"}),
    "Wheel": ("Wheel LeftWheel Air", {"wheelSide": "LeftWheel", "wheelStatus": "Air"}),
    "Button": ("Button Button1 Released", {"buttonNumber": "Button1", "buttonStatus": "Released"}),
    "BumperLeft": ("BumperLeft Pressed", {"bumperStatusLeft": "Pressed"}),
    "BumperCenter": ("BumperCenter Pressed", {"bumperStatusCenter": "Pressed"}),
    "BumperRight": ("BumperRight Pressed", {"bumperStatusRight": "Pressed"}),
    "CliffLeft": ("CliffLeft Hole", {"cliffStatusLeft": "Hole"}),
    "CliffCenter": ("CliffCenter Hole", {"cliffStatusCenter": "Hole"}),
    "CliffRight": ("CliffRight Hole", {"cliffStatusRight": "Hole"}),
    "WheelLeft": ("WheelLeft Air", {"wheelStatusLeft": "Air"}),
    "WheelRight": ("WheelRight Air", {"wheelStatusRight": "Air"}),
    "ButtonZero": ("ButtonZero Pressed", {"buttonStatus0": "Pressed"}),
    "ButtonOne": ("ButtonOne Pressed", {"buttonStatus1": "Pressed"}),
    "ButtonTwo": ("ButtonTwo Pressed", {"buttonStatus2": "Pressed"}),
    "Led1": ("Led1 Red", {"ledColor1": "Red"}),
    "Led2": ("Led2 Green", {"ledColor2": "Green"}),
    "Done Int": ("Done 3", {"unDone": "3"}),
    "Feedback Int": ("Feedback 4", {"unFeedback": "4"}),
    "Clock": ("Clock 1 2 3 4", {"hours": "1", "minutes": "2", "seconds": "3", "milliseconds": "4"}),
}
"""Types, a value of each, and what its fields hold."""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def test_fields_are_read_updated_built_and_matched_and_values_are_shown_without_them(worker: BlockingWorker) -> None:
    lines = ["main :: IO ()", "main = do"]
    expected = []
    for kind, (value, fields) in FIELDS.items():
        constructor = value.split()[0]
        record = f"{constructor} {{{', '.join(f'{name} = {held}' for name, held in fields.items())}}}"
        name, held = next(iter(fields.items()))
        lines += [
            f"  print ({value} :: {kind})",
            f"  print (({record} :: {kind}) == {value})",
            *(f"  print ({field} ({value} :: {kind}))" for field in fields),
            f"  print ((({value}) {{{name} = {held}}} :: {kind}) == {value})",
            f"  print (case ({value} :: {kind}) of {constructor} {{{name} = found}} -> found)",
        ]
        expected += [value, "True", *fields.values(), "True", held]
    shown = [value.replace("Position 1 2", "Position 1.0 2.0") for value in expected]
    assert ran(worker, "\n".join(lines), seconds=0.1).said == shown


def test_a_programs_own_names_go_before_the_fields(worker: BlockingWorker) -> None:
    own = 'hours, seconds :: Int\nhours = 5\nseconds = 6\n\nmain = print (hours, seconds) >> simulate (say "run")'
    assert worker.check(own).problems == []
    assert ran(worker, own, seconds=1.0).said == ["(5,6)", "run"]
