"""
Recorded runs for tests, written as text: what happened, line by line.

A line is ``TIME FUNCTION <- CAUSE | READ, READ -> OUTPUT, OUTPUT``. Firings are counted from 0; ``in N`` behind the
time is the number of the task.

A cause is ``tick``, ``start``, ``wait``, ``end``, ``by N`` (the change of tasks that firing N led to), ``event N`` (the
user event that firing N sent) or a message in Haskell. A read is a value in Haskell; ``Memory …`` and ``Param …`` may
end in `` @N``, the firing that wrote it. An output is a value in Haskell: ``Memory …`` and ``Param …`` are remembered,
``Done …`` ends the task, ``event …`` is a user event, ``call`` a call; all others are commands.

A line ``TIME ! VALUE`` is an event that no function took, ``TIME ! sent VALUE`` a command that no function sent.
"""

from __future__ import annotations

import re
from itertools import groupby

from rosy_sim.explain.recorded_run import RecordedRun
from rosy_sim.explain.recorded_step import ShownCommand
from rosy_sim.wire.firing import Cause, Firing, Given, Taken

__all__ = ["recorded"]

_LINE = re.compile(
    r"(?P<time>[\d.]+)( in (?P<task>\d+))? (?P<name>\S+) <- (?P<cause>.*?)( \| (?P<took>.*?))?( -> (?P<gave>.*))?$"
)
_MEMORY = re.compile(r"(?P<value>(Memory|Param) .*?)( @(?P<by>\d+))?$")


def recorded(text: str, end: float | None = None) -> RecordedRun:
    """The run that a text describes; ``end`` is when its last step was, s, if that was later than the last line."""
    run = RecordedRun()
    lines = [line.strip() for line in text.strip().splitlines()]
    number = 0
    events = 0
    for time, group in groupby(lines, key=lambda line: float(line.split(" ")[0])):
        firings: list[Firing] = []
        sensed: list[str] = []
        commands: list[ShownCommand] = []
        for line in group:
            extra = re.fullmatch(r"[\d.]+ ! (sent )?(.*)", line)
            if extra is not None:
                if extra[1]:
                    commands.append(ShownCommand(_command_type(extra[2]), extra[2]))
                else:
                    sensed.append(extra[2])
                continue
            found = _LINE.fullmatch(line)
            assert found is not None, line
            gave = [_given(one) for one in _list(found["gave"])]
            for index, given in enumerate(gave):
                if given.to == "event":
                    gave[index] = Given("event", given.value, given.type, events)
                    events += 1
            cause = _cause(found["cause"], run, firings)
            if cause.by == "message" and cause.value not in sensed and not cause.value.startswith("Odometry"):
                sensed.append(cause.value)
            sensed += [given.value for given in gave if given.to == "event"]
            commands += [ShownCommand(given.type, given.value) for given in gave if given.to == "command"]
            took = [_taken(one) for one in _list(found["took"])]
            firings.append(Firing(number, found["name"], int(found["task"] or 0), cause, took, gave))
            number += 1
        run.add_step(time, firings, sensed, commands)
    if end is not None:
        run.add_step(end, [], [], [])
    return run


def _list(text: str | None) -> list[str]:
    return text.split(", ") if text else []


def _cause(text: str, run: RecordedRun, firings: list[Firing]) -> Cause:
    plain = {"tick": "tick", "start": "start", "wait": "instant", "end": "end"}
    if text in plain:
        return Cause(plain[text])  # type: ignore[arg-type]
    by = re.fullmatch(r"(by|event) (\d+)", text)
    if by is None:
        return Cause("message", text)
    number = int(by[2])
    if by[1] == "by":
        return Cause("task", firing=number)
    sender = run.firing(number) or next(firing for firing in firings if firing.n == number)
    return Cause("event", event=next(given.event for given in sender.gave if given.to == "event"), firing=number)


def _taken(text: str) -> Taken:
    memory = _MEMORY.fullmatch(text)
    if memory is None:
        states = ("Velocity ", "Position ", "Orientation ", "Pose ")
        if text.startswith("Seconds "):
            return Taken("time", text)
        return Taken("state", text, channel="Odometry") if text.startswith(states) else Taken("event", text)
    by = int(memory["by"]) if memory["by"] else None
    inner = memory["value"].partition(" ")[2]
    return Taken("memory" if memory[2] == "Memory" else "param", memory["value"], f"{memory[2]} {_type(inner)}", by)


def _given(text: str) -> Given:
    word, _, rest = text.partition(" ")
    if word in ("Memory", "Param"):
        return Given("memory" if word == "Memory" else "param", rest, f"{word} {_type(rest)}")
    if word == "event":
        return Given("event", rest, rest.split(" ")[0])
    if word == "call":
        return Given("call")
    return Given("done", text) if word == "Done" else Given("command", text, _command_type(text))


def _command_type(value: str) -> str:
    """The type of a command of the robot: its constructor, of which those of `Sound` have other names."""
    constructor = value.partition(" ")[0]
    return "Sound" if constructor.endswith("Sound") else constructor


def _type(value: str) -> str:
    return "Bool" if value in ("True", "False") else "Int" if value.isdigit() else "Hit"
