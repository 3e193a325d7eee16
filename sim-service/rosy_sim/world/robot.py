"""
Description of a robot, as far as the simulation depends on it: its body, the limits of its motors, and functions that
turn its surroundings into sensor readings and events.

The world takes one as an argument and knows no robot by name; ``robots/<name>`` holds those that there are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Protocol, runtime_checkable

from .arena import Arena
from .events import Reading

__all__ = [
    "ABORTED",
    "CANCELED",
    "SUCCEEDED",
    "ActionDrive",
    "Body",
    "Device",
    "Driving",
    "Finished",
    "MotorLimits",
    "Robot",
    "ScannerModel",
    "SensorBits",
    "Surroundings",
    "TimedDevice",
]


class SensorBits(NamedTuple):
    """The sensors whose changes are events, one bit for each place."""

    buttons: int = 0
    bumpers: int = 0
    cliffs: int = 0
    wheels: int = 0


@dataclass(frozen=True, slots=True)
class Body:
    """A round robot with two wheels. Lengths in m, mass in kg, inertia about the vertical axis in kg m²."""

    radius: float
    mass: float
    inertia: float
    # Distance between the wheels.
    wheelbase: float
    # A surface nearer than this counts as touched.
    contact_gap: float


_ROUNDING = 1e-9
"""A velocity at the limit of a wheel stays as it is, m/s."""


@dataclass(frozen=True, slots=True)
class MotorLimits:
    """In m/s, rad/s, m/s² and rad/s²."""

    speed: float
    angular_speed: float
    # Highest speed of a wheel.
    wheel_speed: float
    # Distance between the wheels, m.
    wheelbase: float
    acceleration: float
    angular_acceleration: float
    # A velocity command older than this stops the robot, s.
    command_timeout: float

    def within_wheels(self, linear: float, angular: float) -> tuple[float, float]:
        """
        The same curve, slowed down where the outer wheel could not turn as fast.

        ``Rosy.Robots.Guard`` does the same for real robots.
        """
        outer = abs(linear) + abs(angular) * self.wheelbase / 2
        if outer <= self.wheel_speed + _ROUNDING:
            return linear, angular
        slower = self.wheel_speed / outer
        return linear * slower, angular * slower


@dataclass(frozen=True, slots=True)
class ScannerModel:
    """Numbers of a laser scanner whose beams are evenly spread, counter-clockwise from straight ahead."""

    beams: int
    # The shortest and the longest distance that it can measure, m.
    nearest: float
    farthest: float
    # Steps of the simulation in a turn.
    period: int
    # Beams at most this far from straight ahead count for `Ahead`, rad.
    ahead: float
    # How far before the middle between the wheels it is, m.
    forwards: float = 0.0


PointSensor = Callable[[Arena, float, float, float], int]
"""Bits for a robot at x, y (m) and theta (rad) in an arena."""


class Surroundings(Protocol):
    """
    What a device may know of the robot: its true pose in the room (m, rad), its speeds (m/s, rad/s), the room, and its
    commands.
    """

    x: float
    y: float
    theta: float
    v: float
    w: float
    arena: Arena
    outputs: dict[str, tuple[float | int | str, ...]]

    @property
    def has_contacts(self) -> bool:
        """Whether the robot touches anything."""

    @property
    def turn_rate(self) -> float:
        """The turn rate that the robot's own sensors estimate, rad/s."""

    def free_distance(self, direction: float, farthest: float) -> float:
        """From the robot's centre to the first surface in a direction (rad, in the room), m; at most ``farthest``."""

    def free_around(self, x: float, y: float) -> float:
        """How far a robot at a point of the room is from the nearest surface, m; less than 0 when it touches one."""

    def pose_in_room(self, x: float, y: float, theta: float) -> tuple[float, float, float]:
        """A pose in the frame of the odometry as one in the room, as if the odometry were exact."""


class Device(Protocol):
    """A sensor or an actuator with a state of its own, such as a battery."""

    # Channels whose changes are events; those of the others are states.
    events: frozenset[str]

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        """What each of its channels says now. Preferably the same object as last time when nothing has changed."""


@runtime_checkable
class TimedDevice(Device, Protocol):
    """A device with a state that changes by itself."""

    def integrate(self, robot: Surroundings, dt: float) -> None:
        """Let ``dt`` seconds pass."""


SUCCEEDED, CANCELED, ABORTED = 4, 5, 6
"""How a goal ends: numbers of action_msgs, msg/GoalStatus.msg."""


class Driving(NamedTuple):
    """The goal is pursued: m/s ahead, rad/s to the left, and the feedback message."""

    linear: float
    angular: float
    feedback: dict[str, Any]


class Finished(NamedTuple):
    """The goal is no longer pursued: ``SUCCEEDED`` or ``ABORTED``, and the result message."""

    status: int
    result: dict[str, Any]


class ActionDrive(Protocol):
    """Pursues one goal."""

    def step(self, robot: Surroundings) -> Driving | Finished:
        """What the wheels do in the next step of 20 ms."""

    def canceled(self) -> dict[str, Any]:
        """The result message of a goal that was cancelled."""


@dataclass(frozen=True, slots=True)
class Robot:
    """One kind of robot."""

    name: str
    body: Body
    limits: MotorLimits
    # The event of the first packet; None of a robot that does not announce itself.
    online: Reading | None
    # Bits for surfaces touched in these directions (rad, in the room) by a robot at theta (rad).
    bumpers: Callable[[tuple[float, ...], float], int]
    cliffs: PointSensor
    # The wheels without floor under them.
    hanging_wheels: PointSensor
    # The events of a change, in the order in which the robot's driver reports them.
    changes: Callable[[SensorBits, SensorBits], list[Reading]]
    # The state of each of those sensors, by channel.
    states: Callable[[SensorBits], Mapping[str, tuple[int, ...]]]
    # The commands that last, by channel, as they are at the start; of a command with places the state of each.
    outputs: dict[str, tuple[float | int | str, ...]]
    # The command that switches the motors: wheels stand while its value is 0. None when they are always on.
    motor_switch: str | None = None
    # What else is built in: each is made for a room.
    devices: tuple[Callable[[Arena], Device], ...] = ()
    # What pursues a goal, made from its message, by the name of the action.
    actions: Mapping[str, Callable[[Mapping[str, Any]], ActionDrive]] = field(default_factory=dict)
    # Its laser scanner; None when it can have none.
    scanner: ScannerModel | None = None
