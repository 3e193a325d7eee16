"""Standings of a competition: rooms first, then the mean time in them; equals share a place."""

from __future__ import annotations

import msgspec
import pytest

from rosy_sim.classroom.messages.check_messages import CheckResult
from rosy_sim.classroom.messages.projector_messages import Standing
from rosy_sim.classroom.standings import mean_time, standings
from rosy_sim.wire.page import room_tests


def result(passed: int, time: float | None = None, rooms: int = 10) -> bytes:
    return msgspec.json.encode(CheckResult(0.0, "maze", rooms, 1, 20.0, "", passed=passed, time=time))


def test_rooms_count_first_then_the_time_and_equals_share_a_place() -> None:
    results = {
        1: result(8, 4.0),
        2: result(9, 12.5),
        3: result(9, 11.0),
        4: b"",
        5: result(9, 12.5),
        6: result(0),
        7: result(1, 30.0, 1),
        8: result(9, 1.0),
    }
    nicknames = {1: "Ada", 2: "dan", 3: "Cleo", 4: "Eve", 5: "Ben", 6: "Fay", 7: "Gus"}
    assert standings(results, nicknames) == [
        Standing(1, "Gus", 1, 1, 30.0),
        Standing(2, "Cleo", 9, 10, 11.0),
        Standing(3, "Ben", 9, 10, 12.5),
        Standing(3, "dan", 9, 10, 12.5),
        Standing(5, "Ada", 8, 10, 4.0),
        Standing(6, "Fay", 0, 10, None),
    ]


def room(passed: bool, *times: float) -> room_tests.TestedRoom:
    findings = [room_tests.FindingShown("", "held" if passed else "failed", time, 0.0) for time in times]
    return room_tests.TestedRoom(1, 1, passed, "", 20.0, findings, [], None, [])


@pytest.mark.parametrize(
    ("rooms", "time"),
    [
        ([], None),
        ([room(False, 3.0)], None),
        # The goal after 5 s and another one after 8 s; never falling is decided at the end.
        ([room(True, 5.0, 8.04, 20.0)], 8.0),
        # A room in which there is only something to avoid.
        ([room(True, 20.0)], 20.0),
        ([room(True, 5.0), room(True, 8.0), room(False, 1.0)], 6.5),
    ],
)
def test_the_time_is_that_until_all_was_reached_in_the_passed_rooms(
    rooms: list[room_tests.TestedRoom], time: float | None
) -> None:
    assert mean_time(rooms) == time
