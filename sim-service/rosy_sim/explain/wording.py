"""
Sentences of explanations as translatable sentences. Names of functions are in ``**``, values and types in backquotes.

``languages`` has them in other languages. The page has tables of its own (``editor/src/words``), in which
names and values can be pressed; ``protocol/goldens/explanations.jsonl`` holds the English of both together.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from decimal import ROUND_HALF_UP, Decimal

from ..sentences.sentence import Argument, tr
from ..sentences.sentence import Sentence as Words
from ..wire.explanation import Sentence, SentenceId
from ..wire.firing import Given

__all__ = ["english", "words_of"]

_PLACES: dict[str, Words] = {
    "LeftBumper": tr("the left bumper"),
    "CenterBumper": tr("the centre bumper"),
    "RightBumper": tr("the right bumper"),
    "LeftCliff": tr("the left cliff sensor"),
    "CenterCliff": tr("the centre cliff sensor"),
    "RightCliff": tr("the right cliff sensor"),
    "LeftWheel": tr("the left wheel"),
    "RightWheel": tr("the right wheel"),
    "Button0": tr("the first button"),
    "Button1": tr("the second button"),
    "Button2": tr("the third button"),
}

_HAPPENED: dict[tuple[str, str], Callable[[Words], Words]] = {
    ("Bumper", "Pressed"): lambda place: tr("{place} was pressed", place=place),
    ("Bumper", "Released"): lambda place: tr("{place} was released", place=place),
    ("Button", "Pressed"): lambda place: tr("{place} was pressed", place=place),
    ("Button", "Released"): lambda place: tr("{place} was released", place=place),
    ("Cliff", "Hole"): lambda place: tr("{place} saw a hole", place=place),
    ("Cliff", "Floor"): lambda place: tr("{place} saw the floor again", place=place),
    ("Wheel", "Air"): lambda place: tr("{place} lost the ground", place=place),
    ("Wheel", "Ground"): lambda place: tr("{place} touched the ground again", place=place),
}


def words_of(sentence: Sentence, decimal_mark: str = ".") -> Words:
    """A sentence to be put into words; numbers have this decimal mark."""
    return _SENTENCES[sentence.id](_Slots(sentence, decimal_mark))


def english(sentence: Sentence) -> str:
    """A sentence in English."""
    return str(words_of(sentence))


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


def _happened(value: str) -> Words:
    """A message, as Haskell shows it, as a clause: ``the centre bumper was pressed``."""
    words = value.split(" ")
    if len(words) == 3 and words[1] in _PLACES and (words[0], words[2]) in _HAPPENED:
        return _HAPPENED[words[0], words[2]](_PLACES[words[1]])
    if value.startswith("Odometry"):
        return tr("the robot reported its motion")
    return tr("{value} came", value=_code(value))


def _and(items: Sequence[Argument]) -> Argument:
    """``a, b and c``."""
    if len(items) < 3:
        return items[0] if len(items) == 1 else tr("{first} and {last}", first=items[0], last=items[1])
    return tr("{first}, {rest}", first=items[0], rest=_and(items[1:]))


def _or(items: Sequence[Argument]) -> Argument:
    """``a, b or c``."""
    if len(items) < 3:
        return items[0] if len(items) == 1 else tr("{first} or {last}", first=items[0], last=items[1])
    return tr("{first}, {rest}", first=items[0], rest=_or(items[1:]))


def _output(given: Given) -> Argument:
    if given.to == "done":
        return "`Done`"
    if given.to == "call":
        return tr("a call")
    if given.to == "feedback":
        return tr("feedback")
    if given.value in ("", "_"):
        return _one(given.type)
    return _code(_remembered(given) if given.to in ("memory", "param") else given.value)


def _remembered(given: Given) -> str:
    """``Memory (Turn 1.0 2.0)``: a memory is told without its constructor."""
    value = given.value
    is_argument = value.startswith(("(", "[", '"')) or (" " not in value and not value.startswith("-"))
    return f"{given.type.partition(' ')[0]} {value if is_argument else f'({value})'}"


def _one(kind: str) -> Words:
    """A type with its article; the name of a letter may begin with a vowel as well: `an M1`."""
    is_vowel = re.match(r"[AEIO]|[FLMNRSX]\d", kind) is not None
    return tr("an {type}", type=f"`{kind}`") if is_vowel else tr("a {type}", type=f"`{kind}`")


class _Slots:
    """What the placeholders of a sentence stand for."""

    def __init__(self, said: Sentence, decimal_mark: str) -> None:
        self._said = said
        self._mark = decimal_mark

    def _seconds(self, time: float | None) -> Words:
        return tr("{seconds} s", seconds=f"{time or 0.0:.2f}".replace(".", self._mark))

    @property
    def time(self) -> Words:
        return self._seconds(self._said.time)

    @property
    def since(self) -> Words:
        return self._seconds(self._said.since)

    @property
    def until(self) -> Words:
        return self._seconds(self._said.until)

    @property
    def gap(self) -> Words:
        gap = (self._said.since or 0.0) - (self._said.time or 0.0)
        return tr("in the same instant") if gap < 1e-9 else tr("{gap} later", gap=self._seconds(gap))

    @property
    def earlier(self) -> Words:
        if self._said.time is None:
            return tr("None had come before.")
        return tr("The last came at {time}.", time=self.time)

    @property
    def function(self) -> str:
        return f"**{self._said.function}**"

    @property
    def other(self) -> str:
        return f"**{self._said.other}**"

    @property
    def functions(self) -> Argument:
        return _and([f"**{name}**" for name in self._said.functions])

    @property
    def value(self) -> str:
        return _code(self._said.value)

    @property
    def first(self) -> str:
        return _code(self._said.values[0])

    @property
    def last(self) -> str:
        return _code(self._said.values[-1])

    @property
    def number(self) -> int:
        return self._said.number or 0

    @property
    def inputs(self) -> Argument:
        """Empty when the function takes nothing."""
        values = self._said.values
        return tr(" for {list}", list=_and([_code(value) for value in values])) if values else ""

    @property
    def outputs(self) -> Argument:
        return _and([_output(one) for one in self._said.gave]) if self._said.gave else tr("nothing")

    @property
    def happened(self) -> Words:
        return _happened(self._said.value)

    @property
    def type(self) -> str:
        return f"`{self._said.type}`"

    @property
    def command(self) -> Argument:
        return self.type if self._said.type else tr("command")

    @property
    def one(self) -> Words:
        return _one(self._said.type)

    @property
    def types(self) -> Argument:
        return _or([_one(kind) for kind in self._said.types])

    @property
    def asked(self) -> float:
        return self._said.asked or 0.0

    @property
    def limit(self) -> float:
        return self._said.limit or 0.0


_SENTENCES: dict[SentenceId, Callable[[_Slots], Words]] = {
    "sent": lambda s: tr(
        "At {time} {function} sent {value}{inputs}.", time=s.time, function=s.function, value=s.value, inputs=s.inputs
    ),
    "stopped": lambda s: tr(
        "At {time} the robot was told {value}, because the task that had set it in motion was stopped.",
        time=s.time,
        value=s.value,
    ),
    "stopped-by": lambda s: tr(
        "At {time} the robot was told {value}, because {other} ended its task with {Done}.",
        time=s.time,
        value=s.value,
        other=s.other,
        Done="`Done`",
    ),
    "sensed": lambda s: tr("At {time} {happened}.", time=s.time, happened=s.happened),
    "nothing-ran": lambda _: tr("No function ran because of that."),
    "first-value": lambda s: tr(
        "{type} was {value}, its first value: no function had written it.", type=s.type, value=s.value
    ),
    "old-value": lambda s: tr("{type} was {value} for a long time.", type=s.type, value=s.value),
    "not-written": lambda s: tr("No function had written {type}: it has its first value.", type=s.type),
    "from-start": lambda s: tr(
        "{type} was {value} from the start: what was remembered since then was the same.", type=s.type, value=s.value
    ),
    "remembered": lambda s: tr(
        "{type} was {value} since {since}: {other} remembered it.",
        type=s.type,
        value=s.value,
        since=s.since,
        other=s.other,
    ),
    "had-come": lambda s: tr("{value} had come at {since}.", value=s.value, since=s.since),
    "ran-message": lambda s: tr(
        "{function} ran at {time} because {happened}.", function=s.function, time=s.time, happened=s.happened
    ),
    "ran-tick": lambda s: tr(
        "{function} ran at {time} because it runs ten times a second.", function=s.function, time=s.time
    ),
    "ran-start": lambda s: tr("{function} ran at {time} because the program began.", function=s.function, time=s.time),
    "ran-wait": lambda s: tr("{function} ran at {time} because a wait was over.", function=s.function, time=s.time),
    "ran-end": lambda s: tr("{function} ran at {time} because the program ended.", function=s.function, time=s.time),
    "ran-unknown": lambda s: tr(
        "{function} ran at {time} because of something that happened before the record begins.",
        function=s.function,
        time=s.time,
    ),
    "ran-event": lambda s: tr(
        "{function} ran at {time} because {other} sent {value}.",
        function=s.function,
        time=s.time,
        other=s.other,
        value=s.value,
    ),
    "ran-done": lambda s: tr(
        "{function} ran at {time} because {other} ended its task with {Done} at {since}.",
        function=s.function,
        time=s.time,
        other=s.other,
        Done="`Done`",
        since=s.since,
    ),
    "ran-call": lambda s: tr(
        "{function} ran at {time} because {other} called a task at {since}.",
        function=s.function,
        time=s.time,
        other=s.other,
        since=s.since,
    ),
    "ran-feedback": lambda s: tr(
        "{function} ran at {time} because {other} gave {value} as feedback at {since}.",
        function=s.function,
        time=s.time,
        other=s.other,
        value=s.value,
        since=s.since,
    ),
    "ran-task": lambda s: tr(
        "{function} ran at {time} because {other} had run at {since}, and its task went on.",
        function=s.function,
        time=s.time,
        other=s.other,
        since=s.since,
    ),
    "nothing-sent": lambda s: tr("No {command} was sent at {time}.", command=s.command, time=s.time),
    "none-came": lambda s: tr("No {type} had come by {until}.", type=s.type, until=s.until),
    "nothing-sent-yet": lambda s: tr("The program has sent no {command}.", command=s.command),
    "not-recorded": lambda _: tr("The run was not recorded, because many programs were running. Run it again."),
    "not-known-before": lambda s: tr("What happened before {since} is not known any more.", since=s.since),
    "run-over": lambda s: tr("The run had ended at {time}.", time=s.time),
    "run-not-begun": lambda _: tr("The run had not begun."),
    "did-run": lambda s: tr(
        "{function} did run, at {time}{inputs}.", function=s.function, time=s.time, inputs=s.inputs
    ),
    "did-send": lambda s: tr(
        "{function} did send {value}, at {time}.", function=s.function, value=s.value, time=s.time
    ),
    "did-take": lambda s: tr(
        "{function} did take this case, at {time}{inputs}.", function=s.function, time=s.time, inputs=s.inputs
    ),
    "not-reached": lambda s: tr(
        "Between {since} and {until} no function came to this choice in {function}.",
        since=s.since,
        until=s.until,
        function=s.function,
    ),
    "not-part": lambda s: tr("{function} is not part of {simulate}.", function=s.function, simulate="`simulate`"),
    "task-ended": lambda s: tr(
        "The task of {function} had ended at {time}: {other} gave {Done}.",
        function=s.function,
        time=s.time,
        other=s.other,
        Done="`Done`",
    ),
    "task-waits": lambda s: tr(
        "{function} belongs to a task that had not begun by {until}.", function=s.function, until=s.until
    ),
    "runs-once": lambda s: tr(
        "{function} runs once, when its task begins. That was at {time}.", function=s.function, time=s.time
    ),
    "lacks": lambda s: tr(
        "{function} takes {types}; none came between {since} and {until}. {earlier}",
        function=s.function,
        types=s.types,
        since=s.since,
        until=s.until,
        earlier=s.earlier,
    ),
    "ticks": lambda s: tr(
        "{function} runs ten times a second: it ran at {time}, and then again at {until}.",
        function=s.function,
        time=s.time,
        until=s.until,
    ),
    "ran-before": lambda s: tr(
        "{function} ran at {time}, and not between {since} and {until}; the record does not tell why.",
        function=s.function,
        time=s.time,
        since=s.since,
        until=s.until,
    ),
    "never-ran": lambda s: tr(
        "{function} has not run between {since} and {until}; the record does not tell why.",
        function=s.function,
        since=s.since,
        until=s.until,
    ),
    "gave": lambda s: tr(
        "At {time} {function} ran{inputs} and gave {outputs}.",
        time=s.time,
        function=s.function,
        inputs=s.inputs,
        outputs=s.outputs,
    ),
    "matched-equation": lambda s: tr(
        "Equation {number} of {function} matched: {value}.", number=s.number, function=s.function, value=s.value
    ),
    "matched-case": lambda s: tr(
        "In {function} case {number} matched: {value}.", function=s.function, number=s.number, value=s.value
    ),
    "guard-held": lambda s: tr("In {function} the guard {value} held.", function=s.function, value=s.value),
    "was-true": lambda s: tr("In {function} {value} was true.", function=s.function, value=s.value),
    "was-false": lambda s: tr("In {function} {value} was not true.", function=s.function, value=s.value),
    "other-type": lambda s: tr(
        "{function} never sends {one}: it gives {types}.", function=s.function, one=s.one, types=s.types
    ),
    "in-force": lambda s: tr("{value} has been in force since {time}.", value=s.value, time=s.time),
    "replaced": lambda s: tr(
        "It was sent at {time}, and {other} replaced it with {value} {gap}.",
        time=s.time,
        other=s.other,
        value=s.value,
        gap=s.gap,
    ),
    "replaced-by-stop": lambda s: tr(
        "It was sent at {time}, and at {since} the robot was told {value}, because the task that had set it in motion was stopped.",  # noqa: E501
        time=s.time,
        since=s.since,
        value=s.value,
    ),
    "replaced-by-end": lambda s: tr(
        "It was sent at {time}, and at {since} the robot was told {value}, because {other} ended its task with {Done}.",
        time=s.time,
        since=s.since,
        value=s.value,
        other=s.other,
        Done="`Done`",
    ),
    "beyond-speed": lambda s: tr(
        "{value} asks for {asked} m/s; the robot's limit is {limit} m/s.", value=s.value, asked=s.asked, limit=s.limit
    ),
    "beyond-turn": lambda s: tr(
        "{value} asks for {asked} rad/s; the robot's limit is {limit} rad/s.",
        value=s.value,
        asked=s.asked,
        limit=s.limit,
    ),
    "overridden": lambda s: tr(
        "The safety rules drove the robot from {since} on, and not {value}.", since=s.since, value=s.value
    ),
    "in-the-air": lambda s: tr(
        "It could not drive: {happened} at {time}, and has not found it again.", happened=s.happened, time=s.time
    ),
    "in-the-way": lambda s: tr(
        "Something is in its way: {happened} at {time}, and has not been released.", happened=s.happened, time=s.time
    ),
    "followed": lambda s: tr(
        "From {since} to {until} the robot followed {value} from {other}.",
        since=s.since,
        until=s.until,
        value=s.value,
        other=s.other,
    ),
    "followed-changes": lambda s: tr(
        "From {since} to {until} the robot followed commands from {other} between {first} and {last}.",
        since=s.since,
        until=s.until,
        other=s.other,
        first=s.first,
        last=s.last,
    ),
    "stood": lambda s: tr("From {since} to {until} the robot was told to stand still.", since=s.since, until=s.until),
    "followed-others": lambda s: tr("Before {since} it followed other commands.", since=s.since),
    "placed": lambda s: tr("At {time} a hand put the robot in another place.", time=s.time),
    "not-moved": lambda s: tr(
        "The robot is where it began: no {type} had moved it before {time}.", type=s.type, time=s.time
    ),
    "no-sender": lambda s: tr("No function sends {one}.", one=s.one),
    "never-sent": lambda s: tr(
        "No {type} was sent between {since} and {until}: {functions} did not give one.",
        type=s.type,
        since=s.since,
        until=s.until,
        functions=s.functions,
    ),
    "no-taker": lambda s: tr(
        "{function} sent {one} at {time}, and no function takes it.", function=s.function, one=s.one, time=s.time
    ),
    "received": lambda s: tr("{function} did receive {one}, at {time}.", function=s.function, one=s.one, time=s.time),
    "taker-ended": lambda s: tr(
        "The first {type} came at {time}, and the task of {functions} had ended at {since}.",
        type=s.type,
        time=s.time,
        functions=s.functions,
        since=s.since,
    ),
    "taker-silent": lambda s: tr(
        "At {time} {one} was sent, and {functions} did not run with it.", time=s.time, one=s.one, functions=s.functions
    ),
}
