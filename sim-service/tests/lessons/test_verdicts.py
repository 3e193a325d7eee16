"""Verdicts: each kind of check by a small recording that passes it and one that does not, with what was seen."""

from __future__ import annotations

from typing import Any

import msgspec
import pytest

from rosy_sim.lessons.checks import Check
from rosy_sim.lessons.program_graph import GraphFunction, ProgramGraph
from rosy_sim.lessons.recording import Happening, Recording, Sample
from rosy_sim.lessons.verdicts import judge
from rosy_sim.wire.verdict import Seen, Verdict
from rosy_sim.world.arena import read_arena
from rosy_sim.world.goals import GoalState

ARENA = read_arena({"size": [5, 3], "start": {"x": 1, "y": 1}, "goals": [{"kind": "reach", "x": 3, "y": 1, "r": 0.3}]})
PRESSED, RELEASED = (0, 1), (0, 0)


def about(value: float) -> Any:
    """Nearly this number."""
    return pytest.approx(value, abs=1e-4)


def driven(speed: float, seconds: float = 5.0, turn: float = 0.0, **more: Any) -> Recording:
    """A straight drive at a speed, with a heading that is independent of it."""
    samples = [
        Sample(i / 50, 1 + speed * i / 50, 1.0, turn * i / 50, speed, turn, 0, 0)
        for i in range(1, round(seconds * 50) + 1)
    ]
    return Recording(ARENA, samples, **more)


def verdict(
    check: dict[str, Any], recording: Recording, final: bool = True, graph: ProgramGraph | None = None
) -> Verdict:
    """The verdict about one check."""
    value = msgspec.convert({"id": "it", **check}, Check)
    return judge([value], recording, graph, final)[0]


def at(time: float, channel: str, *values: float | str) -> Happening:
    """An event or a command."""
    return Happening(time, channel, values)


AT = {"kind": "at", "time": 5}
FACES = {"kind": "faces", "time": 5}
STILL = {"kind": "still", "after": 2}
MOVES = {"kind": "moves", "metres": 1}
REACHES = {"kind": "reaches", "speed": 0.4, "within": 2}
BACK = {"kind": "reaches", "speed": -0.4, "within": 2}
ENDS = {"kind": "ends", "by": 4}
SAYS = {"kind": "says", "texts": ["1", "2"]}
SENDS = {"kind": "sends", "command": "Led1 Green"}
ANSWERS = {"kind": "answers", "event": "Bumper _ Pressed", "command": "Velocity <0 _"}
SILENT = {"kind": "silent", "event": "Bumper _ Released", "command": "Sound _"}

CASES: list[tuple[dict[str, Any], Recording, str, Seen | None]] = [
    (AT, driven(0.4), "done", None),
    (AT, driven(0.2), "missed", Seen("away", 5.0, about(0.7))),
    (AT, driven(0.4, 3), "missed", Seen("too-short", 5.0)),
    (AT, driven(0.4, 4.8, done=4.8), "done", None),
    (FACES, driven(0.2), "done", None),
    (FACES, driven(0.0, turn=0.2), "missed", Seen("turned", 5.0, about(-57.2958))),
    (STILL, driven(0.0), "done", None),
    (STILL, driven(0.3), "missed", Seen("moved", 2.0)),
    (MOVES, driven(0.4), "done", None),
    (MOVES, driven(0.1), "missed", Seen("drove", number=about(0.498))),
    (REACHES, driven(0.4), "done", None),
    (REACHES, driven(0.3), "missed", Seen("fastest", 2.0, 0.3)),
    (BACK, driven(-0.4), "done", None),
    (BACK, driven(0.4), "missed", Seen("fastest-back", 2.0, 0.0)),
    (ENDS, driven(0.1, 3, done=3.0), "done", None),
    (ENDS, driven(0.1, 5, done=5.0), "missed", Seen("goes-on", 4.0)),
    (SAYS, driven(0, commands=[at(1, "Say", "1"), at(2, "Say", "x"), at(3, "Say", "2")]), "done", None),
    (SAYS, driven(0, commands=[at(1, "Say", "2"), at(3, "Say", "1")]), "missed", Seen("not-said", name="2")),
    (SENDS, driven(0, commands=[at(1, "Led1", 1)]), "done", None),
    (SENDS, driven(0, commands=[at(1, "Led1", 2), at(1, "Led2", 1)]), "missed", Seen("not-sent", name="Led1 Green")),
    (ANSWERS, driven(0, events=[at(1, "Bumper", *PRESSED)], commands=[at(1.1, "Velocity", -0.2, 0)]), "done", None),
    (
        ANSWERS,
        driven(0, events=[at(1, "Bumper", *PRESSED)], commands=[at(2, "Velocity", -0.2, 0)]),
        "missed",
        Seen("no-answer", 1, name="Bumper _ Pressed"),
    ),
    (
        ANSWERS,
        driven(0, events=[at(1, "Bumper", *PRESSED)], commands=[at(1, "Velocity", 0.2, 0)]),
        "missed",
        Seen("no-answer", 1, name="Bumper _ Pressed"),
    ),
    # The answer to an event shortly before the end is not due yet.
    (ANSWERS, driven(0, events=[at(4.9, "Bumper", *PRESSED)]), "done", None),
    (
        ANSWERS,
        driven(0, events=[at(1, "Bumper", *RELEASED)]),
        "missed",
        Seen("not-happened", number=0.0, name="Bumper _ Pressed"),
    ),
    (SILENT, driven(0, events=[at(1, "Bumper", *RELEASED)], commands=[at(2, "Sound", 4)]), "done", None),
    (
        SILENT,
        driven(0, events=[at(1, "Bumper", *RELEASED)], commands=[at(1, "Sound", 4)]),
        "missed",
        Seen("answer", 1, name="Bumper _ Released"),
    ),
]


@pytest.mark.parametrize(("check", "recording", "state", "seen"), CASES)
def test_a_check_is_judged_by_what_was_recorded(
    check: dict[str, Any], recording: Recording, state: str, seen: Seen | None
) -> None:
    assert verdict(check, recording) == Verdict("it", state, seen)  # type: ignore[arg-type]


def test_a_way_is_measured_until_a_bump_or_until_now() -> None:
    there = [Sample(i / 50, 1 + i / 100, 1.0, 0.0, 0.5, 0.0, int(i == 200), 0) for i in range(201)]
    back = [Sample(4 + i / 50, 3 - i / 100, 1.0, 0.0, -0.5, 0.0, 0, 0) for i in range(1, 51)]

    def said(time: float, text: str) -> Verdict:
        recording = Recording(ARENA, there + back, commands=[at(time, "Say", text)])
        return verdict({"kind": "measures", "tolerance": 5}, recording)

    assert said(4, "It is 200 cm").state == "done"
    assert said(5, "250").state == "done"
    assert said(5, "200").state == "done"
    # Not yet driven, and driven somewhere between.
    assert said(3, "200").state == "missed"
    assert said(5, "150") == Verdict("it", "missed", Seen("not-measured", number=about(250)))


@pytest.mark.parametrize("check", [AT, FACES, STILL, MOVES, REACHES, ENDS, SAYS, SENDS, ANSWERS, SILENT])
def test_nothing_is_decided_before_anything_happened(check: dict[str, Any]) -> None:
    assert verdict(check, Recording(ARENA), final=False).state == "open"


def test_goals_of_the_room() -> None:
    def told(state: Any, kind: str = "reach") -> Recording:
        return driven(0, goals=[GoalState(kind, "Ring", state, 0.4, 3.0 if state != "open" else None)])

    goals = {"kind": "goals"}
    assert verdict(goals, told("done")).state == "done"
    assert verdict(goals, told("missed")).seen == Seen("goal-missed", 3.0, name="Ring")
    assert verdict(goals, told("open")).seen == Seen("goal-open", 5.0, 0.4, "Ring")
    assert verdict(goals, told("open"), final=False).state == "open"
    # To stay away from something is done when the time is over without it.
    assert verdict(goals, told("open", "avoid")).state == "done"
    assert verdict(goals, told("open", "avoid"), final=False).state == "open"
    # Before a run.
    assert verdict(goals, Recording(ARENA), final=False).state == "open"


def test_goals_of_the_room_in_time() -> None:
    goals = {"kind": "goals", "within": 4}
    in_time, late = (driven(0, goals=[GoalState("reach", "Ring", "done", 1, time)]) for time in (4.0, 4.5))
    assert verdict(goals, in_time).state == "done"
    assert verdict(goals, late).seen == Seen("goal-late", 4.5, name="Ring")
    # It is too late before the run is over.
    still_open = driven(0, goals=[GoalState("reach", "Ring", "open", 0.4, None)])
    assert verdict(goals, still_open, final=False).state == "missed"


def test_an_event_that_must_not_happen() -> None:
    never = {"kind": "never", "event": "Bumper _ Pressed"}
    bumped = driven(0, events=[at(3, "Bumper", *PRESSED)])
    assert verdict(never, bumped, final=False) == Verdict("it", "missed", Seen("happened", 3, name="Bumper _ Pressed"))
    assert verdict(never, driven(0, events=[at(3, "Bumper", *RELEASED)])).state == "done"
    assert verdict(never, driven(0), final=False).state == "open"
    assert verdict(never, Recording(ARENA)).state == "open"


GRAPH = ProgramGraph(
    [
        GraphFunction("bump", ["Bumper", "Memory Int"], ["Memory Int", "Maybe Say"]),
        GraphFunction("go", [], ["Velocity"]),
        GraphFunction("main", [], ["IO ()"]),
    ]
)


@pytest.mark.parametrize(
    ("check", "seen"),
    [
        ({"kind": "function", "takes": ["Bumper"], "gives": ["Say"]}, None),
        ({"kind": "function", "takes": ["Bumper", "Memory"]}, None),
        ({"kind": "function", "takes": ["Bumper"], "gives": ["Velocity"]}, Seen("gives-not", name="bump")),
        ({"kind": "function", "takes": ["Cliff"], "gives": ["Velocity"]}, Seen("no-function", name="Cliff")),
        ({"kind": "functions", "least": 2}, None),
        ({"kind": "functions", "least": 3}, Seen("functions", number=2)),
    ],
)
def test_facts_about_the_graph(check: dict[str, Any], seen: Seen | None) -> None:
    found = verdict(check, Recording(ARENA), final=False, graph=GRAPH)
    assert found == Verdict("it", "done" if seen is None else "missed", seen)
    assert verdict(check, Recording(ARENA)).state == "open"
