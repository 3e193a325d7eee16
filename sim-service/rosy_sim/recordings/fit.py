"""
Fit of the simulated base to a real one: from what a recorded run told the wheels, and what the odometry says of it.

The commands go through the simulator's motor model. The way and the turn that it predicts are compared with those of
the odometry, in windows of half a second; the parameters of ``world.realism`` that explain them best are the least
squares, without the windows that fit far worse than most: there a message was late, or a wheel caught. A base may
accelerate faster than that of the simulator: this is allowed for, and not part of the result. What the odometry does
not notice, as a wheel that spins on a smooth floor, cannot be found in it. Pure.
"""

from __future__ import annotations

import itertools
import math
import statistics
from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import msgspec

from ..wire.channels import BadMessage, Channel, Values
from ..wire.topics import CHANNELS, ODOMETRY
from ..world.events import VELOCITY_CHANNEL
from ..world.motor_controller import MotorController
from ..world.realism import LIMITS
from ..world.robot import MotorLimits
from .link_log import LinkLine, publication

__all__ = ["Fit", "Moved", "RecordedDrive", "Told", "fit", "recorded_drive"]

_WINDOW = 0.5
"""Time whose motion is compared at once, s. Shorter ones are more disturbed by the times of messages."""

_FINE = 0.005
"""Step of the prediction, s: messages come at any time."""

_LATENCIES = [n / 100 for n in range(51)]
"""Delays of commands that are tried, s."""

_LONGEST = 600.0
"""Of a run that is looked at, s: ten minutes tell as much as an hour, and take seconds."""

_SETTLED = 0.25
"""After a change of the velocity the base has come near to it, s."""

_LATE = 0.3
"""How late a measurement that comes at a fixed rate may be read, s."""

_TIMES_MEDIAN, _EXACT = 3.0, 0.001
"""A window whose error is more times the median one than this, and more than this (m), is left out."""

_ROUNDS = 5
"""Of leaving out windows: each is judged by the fit without those of the round before."""

_LEAST_WAY, _LEAST_TURN = 0.3, 1.0
"""A way (m) and a turn (rad) in which a few per cent are more than an error of measurement."""


class Told(NamedTuple):
    """A velocity for the wheels: when, s; m/s and rad/s."""

    time: float
    v: float
    w: float


class Moved(NamedTuple):
    """The odometry: when, s; m, m, rad."""

    time: float
    x: float
    y: float
    theta: float


@dataclass(frozen=True, slots=True)
class RecordedDrive:
    """A recorded run as far as a fit needs it, in the order of time."""

    told: list[Told]
    moved: list[Moved]
    # From when to when something held the robot, s.
    held: list[tuple[float, float]]


@dataclass(frozen=True, slots=True)
class Fit:
    """Parameters of ``realism``; None where the robot drove or turned too little to tell."""

    travel: float | None
    turning: float | None
    veer: float | None
    latency: float | None
    # What the motor model predicts for all that was compared: m and rad, forwards and backwards.
    way: float
    turn: float

    def realism(self) -> dict[str, float]:
        """What was found, as in a world, within its limits."""
        return {key: round(_limited(key, value), 4) for key, value in self._found().items()}

    def beyond(self) -> dict[str, float]:
        """The limits of those parameters for which more, or less, was found than a world may have."""
        return {key: _limited(key, value) for key, value in self._found().items() if _limited(key, value) != value}

    def _found(self) -> dict[str, float]:
        found = {"travel": self.travel, "turning": self.turning, "veer": self.veer, "latency": self.latency}
        return {key: value for key, value in found.items() if value is not None}


_VELOCITY = CHANNELS[VELOCITY_CHANNEL]

_TOUCHES = {channel.topic: channel for channel in CHANNELS.values() if channel.name in ("Bumper", "Wheel")}
"""Events that say that something holds the robot, each with its place and its state."""

_object = msgspec.json.Decoder(dict[str, Any])


def recorded_drive(lines: Iterable[LinkLine]) -> RecordedDrive:
    """
    What the lines of a recording tell of wheels and odometry; what cannot be read is left out.

    Topics and fields are those of the robot link, which has the simulated robot's on every robot (protocol, section 2).
    """
    drive = RecordedDrive([], [], [])
    touched: dict[tuple[str, Values], float] = {}
    now = 0.0
    for line in lines:
        now = line.time / 1e9
        published = publication(line.text)
        if published is None:
            continue
        topic, data = published
        try:
            if line.source == "to_robot" and topic == _VELOCITY.topic:
                drive.told.extend(Told(now, v, w) for v, w in _numbers(_VELOCITY, data, 2))
            elif line.source == "to_program" and topic == ODOMETRY.topic:
                drive.moved.extend(Moved(now, x, y, theta) for x, y, theta in _numbers(ODOMETRY, data, 3))
            elif line.source == "to_program" and topic in _TOUCHES:
                *place, state = _TOUCHES[topic].read(_object.decode(data))
                key = (topic, tuple(place))
                if state:
                    touched.setdefault(key, now)
                elif key in touched:
                    drive.held.append((touched.pop(key), now))
        except (msgspec.DecodeError, BadMessage):
            continue
    drive.held.extend((since, now) for since in touched.values())
    return drive


def _numbers(channel: Channel, data: bytes, count: int) -> list[list[float]]:
    """The first values of a message; none of a message without them, which is no measurement."""
    message = _object.decode(data)
    return [[float(value) for value in channel.read(message)[:count]]] if channel.is_in(message, count) else []


def fit(drive: RecordedDrive, usual: MotorLimits) -> Fit:
    """The parameters with which a simulated base with these motors moves most like the recorded one."""
    real = _real_path(_evenly_timed(drive.moved))
    end = real.begin + min(real.length, _LONGEST)
    windows = _not_held(drive, _pieces(real.begin, end, int((end - real.begin) / _WINDOW)))
    moved = [real.between(since, until) for since, until in windows]
    best: tuple[float, float, Fit, _Path] | None = None
    base = usual.wheelbase / 2
    prompt = replace(usual, acceleration=math.inf, angular_acceleration=math.inf)
    for limits in (usual, prompt):
        predicted = _predicted_path(drive.told, real.begin, end, limits)
        for latency in _LATENCIES:
            told = [predicted.between(since - latency, until - latency) for since, until in windows]
            pairs = list(zip(told, moved, strict=True))
            found = _solve(pairs, latency)
            error = sum(_squared_errors(pairs, found, base))
            if best is None or error < best[0] - 1e-12:
                best = (error, latency, found, predicted)
    assert best is not None
    _, latency, found, predicted = best
    # When a command arrived is less certain than how long the base kept to it.
    steady = _not_held(drive, _steady(drive.told, end, latency))
    for these in (steady, windows):
        pairs = [(predicted.between(a - latency, b - latency), real.between(a, b)) for a, b in these]
        better = _without_outliers(pairs, _solve(pairs, latency), base)
        if better.realism().keys() == found.realism().keys():
            return better
    return found


def _pieces(since: float, until: float, count: int) -> list[tuple[float, float]]:
    """A time in so many equal parts."""
    edges = [since + (until - since) * number / max(count, 1) for number in range(count + 1)]
    return list(itertools.pairwise(edges))


def _not_held(drive: RecordedDrive, windows: Iterable[tuple[float, float]]) -> list[tuple[float, float]]:
    """Without those near a time in which something held it: that slows it before and after it is felt."""
    return [
        (since, until)
        for since, until in windows
        if not any(begun < until + _WINDOW and over > since - _WINDOW for begun, over in drive.held)
    ]


def _steady(told: Sequence[Told], end: float, latency: float) -> list[tuple[float, float]]:
    """Windows in which the base had kept to one velocity for a while."""
    changes = [now for before, now in itertools.pairwise(told) if now[1:] != before[1:]]
    times = [*(t.time for t in (*told[:1], *changes)), end]
    windows: list[tuple[float, float]] = []
    for change, following in itertools.pairwise(times):
        since, until = change + latency + _SETTLED, min(following + latency, end)
        if until - since >= _SETTLED:
            windows += _pieces(since, until, max(1, int((until - since) / _WINDOW)))
    return windows


def _without_outliers(pairs: Sequence[tuple[_Window, _Window]], found: Fit, base: float) -> Fit:
    """The fit to those windows that it explains about as well as most; as it was where the others tell too little."""
    if not pairs:
        return found
    for _ in range(_ROUNDS):
        errors = [math.sqrt(error) for error in _squared_errors(pairs, found, base)]
        most = max(_EXACT, _TIMES_MEDIAN * statistics.median(errors))
        kept = [pair for pair, error in zip(pairs, errors, strict=True) if error <= most]
        better = _solve(kept, found.latency or 0.0)
        if better.realism().keys() != found.realism().keys():
            return found
        found = better
    return found


_Window = tuple[float, float]
"""Way (m) and turn (rad) in half a second."""


def _solve(pairs: Sequence[tuple[_Window, _Window]], latency: float) -> Fit:
    """
    The least squares: the real way is ``travel`` times the predicted one, the real turn is ``turning`` times the
    predicted one and ``veer`` times the real way.
    """
    way, turn = sum(abs(p[0]) for p, _ in pairs), sum(abs(p[1]) for p, _ in pairs)
    drove, turned = way >= _LEAST_WAY, turn >= _LEAST_TURN
    travel = _slope([(p[0], r[0]) for p, r in pairs]) if drove else None
    turning: float | None = None
    veer: float | None = None
    if drove and turned:
        turning, veer = _two_slopes([(p[1], r[0], r[1]) for p, r in pairs])
    elif turned:
        turning = _slope([(p[1], r[1]) for p, r in pairs])
    elif drove:
        veer = _slope([(r[0], r[1] - p[1]) for p, r in pairs])
    return Fit(travel, turning, veer, latency if drove or turned else None, way, turn)


def _squared_errors(pairs: Sequence[tuple[_Window, _Window]], found: Fit, base: float) -> list[float]:
    """
    What the parameters leave unexplained in each window, m²: of the way, and of the turn as that of a wheel ``base`` m
    from the middle.
    """
    travel, turning = (1.0 if value is None else value for value in (found.travel, found.turning))
    veer = found.veer or 0.0
    return [
        (real_ahead - ahead * travel) ** 2 + (base * (real_left - left * turning - real_ahead * veer)) ** 2
        for (ahead, left), (real_ahead, real_left) in pairs
    ]


def _slope(points: Sequence[tuple[float, float]]) -> float | None:
    squares = sum(x * x for x, _ in points)
    return sum(x * y for x, y in points) / squares if squares > 0 else None


def _two_slopes(points: Sequence[tuple[float, float, float]]) -> tuple[float | None, float | None]:
    """a and b of z = a x + b y; b is None where x and y cannot be told apart, as on one arc."""
    xx = sum(x * x for x, _, _ in points)
    yy = sum(y * y for _, y, _ in points)
    xy = sum(x * y for x, y, _ in points)
    xz = sum(x * z for x, _, z in points)
    yz = sum(y * z for _, y, z in points)
    if xx * yy - xy * xy < 0.05 * xx * yy:
        return _slope([(x, z) for x, _, z in points]), None
    determinant = xx * yy - xy * xy
    return (xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant


def _limited(name: str, value: float) -> float:
    least, most = LIMITS[name]
    return max(least, min(most, value))


class _Path:
    """Way (m) and turn (rad) since a beginning, as functions of time (s)."""

    def __init__(self, begin: float) -> None:
        self.begin = begin
        self._times, self._ahead, self._left = [begin], [0.0], [0.0]

    @property
    def length(self) -> float:
        """In s."""
        return self._times[-1] - self.begin

    def add(self, time: float, ahead: float, left: float) -> None:
        """So far it moved from the time before until now."""
        self._times.append(time)
        self._ahead.append(self._ahead[-1] + ahead)
        self._left.append(self._left[-1] + left)

    def between(self, since: float, until: float) -> _Window:
        """The motion between two times."""
        (a, b), (c, d) = self._at(since), self._at(until)
        return c - a, d - b

    def _at(self, time: float) -> _Window:
        after = bisect_right(self._times, time)
        if after == 0:
            return 0.0, 0.0
        if after == len(self._times):
            return self._ahead[-1], self._left[-1]
        since, until = self._times[after - 1], self._times[after]
        part = (time - since) / (until - since)
        return (
            self._ahead[after - 1] + part * (self._ahead[after] - self._ahead[after - 1]),
            self._left[after - 1] + part * (self._left[after] - self._left[after - 1]),
        )


def _evenly_timed(moved: Sequence[Moved]) -> Sequence[Moved]:
    """
    The same at even times, where its times are nearly so: a base measures at a fixed rate, and what a busy computer
    reads late it reads in one go.
    """
    if len(moved) < 2:
        return moved
    begin = moved[0].time
    period = (moved[-1].time - begin) / (len(moved) - 1)
    if any(abs(one.time - begin - number * period) > _LATE for number, one in enumerate(moved)):
        return moved
    return [one._replace(time=begin + number * period) for number, one in enumerate(moved)]


def _real_path(moved: Sequence[Moved]) -> _Path:
    path = _Path(moved[0].time if moved else 0.0)
    for before, after in itertools.pairwise(moved):
        left = math.remainder(after.theta - before.theta, 2 * math.pi)
        heading = before.theta + left / 2
        ahead = (after.x - before.x) * math.cos(heading) + (after.y - before.y) * math.sin(heading)
        path.add(after.time, ahead, left)
    return path


def _predicted_path(told: Sequence[Told], begin: float, end: float, limits: MotorLimits) -> _Path:
    """How the motors of the simulator would move, without a delay of commands."""
    path, motors, place, v, w = _Path(begin), MotorController(limits), 0, 0.0, 0.0
    for step in range(round((end - begin) / _FINE)):
        now = begin + step * _FINE
        while place < len(told) and told[place].time <= now:
            motors.command(told[place].v, told[place].w)
            place += 1
        before = v, w
        v, w = motors.next(_FINE, v, w)
        path.add(now + _FINE, (before[0] + v) / 2 * _FINE, (before[1] + w) / 2 * _FINE)
    return path
