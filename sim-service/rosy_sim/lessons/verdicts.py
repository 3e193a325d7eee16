"""
Verdicts: whether the checks of a lesson's step are done, judged by a recorded run and by the graph of the program.

Pure. A verdict says what was seen as a word with arguments, never as a sentence: the page and the command line word it.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterable, Sequence

from ..wire.verdict import Seen, Verdict
from ..world.goals import Reach, Touch
from ..world.properties import read_properties
from .channel_patterns import ChannelPattern, channel_pattern
from .checks import (
    Answers,
    At,
    Back,
    Check,
    Counts,
    Ends,
    Faces,
    Farthest,
    Function,
    Functions,
    Gap,
    Goals,
    Holds,
    Measures,
    Moves,
    Never,
    Raises,
    Reaches,
    Returns,
    Says,
    Sends,
    Silent,
    Still,
    Varies,
)
from .program_graph import ProgramGraph
from .recording import Happening, Recording, Sample

__all__ = ["judge"]

_STANDS = (0.01, 0.05)
"""A robot slower than this stands: m/s, rad/s."""

_SPEED_REACHED = 0.01
"""A speed this near is reached, m/s: the motors approach it step by step."""


def judge(checks: Sequence[Check], recording: Recording, graph: ProgramGraph | None, final: bool) -> list[Verdict]:
    """
    One verdict per check.

    Args:
        graph: None while the compiler has not answered.
        final: nothing more will be recorded: what did not happen until now is missed.
    """
    return [_judged(check, recording, graph, final) for check in checks]


def _judged(check: Check, recording: Recording, graph: ProgramGraph | None, final: bool) -> Verdict:
    match check:
        case Function() | Functions():
            return Verdict(check.id, "open") if graph is None else _structure(check, graph)
        case Holds():
            return _holds(check, recording)
        case Goals():
            return _goals(check, recording, final)
        case At() | Faces():
            return _at_time(check, recording, final)
        case Still():
            return _still(check, recording, final)
        case Moves():
            metres = _driven(recording.samples)
            return _sooner_or_later(check, metres >= check.metres, final, Seen("drove", number=metres))
        case Farthest() | Back() | Gap():
            return _place_left(check, recording, final)
        case Raises():
            return _raises(check, recording, final)
        case Returns():
            return _returns(check, recording, final)
        case Varies():
            found = _matching(channel_pattern(check.command, "command"), recording.commands)
            count = len({command.values for command in found})
            return _sooner_or_later(check, count >= check.least, final, Seen("varied", number=float(count)))
        case Counts():
            return _counts(check, recording, final)
        case Measures():
            return _measures(check, recording, final)
        case Reaches():
            return _reaches(check, recording, final)
        case Ends():
            ended = recording.done is not None and recording.done <= check.by
            return _sooner_or_later(check, ended, final or recording.time > check.by, Seen("goes-on", check.by))
        case Says():
            return _says(check, recording, final)
        case Sends():
            return _sends(check, recording, final)
        case Answers():
            return _answers(check, recording, final)
        case Silent():
            return _silent(check, recording, final)
        case Never():
            return _never(check, recording, final)


def _done(check: Check) -> Verdict:
    return Verdict(check.id, "done")


def _missed(check: Check, seen: Seen) -> Verdict:
    return Verdict(check.id, "missed", seen)


def _sooner_or_later(check: Check, is_done: bool, is_late: bool, seen: Seen) -> Verdict:
    """Done once it has happened, missed when it is too late for it."""
    return _done(check) if is_done else _missed(check, seen) if is_late else Verdict(check.id, "open", seen)


def _structure(check: Function | Functions, graph: ProgramGraph) -> Verdict:
    if isinstance(check, Functions):
        count = len(graph.own)
        return _done(check) if count >= check.least else _missed(check, Seen("functions", number=count))
    takers = [function for function in graph.own if function.takes(check.takes)]
    if any(function.gives(check.gives) for function in takers):
        return _done(check)
    if takers and check.takes and check.gives:
        return _missed(check, Seen("gives-not", name=takers[0].name))
    return _missed(check, Seen("no-function", name=" ".join(check.takes or check.gives)))


def _goals(check: Goals, recording: Recording, final: bool) -> Verdict:
    if not recording.samples:
        # Nothing is known of the goals before the first step.
        return Verdict(check.id, "open")
    for goal in recording.goals:
        if goal.state == "missed":
            return _missed(check, Seen("goal-missed", goal.time, name=goal.title))
    # To stay away from something is done when the time is over without it.
    waiting = [goal for goal in recording.goals if goal.state == "open" and goal.kind != "avoid"]
    if waiting:
        seen = Seen("goal-open", recording.time, number=waiting[0].progress, name=waiting[0].title)
        is_late = check.within is not None and recording.time > check.within
        return _sooner_or_later(check, False, final or is_late, seen)
    for goal in recording.goals:
        if check.within is not None and goal.time is not None and goal.time > check.within + 1e-9:
            return _missed(check, Seen("goal-late", goal.time, name=goal.title))
    is_kept = all(goal.state == "done" for goal in recording.goals) or final
    return _done(check) if is_kept else Verdict(check.id, "open")


def _holds(check: Holds, recording: Recording) -> Verdict:
    (wanted,) = read_properties(check.property)
    told = [] if recording.properties is None else recording.properties.verdicts
    verdict = next((one for one in told if one.property == wanted), None)
    if verdict is None or verdict.state == "open":
        return Verdict(check.id, "open")
    if verdict.state == "held":
        return _done(check)
    return _missed(check, Seen(f"not-{wanted.kind}", verdict.time, verdict.amount))


def _at_time(check: At | Faces, recording: Recording, final: bool) -> Verdict:
    """A robot whose program has ended stands where it was then."""
    place = _place(recording, check.goal)
    now = next((sample for sample in recording.samples if sample.time >= check.time - 1e-9), None)
    if now is None and recording.done is not None and recording.samples:
        now = recording.samples[-1]
    if now is None:
        return _missed(check, Seen("too-short", check.time)) if final else Verdict(check.id, "open")
    if isinstance(check, At):
        gap = math.dist((now.x, now.y), (place.x, place.y)) - place.r
        return _done(check) if gap <= 0 else _missed(check, Seen("away", check.time, gap))
    aim = math.atan2(place.y - now.y, place.x - now.x)
    beside = math.degrees(math.remainder(aim - now.theta, 2 * math.pi))
    return _done(check) if abs(beside) <= check.degrees else _missed(check, Seen("turned", check.time, beside))


def _place(recording: Recording, number: int) -> Reach | Touch:
    places = [goal for goal in recording.arena.goals if isinstance(goal, Reach | Touch)]
    if number >= len(places):
        # The reader of lesson files refuses such a lesson.
        raise RuntimeError(f"a check is about goal {number}, and the room has {len(places)} places")
    return places[number]


def _still(check: Still, recording: Recording, final: bool) -> Verdict:
    speed, turn = _STANDS
    for sample in recording.samples:
        if sample.time >= check.after and (abs(sample.v) > speed or abs(sample.w) > turn):
            return _missed(check, Seen("moved", sample.time))
    lasted = final or recording.done is not None
    return _done(check) if lasted and recording.samples else Verdict(check.id, "open")


def _driven(samples: Sequence[Sample]) -> float:
    return sum(math.dist((a.x, a.y), (b.x, b.y)) for a, b in itertools.pairwise(samples))


def _reaches(check: Reaches, recording: Recording, final: bool) -> Verdict:
    sign = -1.0 if check.speed < 0 else 1.0
    within = [sample.v * sign for sample in recording.samples if sample.time <= check.within + 1e-9]
    fastest = max(within, default=0.0)
    is_late = final or recording.time > check.within
    seen = Seen("fastest" if sign > 0 else "fastest-back", check.within, max(0.0, fastest))
    return _sooner_or_later(check, fastest >= abs(check.speed) - _SPEED_REACHED, is_late, seen)


def _place_left(check: Farthest | Back | Gap, recording: Recording, final: bool) -> Verdict:
    """How far the robot came, or stands at the end, from a place where it was before."""
    if not recording.samples:
        return Verdict(check.id, "open")
    first, last = recording.samples[0], recording.samples[-1]
    is_over = final or recording.done is not None
    if isinstance(check, Farthest):
        gap = max(math.dist((first.x, first.y), (one.x, one.y)) for one in recording.samples)
        seen = Seen("came-far", number=gap)
        if gap > check.metres + check.tolerance:
            return _missed(check, seen)
        return _sooner_or_later(check, is_over and gap >= check.metres - check.tolerance, is_over, seen)
    wanted = 0.0
    if isinstance(check, Gap):
        wanted = check.metres
        events = _matching(channel_pattern(check.event, "event"), recording.events)
        if not events:
            return _sooner_or_later(check, False, is_over, Seen("not-happened", number=0.0, name=check.event))
        first = next(one for one in recording.samples if one.time >= events[0].time - 1e-9)
    gap = math.dist((first.x, first.y), (last.x, last.y))
    seen = Seen("ends-far" if isinstance(check, Gap) else "not-back", number=gap)
    return _sooner_or_later(check, is_over and abs(gap - wanted) <= check.tolerance, is_over, seen)


def _raises(check: Raises, recording: Recording, final: bool) -> Verdict:
    events = _matching(channel_pattern(check.event, "event"), recording.events)
    for event in events:
        latest = event.time + check.within + 1e-9
        before = next((one.v for one in reversed(recording.samples) if one.time < event.time - 1e-9), 0.0)
        fastest = max(one.v for one in recording.samples if event.time - 1e-9 <= one.time <= latest)
        if fastest - before >= check.speed - 1e-9:
            continue
        if recording.time > latest or final or recording.done is not None:
            return _missed(check, Seen("not-faster", event.time, before, check.event))
        return Verdict(check.id, "open")
    if not events:
        return _sooner_or_later(check, False, final, Seen("not-happened", number=0.0, name=check.event))
    return _done(check) if final or recording.done is not None else Verdict(check.id, "open")


def _returns(check: Returns, recording: Recording, final: bool) -> Verdict:
    events = _matching(channel_pattern(check.event, "event"), recording.events)
    commands = _matching(channel_pattern(check.command, "command"), recording.commands)
    if not events:
        return _sooner_or_later(check, False, final, Seen("not-happened", number=0.0, name=check.event))
    before = [command.values for command in commands if command.time < events[0].time - 1e-9]
    others = itertools.dropwhile(
        lambda values: not before or values == before[-1],
        (command.values for command in commands if command.time > events[0].time - 1e-9),
    )
    is_back = any(values == before[-1] for values in others)
    return _sooner_or_later(check, is_back, final, Seen("not-again", number=float(len(events)), name=check.event))


_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


def _numbers(command: Happening) -> list[float]:
    """The numbers in a text that is said."""
    return [float(found) for found in _NUMBER.findall(str(command.values[0]))]


def _counts(check: Counts, recording: Recording, final: bool) -> Verdict:
    events = _matching(channel_pattern(check.event, "event"), recording.events)
    said = [(command.time, _numbers(command)) for command in recording.commands if command.channel == "Say"]
    for time, numbers in said:
        happened = sum(event.time <= time + 1e-9 for event in events)
        if numbers and numbers != [happened]:
            return _missed(check, Seen("miscounted", time, float(happened), f"{numbers[0]:g}"))
    for count, event in enumerate(events, 1):
        until = events[count].time if count < len(events) else math.inf
        is_told = any(numbers == [count] and event.time - 1e-9 <= time < until for time, numbers in said)
        if is_told or (until == math.inf and count > check.least):
            continue
        return _sooner_or_later(
            check, False, until < math.inf or final, Seen("no-answer", event.time, name=check.event)
        )
    seen = Seen("not-happened", number=float(len(events)), name=check.event)
    if len(events) >= check.least:
        return _done(check) if final or recording.done is not None else Verdict(check.id, "open")
    return _sooner_or_later(check, False, final, seen)


def _measures(check: Measures, recording: Recording, final: bool) -> Verdict:
    driven = 0.0
    # A program that says it later, on the way back for example, says how far it was to a bump.
    until_bumps: list[float] = []
    samples = iter(itertools.pairwise(recording.samples))
    for command in recording.commands:
        if command.channel != "Say":
            continue
        for one, other in samples:
            driven += 100 * math.dist((one.x, one.y), (other.x, other.y))
            if other.bumpers and not one.bumpers:
                until_bumps.append(driven)
            if other.time >= command.time - 1e-9:
                break
        # A 0 before the robot has driven measures nothing.
        has_driven = driven > 2 * check.tolerance
        said = _numbers(command)
        if has_driven and any(
            abs(number - way) <= check.tolerance for number in said for way in (driven, *until_bumps)
        ):
            return _done(check)
    seen = Seen("not-measured", number=_driven(recording.samples) * 100)
    return _sooner_or_later(check, False, final or recording.done is not None, seen)


def _says(check: Says, recording: Recording, final: bool) -> Verdict:
    said = [str(command.values[0]) for command in recording.commands if command.channel == "Say"]
    left = list(check.texts)
    for text in said:
        if left and text.strip() == left[0]:
            left.pop(0)
    if not left:
        return _done(check)
    return _sooner_or_later(check, False, final, Seen("not-said", name=left[0]))


def _sends(check: Sends, recording: Recording, final: bool) -> Verdict:
    limit = math.inf if check.within is None else check.within
    found = _matching(channel_pattern(check.command, "command"), recording.commands)
    is_done = any(command.time <= limit + 1e-9 for command in found)
    is_late = final or recording.time > limit
    return _sooner_or_later(check, is_done, is_late, Seen("not-sent", name=check.command))


def _answers(check: Answers, recording: Recording, final: bool) -> Verdict:
    commands = _matching(channel_pattern(check.command, "command"), recording.commands)
    events = _matching(channel_pattern(check.event, "event"), recording.events)
    for event in events:
        latest = event.time + check.within + 1e-9
        if any(event.time - 1e-9 <= command.time <= latest for command in commands):
            continue
        if recording.time > latest or recording.done is not None:
            return _missed(check, Seen("no-answer", event.time, name=check.event))
        if not final:
            return Verdict(check.id, "open")
        # The time of the step was over before the answer was due.
    seen = Seen("not-happened", number=float(len(events)), name=check.event)
    if len(events) >= check.least:
        # A later event may still go without an answer.
        return _done(check) if final or recording.done is not None else Verdict(check.id, "open")
    return _sooner_or_later(check, False, final, seen)


def _silent(check: Silent, recording: Recording, final: bool) -> Verdict:
    commands = _matching(channel_pattern(check.command, "command"), recording.commands)
    events = _matching(channel_pattern(check.event, "event"), recording.events)
    for i, event in enumerate(events):
        until = events[i + 1].time if i + 1 < len(events) and check.after > 0 else math.inf
        for command in commands:
            passed = command.time - event.time
            if check.after - 1e-9 <= passed <= check.within + 1e-9 and command.time < until:
                return _missed(check, Seen("answer", command.time, name=check.event))
    if not events:
        return _sooner_or_later(check, False, final, Seen("not-happened", number=0.0, name=check.event))
    return _done(check) if final or recording.done is not None else Verdict(check.id, "open")


def _never(check: Never, recording: Recording, final: bool) -> Verdict:
    events = _matching(channel_pattern(check.event, "event"), recording.events)
    if events:
        return _missed(check, Seen("happened", events[0].time, name=check.event))
    is_over = final or recording.done is not None
    return _done(check) if is_over and recording.samples else Verdict(check.id, "open")


def _matching(pattern: ChannelPattern, happenings: Iterable[Happening]) -> list[Happening]:
    return [one for one in happenings if pattern.matches(one.channel, one.values)]
