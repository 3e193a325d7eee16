"""Sentences of explanations: one of each kind, as both the terminal and the page word it in English."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import get_args

import msgspec

from rosy_sim.explain.wording import english
from rosy_sim.wire.explanation import Sentence, SentenceId
from rosy_sim.wire.firing import Given

GOLDEN = Path(__file__).parents[3] / "protocol/goldens/explanations.jsonl"

BUMP = "Bumper CenterBumper Pressed"
STOP = "Velocity 0.0 0.0"
BACK = "Velocity (-0.5) 0.0"
SIDES = ("LeftCliff Hole", "RightCliff Floor")

SENTENCES = [
    Sentence("sent", time=3.5, function="forwardBackward", value=BACK, values=["Memory True", STOP]),
    Sentence("sent", time=3.5, function="ahead", value=BACK),
    Sentence("stopped", time=4, value=STOP),
    Sentence("stopped-by", time=4, value=STOP, other="runTurn", cause=3),
    *(Sentence("sensed", time=1.02, value=f"Cliff {side}") for side in SIDES),
    *(Sentence("sensed", time=1.02, value=value) for value in ("Wheel LeftWheel Air", "Wheel RightWheel Ground")),
    *(Sentence("sensed", time=1.02, value=f"Button Button{n} {how}") for n, how in enumerate(["Pressed"] * 2)),
    Sentence("sensed", time=1.02, value="Bumper LeftBumper Released"),
    Sentence("sensed", time=0, value="Online"),
    Sentence("nothing-ran"),
    Sentence("first-value", type="Memory Orientation", value="Orientation (-1.5707963267948966)"),
    Sentence("first-value", type="Memory Position", value="Position (-6.1e-5) 6.187726569706342e-2"),
    Sentence("first-value", type="Memory Int", value="0"),
    Sentence("old-value", type="Memory Int", value="0"),
    Sentence("from-start", type="Memory Bool", value="False"),
    Sentence("not-written", type="Memory Int"),
    Sentence("remembered", type="Memory Bool", value="True", since=3.42, other="bump", cause=1),
    Sentence("had-come", value=BUMP, since=1),
    Sentence("ran-message", function="bump", time=3.42, value=BUMP),
    Sentence("ran-message", function="drive", time=3.42, value="Odometry (Position 0.0 0.0)"),
    Sentence("ran-tick", function="drive", time=3.4),
    Sentence("ran-start", function="drive", time=0),
    Sentence("ran-wait", function="red", time=3),
    Sentence("ran-end", function="off", time=3),
    Sentence("ran-unknown", function="turn", time=3),
    Sentence("ran-event", function="turn", time=3, other="watch", cause=2, value="ChgDir"),
    Sentence("ran-done", function="say", time=1, since=1, other="untilBump", cause=2),
    Sentence("ran-call", function="say", time=1, since=1, other="caller", cause=2),
    Sentence("ran-feedback", function="say", time=1, since=1, other="caller", cause=2, value="3"),
    Sentence("ran-task", function="say", time=1, since=1, other="caller", cause=2),
    Sentence("nothing-sent", time=2),
    Sentence("nothing-sent", time=2, type="Led1"),
    Sentence("none-came", type="Bumper", until=3.0),
    Sentence("nothing-sent-yet"),
    Sentence("nothing-sent-yet", type="Led1"),
    Sentence("not-recorded"),
    Sentence("not-known-before", since=61.5),
    Sentence("run-over", time=10),
    Sentence("run-not-begun"),
    Sentence("did-run", function="play", time=1, values=[BUMP]),
    Sentence("did-run", function="play", time=1),
    Sentence("did-send", function="play", time=1, value="ErrorSound"),
    Sentence("did-take", function="play", time=1, values=[BUMP]),
    Sentence("did-take", function="play", time=1),
    Sentence("not-reached", function="mux", since=2, until=4),
    Sentence("not-part", function="gone"),
    Sentence("task-ended", function="ahead", time=3.1, other="untilBump", cause=4),
    Sentence("task-waits", function="runTurn", until=2),
    Sentence("runs-once", function="startTurn", time=0),
    Sentence("lacks", function="turn", types=["Own", "M1 Velocity", "Unit"], since=2, until=4),
    Sentence("lacks", function="play", types=["Bumper"], since=2, until=4),
    Sentence("lacks", function="alarm", types=["Cliff", "Wheel"], since=2, until=4, time=1.2),
    Sentence("ticks", function="drive", time=1, until=1.1),
    Sentence("ran-before", function="drive", time=1, since=2, until=4),
    Sentence("never-ran", function="drive", since=2, until=4),
    Sentence("gave", function="play", time=1.2, values=["Bumper LeftBumper Released"]),
    Sentence(
        "gave",
        function="play",
        time=1.2,
        gave=[
            Given("command", "Led1 Red", "Led1"),
            Given("event", "ChgDir", "ChgDir"),
            Given("memory", "True", "Memory Bool"),
            Given("memory", "-0.5", "Memory Double"),
            Given("memory", "Turn 1.0 2.0", "Memory Mode"),
            Given("param", "_", "Param Shape"),
            Given("event", "_", "Own"),
            Given("done"),
            Given("call"),
            Given("feedback", "3"),
        ],
    ),
    Sentence("matched-equation", function="play", number=2, value="play _"),
    Sentence("matched-case", function="choose", number=2, value="Nothing"),
    Sentence("guard-held", function="slow", value="v > 0.5"),
    Sentence("was-true", function="drive", value="hit"),
    Sentence("was-false", function="drive", value="hit"),
    Sentence("other-type", function="play", type="Velocity", types=["Sound", "Memory Bool"]),
    Sentence("in-force", value=BACK, time=3.5),
    Sentence("replaced", time=3.4, since=3.42, other="drive", cause=7, value=STOP),
    Sentence("replaced", time=3.4, since=3.4, other="drive", cause=7, value=STOP),
    Sentence("replaced-by-stop", time=0, since=3.1, value=STOP),
    Sentence("replaced-by-end", time=0, since=3.1, value=STOP, other="runTurn", cause=3),
    Sentence("overridden", since=3.1, value=BACK),
    Sentence("beyond-speed", value="Velocity 2.0 0.0", asked=2, limit=0.7),
    Sentence("beyond-turn", value="Velocity 0.0 9.0", asked=9, limit=3.14),
    Sentence("in-the-air", value="Wheel RightWheel Air", time=2.1),
    Sentence("in-the-way", value="Bumper LeftBumper Pressed", time=1),
    Sentence("followed", since=0, until=4, other="spin", cause=3, value=BACK),
    Sentence("followed-changes", since=0, until=4, other="accelerate", cause=3, values=[STOP, BACK]),
    Sentence("stood", since=0, until=4),
    Sentence("followed-others", since=4),
    Sentence("placed", time=4),
    Sentence("not-moved", type="Velocity", time=4),
    Sentence("no-sender", type="Nowhere"),
    Sentence("never-sent", type="Found", functions=["never", "neither", "nor"], since=0, until=9),
    Sentence("no-taker", function="shout", type="Lost", time=2),
    Sentence("received", function="turn", type="ChgDir", time=1),
    Sentence("taker-ended", type="Late", time=2.3, since=2.2, functions=["hear"]),
    Sentence("taker-silent", type="Late", time=2.3, functions=["hear", "see"]),
]


def test_each_sentence_is_worded_as_the_page_words_it() -> None:
    lines = [{"said": msgspec.to_builtins(one), "english": english(one)} for one in SENTENCES]
    if os.environ.get("UPDATE_GOLDENS") == "1":
        GOLDEN.write_text("".join(json.dumps(line) + "\n" for line in lines))
    assert [json.loads(line) for line in GOLDEN.read_text().splitlines()] == lines


def test_every_kind_of_sentence_has_an_example() -> None:
    assert {one.id for one in SENTENCES} == set(get_args(SentenceId))
