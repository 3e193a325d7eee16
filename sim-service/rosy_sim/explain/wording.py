"""
Sentences of explanations in English. Names of functions are in ``**``, values and types in backquotes.

The page has the same table in each of its languages (``editor/src/words``); ``protocol/goldens/explanations.jsonl``
holds the two together.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from decimal import ROUND_HALF_UP, Decimal

from ..wire.explanation import Sentence, SentenceId
from ..wire.firing import Given

__all__ = ["english"]

_SIDES = {
    "LeftBumper": "the left bumper",
    "CenterBumper": "the centre bumper",
    "RightBumper": "the right bumper",
    "LeftCliff": "the left cliff sensor",
    "CenterCliff": "the centre cliff sensor",
    "RightCliff": "the right cliff sensor",
    "LeftWheel": "the left wheel",
    "RightWheel": "the right wheel",
    "Button0": "the first button",
    "Button1": "the second button",
    "Button2": "the third button",
}

_HAPPENED = {
    ("Bumper", "Pressed"): "was pressed",
    ("Bumper", "Released"): "was released",
    ("Button", "Pressed"): "was pressed",
    ("Button", "Released"): "was released",
    ("Cliff", "Hole"): "saw a hole",
    ("Cliff", "Floor"): "saw the floor again",
    ("Wheel", "Air"): "lost the ground",
    ("Wheel", "Ground"): "touched the ground again",
}


def english(sentence: Sentence) -> str:
    """A sentence in English."""
    return _SENTENCES[sentence.id](sentence)


_NUMBER = r"\d+\.\d+e-\d+|\d+\.\d{5,}(?![\de])"
_FRACTION = re.compile(rf"\(-({_NUMBER})\)|({_NUMBER})")
"""A number with a long fraction; a negative argument is in parentheses."""


def _code(haskell: str) -> str:
    """A value as Haskell shows it, in backquotes, with fractions cut to four digits."""
    return f"`{_FRACTION.sub(_shortened, haskell)}`"


def _shortened(found: re.Match[str]) -> str:
    number = Decimal(found[1] or found[2]).quantize(Decimal("0.0001"), ROUND_HALF_UP)
    digits = f"{number:f}".rstrip("0")
    short = f"{digits}0" if digits.endswith(".") else digits
    return f"(-{short})" if found[1] and number else short


def _at(time: float | None) -> str:
    return f"{time or 0.0:.2f} s"


def _happened(value: str) -> str:
    """A message, as Haskell shows it, as a clause: ``the centre bumper was pressed``."""
    words = value.split(" ")
    if len(words) == 3 and words[1] in _SIDES and (words[0], words[2]) in _HAPPENED:
        return f"{_SIDES[words[1]]} {_HAPPENED[words[0], words[2]]}"
    if value.startswith("Odometry"):
        return "the robot reported its motion"
    return f"{_code(value)} came"


def _and(texts: Sequence[str]) -> str:
    return texts[0] if len(texts) == 1 else ", ".join(texts[:-1]) + " and " + texts[-1]


def _functions(s: Sentence) -> str:
    return _and([f"**{name}**" for name in s.functions])


def _inputs(s: Sentence) -> str:
    """`` for `Hit True` and `Velocity 0.0 0.0` ``; empty when the function takes nothing."""
    return " for " + _and([_code(value) for value in s.values]) if s.values else ""


def _outputs(gave: list[Given]) -> str:
    return _and([_output(one) for one in gave]) if gave else "nothing"


def _output(given: Given) -> str:
    if given.to == "done":
        return "`Done`"
    if given.to in ("call", "feedback"):
        return {"call": "a call", "feedback": "feedback"}[given.to]
    if given.value in ("", "_"):
        return _one(given.type)
    return _code(_remembered(given) if given.to in ("memory", "param") else given.value)


def _remembered(given: Given) -> str:
    """``Memory (Turn 1.0 2.0)``: a memory is told without its constructor."""
    value = given.value
    is_argument = value.startswith(("(", "[", '"')) or (" " not in value and not value.startswith("-"))
    return f"{given.type.partition(' ')[0]} {value if is_argument else f'({value})'}"


def _one(kind: str) -> str:
    """A type with its article; the name of a letter may begin with a vowel as well: `an M1`."""
    is_vowel = re.match(r"[AEIO]|[FLMNRSX]\d", kind) is not None
    return f"{'an' if is_vowel else 'a'} `{kind}`"


def _gap(s: Sentence) -> str:
    gap = (s.since or 0.0) - (s.time or 0.0)
    return "in the same instant" if gap < 1e-9 else f"{gap:.2f} s later"


def _ran(s: Sentence) -> str:
    return f"**{s.function}** ran at {_at(s.time)} because"


def _last(s: Sentence) -> str:
    return "None had come before." if s.time is None else f"The last came at {_at(s.time)}."


def _or(kinds: Sequence[str]) -> str:
    *first, last = [_one(kind) for kind in kinds]
    return f"{', '.join(first)} or {last}" if first else last


def _from_to(s: Sentence) -> str:
    return f"From {_at(s.since)} to {_at(s.until)}"


def _between(s: Sentence) -> str:
    return f"between {_at(s.since)} and {_at(s.until)}"


_SENTENCES: dict[SentenceId, Callable[[Sentence], str]] = {
    "sent": lambda s: f"At {_at(s.time)} **{s.function}** sent {_code(s.value)}{_inputs(s)}.",
    "stopped": lambda s: (
        f"At {_at(s.time)} the robot was told {_code(s.value)}, because the task that had set it in motion was stopped."
    ),
    "stopped-by": lambda s: (
        f"At {_at(s.time)} the robot was told {_code(s.value)}, because **{s.other}** ended its task with `Done`."
    ),
    "sensed": lambda s: f"At {_at(s.time)} {_happened(s.value)}.",
    "nothing-ran": lambda _: "No function ran because of that.",
    "first-value": lambda s: f"`{s.type}` was {_code(s.value)}, its first value: no function had written it.",
    "old-value": lambda s: f"`{s.type}` was {_code(s.value)} for a long time.",
    "not-written": lambda s: f"No function had written `{s.type}`: it has its first value.",
    "remembered": lambda s: f"`{s.type}` was {_code(s.value)} since {_at(s.since)}: **{s.other}** remembered it.",
    "had-come": lambda s: f"{_code(s.value)} had come at {_at(s.since)}.",
    "ran-message": lambda s: f"{_ran(s)} {_happened(s.value)}.",
    "ran-tick": lambda s: f"{_ran(s)} it runs ten times a second.",
    "ran-start": lambda s: f"{_ran(s)} the program began.",
    "ran-wait": lambda s: f"{_ran(s)} a wait was over.",
    "ran-end": lambda s: f"{_ran(s)} the program ended.",
    "ran-unknown": lambda s: f"{_ran(s)} of something that happened before the record begins.",
    "ran-event": lambda s: f"{_ran(s)} **{s.other}** sent {_code(s.value)}.",
    "ran-done": lambda s: f"{_ran(s)} **{s.other}** ended its task with `Done` at {_at(s.since)}.",
    "ran-call": lambda s: f"{_ran(s)} **{s.other}** called a task at {_at(s.since)}.",
    "ran-feedback": lambda s: f"{_ran(s)} **{s.other}** gave {_code(s.value)} as feedback at {_at(s.since)}.",
    "ran-task": lambda s: f"{_ran(s)} **{s.other}** had run at {_at(s.since)}, and its task went on.",
    "nothing-sent": lambda s: (
        f"No `{s.type}` was sent at {_at(s.time)}." if s.type else f"No command was sent at {_at(s.time)}."
    ),
    "nothing-sent-yet": lambda s: (
        f"The program has sent no `{s.type}`." if s.type else "The program has sent no command."
    ),
    "not-recorded": lambda _: "The run was not recorded, because many programs were running. Run it again.",
    "not-known-before": lambda s: f"What happened before {_at(s.since)} is not known any more.",
    "run-over": lambda s: f"The run had ended at {_at(s.time)}.",
    "run-not-begun": lambda _: "The run had not begun.",
    "did-run": lambda s: f"**{s.function}** did run, at {_at(s.time)}{_inputs(s)}.",
    "did-send": lambda s: f"**{s.function}** did send {_code(s.value)}, at {_at(s.time)}.",
    "not-part": lambda s: f"**{s.function}** is not part of `simulate`.",
    "task-ended": lambda s: f"The task of **{s.function}** had ended at {_at(s.time)}: **{s.other}** gave `Done`.",
    "task-waits": lambda s: f"**{s.function}** belongs to a task that had not begun by {_at(s.until)}.",
    "runs-once": lambda s: f"**{s.function}** runs once, when its task begins. That was at {_at(s.time)}.",
    "lacks": lambda s: f"**{s.function}** takes {_or(s.types)}; none came {_between(s)}. {_last(s)}",
    "ticks": lambda s: (
        f"**{s.function}** runs ten times a second: it ran at {_at(s.time)}, and then again at {_at(s.until)}."
    ),
    "ran-before": lambda s: (
        f"**{s.function}** ran at {_at(s.time)}, and not {_between(s)}; the record does not tell why."
    ),
    "never-ran": lambda s: f"**{s.function}** has not run {_between(s)}; the record does not tell why.",
    "gave": lambda s: f"At {_at(s.time)} **{s.function}** ran{_inputs(s)} and gave {_outputs(s.gave)}.",
    "other-type": lambda s: f"**{s.function}** never sends {_one(s.type)}: it gives {_or(s.types)}.",
    "in-force": lambda s: f"{_code(s.value)} has been in force since {_at(s.time)}.",
    "replaced": lambda s: (
        f"It was sent at {_at(s.time)}, and **{s.other}** replaced it with {_code(s.value)} {_gap(s)}."
    ),
    "replaced-by-stop": lambda s: (
        f"It was sent at {_at(s.time)}, and at {_at(s.since)} the robot was told {_code(s.value)}, because "
        "the task that had set it in motion was stopped."
    ),
    "replaced-by-end": lambda s: (
        f"It was sent at {_at(s.time)}, and at {_at(s.since)} the robot was told {_code(s.value)}, because "
        f"**{s.other}** ended its task with `Done`."
    ),
    "beyond-speed": lambda s: f"{_code(s.value)} asks for {s.asked:g} m/s; the robot's limit is {s.limit:g} m/s.",
    "beyond-turn": lambda s: f"{_code(s.value)} asks for {s.asked:g} rad/s; the robot's limit is {s.limit:g} rad/s.",
    "overridden": lambda s: f"The safety rules drove the robot from {_at(s.since)} on, and not {_code(s.value)}.",
    "in-the-air": lambda s: f"It could not drive: {_happened(s.value)} at {_at(s.time)}, and has not found it again.",
    "in-the-way": lambda s: (
        f"Something is in its way: {_happened(s.value)} at {_at(s.time)}, and has not been released."
    ),
    "followed": lambda s: f"{_from_to(s)} the robot followed {_code(s.value)} from **{s.other}**.",
    "followed-changes": lambda s: (
        f"{_from_to(s)} the robot followed commands from **{s.other}** between {_code(s.values[0])} and "
        f"{_code(s.values[-1])}."
    ),
    "stood": lambda s: f"{_from_to(s)} the robot was told to stand still.",
    "followed-others": lambda s: f"Before {_at(s.since)} it followed other commands.",
    "placed": lambda s: f"At {_at(s.time)} a hand put the robot in another place.",
    "not-moved": lambda s: f"The robot is where it began: no `{s.type}` had moved it before {_at(s.time)}.",
    "no-sender": lambda s: f"No function sends {_one(s.type)}.",
    "never-sent": lambda s: f"No `{s.type}` was sent {_between(s)}: {_functions(s)} did not give one.",
    "no-taker": lambda s: f"**{s.function}** sent {_one(s.type)} at {_at(s.time)}, and no function takes it.",
    "received": lambda s: f"**{s.function}** did receive {_one(s.type)}, at {_at(s.time)}.",
    "taker-ended": lambda s: (
        f"The first `{s.type}` came at {_at(s.time)}, and the task of {_functions(s)} had ended at {_at(s.since)}."
    ),
    "taker-silent": lambda s: f"At {_at(s.time)} {_one(s.type)} was sent, and {_functions(s)} did not run with it.",
}
