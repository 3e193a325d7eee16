"""
Sentences of explanations as translatable sentences. Names of functions are in ``**``, values and types in backquotes.

``languages/<tag>/sentences.json`` has them in other languages. The page has tables of its own (``editor/src/words``),
in which names and values can be pressed; ``protocol/goldens/explanations.jsonl`` holds the English of both together.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from decimal import ROUND_HALF_UP, Decimal

from ..sentences.sentence import PLACEHOLDER, Argument, template, tr
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
    "Button0": tr("button 0"),
    "Button1": tr("button 1"),
    "Button2": tr("button 2"),
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
    text, slots = _TEMPLATES[sentence.id], _Slots(sentence, decimal_mark)
    return Words(text, {name: getattr(slots, name) for _, name in PLACEHOLDER.findall(text)})


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
    """``Memory (Turn 1.0 2.0)``: a memory is shown without its constructor."""
    value = given.value
    is_argument = value.startswith(("(", "[", '"')) or (" " not in value and not value.startswith("-"))
    return f"{given.type.partition(' ')[0]} {value if is_argument else f'({value})'}"


def _one(kind: str) -> Words:
    """A type with its article; the name of a letter may begin with a vowel as well: `an M1`."""
    is_vowel = re.match(r"[AEIO]|[FLMNRSX]\d", kind) is not None
    return tr("an {type}", type=f"`{kind}`") if is_vowel else tr("a {type}", type=f"`{kind}`")


class _Slots:
    """What the placeholders of a sentence stand for."""

    Done = "`Done`"
    simulate = "`simulate`"

    def __init__(self, sentence: Sentence, decimal_mark: str) -> None:
        self._sentence = sentence
        self._mark = decimal_mark

    def _seconds(self, time: float | None) -> Words:
        return tr("{seconds} s", seconds=f"{time or 0.0:.2f}".replace(".", self._mark))

    @property
    def time(self) -> Words:
        return self._seconds(self._sentence.time)

    @property
    def since(self) -> Words:
        return self._seconds(self._sentence.since)

    @property
    def until(self) -> Words:
        return self._seconds(self._sentence.until)

    @property
    def gap(self) -> Words:
        gap = (self._sentence.since or 0.0) - (self._sentence.time or 0.0)
        return tr("in the same instant") if gap < 1e-9 else tr("{gap} later", gap=self._seconds(gap))

    @property
    def earlier(self) -> Words:
        if self._sentence.time is None:
            return tr("None had come before.")
        return tr("The last came at {time}.", time=self.time)

    @property
    def function(self) -> str:
        return f"**{self._sentence.function}**"

    @property
    def other(self) -> str:
        return f"**{self._sentence.other}**"

    @property
    def functions(self) -> Argument:
        return _and([f"**{name}**" for name in self._sentence.functions])

    @property
    def value(self) -> str:
        return _code(self._sentence.value)

    @property
    def first(self) -> str:
        return _code(self._sentence.values[0])

    @property
    def last(self) -> str:
        return _code(self._sentence.values[-1])

    @property
    def number(self) -> int:
        return self._sentence.number or 0

    @property
    def inputs(self) -> Argument:
        """Empty when the function takes nothing."""
        values = self._sentence.values
        return tr(" for {list}", list=_and([_code(value) for value in values])) if values else ""

    @property
    def outputs(self) -> Argument:
        return _and([_output(one) for one in self._sentence.gave]) if self._sentence.gave else tr("nothing")

    @property
    def happened(self) -> Words:
        return _happened(self._sentence.value)

    @property
    def type(self) -> str:
        return f"`{self._sentence.type}`"

    @property
    def command(self) -> Argument:
        return self.type if self._sentence.type else tr("command")

    @property
    def one(self) -> Words:
        return _one(self._sentence.type)

    @property
    def types(self) -> Argument:
        return _or([_one(kind) for kind in self._sentence.types])

    @property
    def asked(self) -> float:
        return self._sentence.asked or 0.0

    @property
    def limit(self) -> float:
        return self._sentence.limit or 0.0


_TEMPLATES: dict[SentenceId, str] = {
    "sent": template("At {time} {function} sent {value}{inputs}."),
    "stopped": template(
        "At {time} the robot was told {value}, because the task that had set it in motion was stopped."
    ),
    "stopped-by": template("At {time} the robot was told {value}, because {other} ended its task with {Done}."),
    "sensed": template("At {time} {happened}."),
    "nothing-ran": template("No function ran because of that."),
    "first-value": template("{type} was {value}, its first value: no function had written it."),
    "old-value": template("{type} was {value} for a long time."),
    "not-written": template("No function had written {type}: it has its first value."),
    "from-start": template("{type} was {value} from the start: what was remembered since then was the same."),
    "remembered": template("{type} was {value} since {since}: {other} remembered it."),
    "had-come": template("{value} had come at {since}."),
    "ran-message": template("{function} ran at {time} because {happened}."),
    "ran-tick": template("{function} ran at {time} because it runs ten times a second."),
    "ran-start": template("{function} ran at {time} because the program began."),
    "ran-wait": template("{function} ran at {time} because a wait was over."),
    "ran-end": template("{function} ran at {time} because the program ended."),
    "ran-unknown": template("{function} ran at {time} because of something that happened before the record begins."),
    "ran-event": template("{function} ran at {time} because {other} sent {value}."),
    "ran-done": template("{function} ran at {time} because {other} ended its task with {Done} at {since}."),
    "ran-call": template("{function} ran at {time} because {other} called a task at {since}."),
    "ran-feedback": template("{function} ran at {time} because {other} gave {value} as feedback at {since}."),
    "ran-task": template("{function} ran at {time} because {other} had run at {since}, and its task went on."),
    "nothing-sent": template("No {command} was sent at {time}."),
    "none-came": template("No {type} had come by {until}."),
    "nothing-sent-yet": template("The program has sent no {command}."),
    "not-recorded": template("The run was not recorded, because many programs were running. Run it again."),
    "not-known-before": template("What happened before {since} is not known any more."),
    "run-over": template("The run had ended at {time}."),
    "run-not-begun": template("The run had not begun."),
    "did-run": template("{function} did run, at {time}{inputs}."),
    "did-send": template("{function} did send {value}, at {time}."),
    "did-take": template("{function} did take this case, at {time}{inputs}."),
    "not-reached": template("Between {since} and {until} no function came to this choice in {function}."),
    "not-part": template("{function} is not part of {simulate}."),
    "task-ended": template("The task of {function} had ended at {time}: {other} gave {Done}."),
    "task-waits": template("{function} belongs to a task that had not begun by {until}."),
    "runs-once": template("{function} runs once, when its task begins. That was at {time}."),
    "lacks": template("{function} takes {types}; none came between {since} and {until}. {earlier}"),
    "ticks": template("{function} runs ten times a second: it ran at {time}, and then again at {until}."),
    "ran-before": template(
        "{function} ran at {time}, and not between {since} and {until}; the record does not tell why."
    ),
    "never-ran": template("{function} has not run between {since} and {until}; the record does not tell why."),
    "gave": template("At {time} {function} ran{inputs} and gave {outputs}."),
    "matched-equation": template("Equation {number} of {function} matched: {value}."),
    "matched-case": template("In {function} case {number} matched: {value}."),
    "guard-held": template("In {function} the guard {value} held."),
    "was-true": template("In {function} {value} was true."),
    "was-false": template("In {function} {value} was not true."),
    "other-type": template("{function} never sends {one}: it gives {types}."),
    "in-force": template("{value} has been in force since {time}."),
    "replaced": template("It was sent at {time}, and {other} replaced it with {value} {gap}."),
    "replaced-by-stop": template(
        "It was sent at {time}, and at {since} the robot was told {value}, because the task that had set it in motion was stopped."  # noqa: E501
    ),
    "replaced-by-end": template(
        "It was sent at {time}, and at {since} the robot was told {value}, because {other} ended its task with {Done}."
    ),
    "beyond-speed": template("{value} asks for {asked} m/s; the robot's limit is {limit} m/s."),
    "beyond-turn": template("{value} asks for {asked} rad/s; the robot's limit is {limit} rad/s."),
    "overridden": template("The safety rules drove the robot from {since} on, and not {value}."),
    "in-the-air": template("It could not drive: {happened} at {time}, and has not found it again."),
    "in-the-way": template("Something is in its way: {happened} at {time}, and has not been released."),
    "followed": template("From {since} to {until} the robot followed {value} from {other}."),
    "followed-changes": template(
        "From {since} to {until} the robot followed commands from {other} between {first} and {last}."
    ),
    "stood": template("From {since} to {until} the robot was told to stand still."),
    "followed-others": template("Before {since} it followed other commands."),
    "placed": template("At {time} a hand put the robot in another place."),
    "not-moved": template("The robot is where it began: no {type} had moved it before {time}."),
    "no-sender": template("No function sends {one}."),
    "never-sent": template("No {type} was sent between {since} and {until}: {functions} did not give one."),
    "no-taker": template("{function} sent {one} at {time}, and no function takes it."),
    "received": template("{function} did receive {one}, at {time}."),
    "taker-ended": template("The first {type} came at {time}, and the task of {functions} had ended at {since}."),
    "taker-silent": template("At {time} {one} was sent, and {functions} did not run with it."),
}
"""Each placeholder is an attribute of ``_Slots``."""
