"""All rooms of a checked hand-in as they are stored."""

from __future__ import annotations

import msgspec

from rosy_sim.classroom.messages.check_messages import CheckResult
from rosy_sim.classroom.rooms_tried import pack_rooms, rooms_of
from rosy_sim.classroom.store.task_store import HandInGraded
from rosy_sim.wire.page import room_tests as wire


def tried(room: int) -> wire.TestedRoom:
    finding = wire.FindingShown("never-falls", "failed", 4.0, 0.0)
    world = {"name": "small", "size": [2, 2], "things": [{"kind": "wall", "x": n} for n in range(50)]}
    return wire.TestedRoom(room, 7 + room, False, "time", 4.0, [finding], [], world, [(1.0, 1.5)])


def graded(worst: wire.TestedRoom | None, rooms: list[wire.TestedRoom]) -> HandInGraded:
    result = CheckResult(1.0, "own", 2, 3, 20.0, "never-falls", worst=worst)
    return HandInGraded("walk", "main", msgspec.json.encode(result), pack_rooms(rooms))


def test_the_rooms_are_read_as_they_were_stored_and_need_little_space() -> None:
    rooms = [tried(number) for number in (3, 1, 2)]
    found = graded(rooms[0], rooms)
    assert rooms_of(found) == rooms
    assert len(found.rooms_tried) < len(msgspec.json.encode(rooms)) / 5


def test_a_result_without_stored_rooms_has_the_worst_one() -> None:
    assert rooms_of(graded(tried(3), [])) == [tried(3)]
    assert rooms_of(graded(None, [])) == []
