"""
World: an arena with its robot, advanced in steps of 20 ms by its owner.

A step is ``sense()``, then any number of ``command()``, then ``integrate()``. The world reads no
clock, and all its random numbers come from the seed, so the same calls give the same floats.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from itertools import zip_longest

from ..sentences.sentence import SentenceError, tr
from .action_goals import ActionGoals
from .arena import Arena, ArenaError, Pose
from .events import (
    Command,
    GiveGoal,
    Lift,
    Move,
    Press,
    Reading,
    TakeBackGoal,
    Teleport,
    UserAction,
    velocity,
)
from .motor_controller import MotorController
from .obstacles import Obstacles
from .range_scanner import AHEAD, SCAN, RangeScanner
from .realism import CommandLatency, GyroOdometry, Realism, WheelSlip
from .robot import Robot, SensorBits, TimedDevice
from .time_step import STEP

__all__ = ["SUBSTEPS", "ActionRefused", "Odometry", "Push", "World", "held_after"]

SUBSTEPS = 4
"""Pieces of a step while boxes are being pushed."""

_NEAR_BOXES = 0.03
"""Distance at which movable boxes join the physics, m: more than a step of travel."""

_SPEED_TOLERANCE = 1e-6
"""A robot slower than its wheels by more than this is blocked, m/s and rad/s."""

_LIFTED = {"left": 2, "right": 1, "both": 3}


class ActionRefused(SentenceError):
    """An action is not possible; the text says why."""


Odometry = tuple[float, float, float, float, float]
"""x, y (m), theta (rad) from the start pose, linear (m/s) and angular (rad/s) speed."""


Values = tuple[float | int | str, ...]


def _origin(x: float, y: float, theta: float) -> tuple[float, float, float, float, float]:
    return x, y, theta, math.cos(theta), math.sin(theta)


def held_after(before: Values, values: Values) -> Values:
    """What an output holds after a command; one to one of several places says which."""
    return values if len(values) == len(before) else _replaced(before, int(values[0]), values[1])


def _replaced(values: Values, place: int, value: float | str) -> Values:
    return (*values[:place], value, *values[place + 1 :])


class World:
    """
    One robot in one room.

    Args:
        arena: the room.
        robot: its robot.
        seed: of all random numbers.
        obstacles: those of the arena, where they were built before.

    Raises:
        ArenaError: the robot cannot stand where the arena starts it.
    """

    def __init__(self, arena: Arena, robot: Robot, seed: int = 0, obstacles: Obstacles | None = None) -> None:
        self.arena = arena
        self.robot = robot
        realism = arena.realism
        self._odometry_model = GyroOdometry(realism, seed) if realism is not None else None
        self._slip: WheelSlip | None = None
        if realism is not None and realism.slip:
            self._slip = WheelSlip(realism.slip, seed, robot.body.wheelbase, robot.limits.angular_speed)
        # The speeds that the wheels of a robot which is less than ideal are told, and for which they turn, m/s and
        # rad/s; what they rolled in the last step, m.
        self._told_wheels = (0.0, 0.0)
        self._wheels = (0.0, 0.0)
        self._rolled = 0.0
        # The same in the step in progress, if nothing blocks the robot, and its pose and wheels when that began.
        self._next_told = self._next_wheels = self._last_wheels = (0.0, 0.0)
        self._left_pose = (0.0, 0.0, 0.0)
        # The speeds of the robot in the step in progress, if nothing blocks it, m/s and rad/s.
        self.wanted = (0.0, 0.0)
        # The worlds of the other robots in the room; only a ``SharedWorld`` has any.
        self.others: list[World] = []
        self._realism = Realism() if realism is None else realism
        self._latency = CommandLatency(realism.latency) if realism is not None and realism.latency else None
        if obstacles is None:
            obstacles = Obstacles(robot.body)
            for _ in obstacles.add(arena):
                pass
        self.obstacles = obstacles
        self._motors = MotorController(robot.limits)
        self._has_holes = any("O" in row for row in arena.tiles)
        # Ground truth, in the room: m, m, rad (not wrapped), m/s, rad/s. Changed by integrate() and apply().
        self.x, self.y, self.theta = arena.start
        self.v = self.w = 0.0
        # The frame of the odometry: a pose in the room, cosine and sine of its angle. A teleport moves it along.
        self._origin = _origin(*arena.start)
        # How often a hand has put the robot in another place.
        self.placements = 0
        # Buttons that are pressed and wheels that are lifted, as bits.
        self._buttons = 0
        self._lifted = 0
        # The buttons as they are left once the robot has sensed them: it senses each press, however short.
        self._next_buttons = 0
        # Bits of the last sense(); the first reference is all zero, as in the driver.
        self._sensed = SensorBits()
        self._announced = False
        # The last command on each channel that lasts; another object after each command.
        self.outputs = dict(robot.outputs)
        # The goals that clients give to the robot's own programs.
        self.actions = ActionGoals(robot.actions)
        self._devices = [device(arena) for device in robot.devices]
        self._timed_devices = [device for device in self._devices if isinstance(device, TimedDevice)]
        scanner = robot.scanner if arena.scanner else None
        self._scanner = RangeScanner(scanner, obstacles) if scanner is not None else None
        # Steps since the start.
        self._steps = 0
        # What each device says now; None when that may have changed. And what each said when the robot was sensed last.
        self._device_values: list[dict[str, Values]] | None = None
        self._sensed_values: list[dict[str, Values]] = []
        self._device_events = frozenset[str]().union(*(device.events for device in self._devices))
        # The same by channel; nothing before the first sense().
        self._told: dict[str, Values] = {}
        self._check_start()
        self._hanging = 0
        # Whether obstacles or the things that it pushes slowed the robot in the last step.
        self.is_blocked = False
        # The clearance, and where it was computed.
        self._clearance = self.obstacles.clearance_at(self.x, self.y)
        self._clearance_position = (self.x, self.y)
        # How far the robot may still go before the clearance must be computed again, m.
        self._clear_distance = self._clearance.free

    def _check_start(self) -> None:
        x, y, theta = self.arena.start
        tile = self.arena.tile_at(x, y)
        if not (0 <= x < self.arena.width and 0 <= y < self.arena.height):
            raise ArenaError("start", tr("the robot would start outside the room."))
        if tile == "#" or self.obstacles.clearance_at(x, y).free < -0.002:
            raise ArenaError(
                "start",
                tr(
                    "the robot would start inside a wall; it needs {width} metres of free floor.",
                    width=round(2 * self.robot.body.radius, 2),
                ),
            )
        if tile == "O" or self.robot.hanging_wheels(self.arena, x, y, theta):
            raise ArenaError("start", tr("the robot would start over a hole; it needs floor under it."))

    @property
    def sensors(self) -> SensorBits:
        """What the sensors report now."""
        robot = self.robot
        cliffs = robot.cliffs(self.arena, self.x, self.y, self.theta) if self._has_holes else 0
        contacts = self._clearance.contacts
        return SensorBits(
            self._buttons,
            robot.bumpers(contacts, self.theta) if contacts else 0,
            cliffs,
            self._hanging | self._lifted,
        )

    @property
    def has_contacts(self) -> bool:
        """Whether the robot touches anything, with or without a bumper."""
        return bool(self._clearance.contacts)

    def sense(self) -> list[Reading]:
        """The changes since the last call, as the robot reports them in one packet: events, then states."""
        found: list[Reading] = []
        wheels = self._hanging | self._lifted
        # The bits without contacts and holes are compared as a plain tuple, which is faster.
        if self._has_holes or self._clearance.contacts or (self._buttons, 0, 0, wheels) != self._sensed:
            now = self.sensors
            found = self.robot.changes(self._sensed, now)
            self._sensed = now
            self._buttons = self._next_buttons
        first = not self._announced
        self._announced = True
        if self._scanner is not None and self._scanner.heard:
            found = found + self._scanner.readings(self._steps, self.x, self.y, self.theta)
        if self._devices:
            found += self._device_readings(first)
        online = self.robot.online
        return [online, *found] if first and online is not None else found

    def missing_parts(self, uses: Collection[str]) -> list[str]:
        """Those of a program's types for which the robot of this room carries no sensor, in their order."""
        return [] if self._scanner is not None else [used for used in uses if used in (AHEAD, SCAN)]

    def listen(self, listener: str, channels: Collection[str]) -> None:
        """A listener wants these of the channels that are measured on demand from now on, and no others."""
        if self._scanner is not None:
            self._scanner.listen(listener, channels)

    def _device_readings(self, first: bool) -> list[Reading]:
        events: list[Reading] = []
        states: list[Reading] = []
        now = self._read_devices()
        for said, said_before in zip_longest(now, self._sensed_values):
            if said is said_before:
                continue
            for channel, values in said.items():
                if self._told.get(channel) == values:
                    continue
                self._told[channel] = values
                if channel not in self._device_events:
                    states.append(Reading(channel, values))
                elif not first:
                    events.append(Reading(channel, values))
        self._sensed_values = now
        return events + states

    def _read_devices(self) -> list[dict[str, Values]]:
        """What each device says, of channels of its own. A step reads them for the program and for the picture."""
        if self._device_values is None:
            self._device_values = [device.values(self) for device in self._devices]
        return self._device_values

    def channels(self) -> dict[str, Values]:
        """What every channel says now, for a picture of the robot; of events the state of each sensor."""
        shown: dict[str, Values] = {}
        for part in self.channel_parts():
            shown.update(part)
        return shown

    def channel_parts(self) -> list[Mapping[str, Values]]:
        """The same in parts. None is changed later: a part that is the same object as before says the same."""
        parts: list[Mapping[str, Values]] = [
            {"Velocity": (self.v, self.w)},
            self.robot.states(self.sensors),
            self.outputs,
            *self._read_devices(),
        ]
        if self._scanner is not None:
            parts.append(dict(self._scanner.latest))
        return parts

    def odometry(self) -> Odometry:
        """The robot's own estimate of its pose, in the frame of its start pose."""
        if self._odometry_model is not None:
            return (*self._odometry_model.pose, *self._odometry_model.speeds)
        return self._truth()

    @property
    def turn_rate(self) -> float:
        """The robot's own estimate of how fast it turns, rad/s."""
        return self.w if self._odometry_model is None else self._odometry_model.speeds[1]

    def free_distance(self, direction: float, farthest: float) -> float:
        """From the robot's centre to the first surface in a direction (rad, in the room), m; at most ``farthest``."""
        return self.obstacles.distance(self.x, self.y, direction, farthest)

    def free_around(self, x: float, y: float) -> float:
        """How far a robot at a point of the room is from the nearest surface, m; less than 0 when it touches one."""
        return self.obstacles.clearance_at(x, y).free

    def pose_in_room(self, x: float, y: float, theta: float) -> tuple[float, float, float]:
        """A pose in the frame of the odometry as one in the room, as if the odometry were exact."""
        ox, oy, otheta, c, s = self._origin
        return ox + c * x - s * y, oy + s * x + c * y, otheta + theta

    def _truth(self) -> Odometry:
        ox, oy, otheta, c, s = self._origin
        dx, dy = self.x - ox, self.y - oy
        return c * dx + s * dy, c * dy - s * dx, self.theta - otheta, self.v, self.w

    def ghost(self) -> tuple[float, float, float] | None:
        """The odometry as a pose in the room; ``None`` when it is exact."""
        if self._odometry_model is None:
            return None
        return self.pose_in_room(*self._odometry_model.pose)

    def reset_odometry(self) -> None:
        """The odometry begins anew here, as after a command to reset it."""
        self._origin = _origin(self.x, self.y, self.theta)
        if self._odometry_model is not None:
            self._odometry_model.pose = (0.0, 0.0, 0.0)

    def command(self, command: Command) -> None:
        """Obey a command from the next integrate() on, or later when the world is slow."""
        self._device_values = None
        if self._latency is not None and command.channel == "Velocity":
            self._latency.send(command)
        else:
            self._obey(command)

    def drive(self, linear: float, angular: float) -> None:
        """Obey a velocity command (m/s, rad/s), as ``command`` does."""
        if self._latency is not None:
            self._latency.send(velocity(linear, angular))
        elif self._have_power():
            self._motors.command(linear, angular)

    def _obey(self, command: Command) -> None:
        channel, values = command
        if channel == "Velocity":
            if self._have_power():
                self._motors.command(float(values[0]), float(values[1]))
        elif channel in self.outputs:
            # A new object, see ``channel_parts``.
            self.outputs = {**self.outputs, channel: held_after(self.outputs[channel], values)}
            if not self._have_power():
                self._motors.command(0.0, 0.0)

    def _have_power(self) -> bool:
        switch = self.robot.motor_switch
        return switch is None or self.outputs[switch] != (0,)

    def apply(self, action: UserAction) -> None:
        """
        Press a button, lift or move the robot, or push a movable thing.

        Raises:
            ActionRefused: there is no room for the robot there, or no such thing.
        """
        self._device_values = None
        match action:
            case Press(button, down):
                bit = 1 << button
                is_sensed = (self._buttons ^ self._sensed.buttons) & bit == 0
                self._next_buttons = self._next_buttons | bit if down else self._next_buttons & ~bit
                if is_sensed:
                    self._buttons = self._buttons & ~bit | self._next_buttons & bit
            case Lift(side, up):
                wheels = _LIFTED[side]
                self._lifted = self._lifted | wheels if up else self._lifted & ~wheels
            case Teleport(pose):
                self._teleport(pose)
            case GiveGoal(client, ident, name, goal):
                self.actions.send(client, ident, name, goal)
            case TakeBackGoal(client, ident):
                if self.actions.cancel(client, ident):
                    self.drive(0.0, 0.0)
            case Move(thing, pose):
                if thing >= len(self.obstacles.movables):
                    raise ActionRefused(tr("There is no such thing to push in this room."))
                self.obstacles.drag(thing, *pose, robot=(self.x, self.y))
                self.update_clearance()

    def _teleport(self, pose: Pose) -> None:
        x, y, theta = pose
        if not (0 <= x <= self.arena.width and 0 <= y <= self.arena.height):
            raise ActionRefused(tr("That place is outside the room."))
        free_position = self.obstacles.free_position(x, y)
        if free_position is None or self.arena.tile_at(*free_position) == "#":
            raise ActionRefused(tr("There is no room for the robot there."))
        px, py, ptheta, _, _ = self._truth()
        otheta = theta - ptheta
        c, s = math.cos(otheta), math.sin(otheta)
        self.placements += 1
        self.x, self.y = free_position
        self.theta = theta
        self._origin = _origin(self.x - (c * px - s * py), self.y - (s * px + c * py), otheta)
        self.v = self.w = 0.0
        self._told_wheels = self._wheels = (0.0, 0.0)
        self.update_clearance()
        self._update_floor_contact()

    def integrate(self, dt: float = STEP) -> None:
        """Let ``dt`` seconds pass. Long times are cut into steps."""
        while dt > STEP * (1 + 1e-9):
            dt -= STEP
            self._integrate_step(STEP)
        self._integrate_step(dt)

    def _integrate_step(self, dt: float) -> None:
        """Let a step's time pass, or less."""
        self.begin_step(dt)
        self.move(dt)
        self.end_step(dt)

    def begin_step(self, dt: float) -> None:
        """Decide how fast the robot goes in a step, if nothing blocks it."""
        self._device_values = None
        self._steps += 1
        if self.actions.is_pursuing:
            wanted = self.actions.step(self)
            if wanted is not None:
                self.drive(*wanted)
        if self._latency is not None:
            for command in self._latency.arrive(dt):
                self._obey(command)
        if self._odometry_model is None:
            self.wanted = self._motors.next(dt, self.v, self.w)
        else:
            self._turn_wheels(dt)
        self.is_blocked = False

    def end_step(self, dt: float) -> None:
        """The robot has moved."""
        if self._odometry_model is not None:
            self._roll_wheels(dt)
            turned = self.theta - self._left_pose[2]
            self._odometry_model.moved(self._rolled, turned, self._wheels[0], self.w, dt)
        for device in self._timed_devices:
            device.integrate(self, dt)

    def _turn_wheels(self, dt: float) -> None:
        """The wheels of a robot that is less than ideal may move differently from the robot."""
        self._left_pose = (self.x, self.y, self.theta)
        self._last_wheels = self._wheels
        self._next_told = self._motors.next(dt, *self._told_wheels)
        self._next_wheels = wheels = self._realism.turned(*self._next_told)
        self.wanted = self._slip.on_floor(*wheels, dt) if self._slip is not None else wheels

    def _roll_wheels(self, dt: float) -> None:
        """How far the wheels have rolled in a step."""
        before, wheels = self._last_wheels, self._next_wheels
        v, w = self.wanted
        if abs(self.v - v) < _SPEED_TOLERANCE and abs(self.w - w) < _SPEED_TOLERANCE:
            self._told_wheels, self._wheels = self._next_told, wheels
            self._rolled = (before[0] + wheels[0]) / 2 * dt
            return
        # The robot is blocked, and its wheels with it.
        x, y, theta = self._left_pose
        self._wheels = (self.v, self.w)
        self._told_wheels = self._realism.told(self.v, self.w)
        heading = (theta + self.theta) / 2
        self._rolled = (self.x - x) * math.cos(heading) + (self.y - y) * math.sin(heading)

    @property
    def is_held(self) -> bool:
        """Whether the wheels move nothing, because a hand lifts the robot or it has tipped over a hole."""
        return bool(self._hanging or self._lifted)

    def move(self, dt: float) -> None:
        """Move for ``dt`` s towards the wanted speeds, as far as obstacles allow."""
        v, w = self.wanted
        if self.is_held:
            self.v = self.w = 0.0
            if self.obstacles.awake:
                self.obstacles.begin_push(self.x, self.y, self.theta, 0.0, 0.0, dt)
                self.obstacles.push(dt)
            return
        if self.may_push():
            self._push(dt)
        elif v or w or self.v or self.w:
            self._roll(dt, v, w)
        else:
            return
        self._after_move()

    def _after_move(self) -> None:
        self.is_blocked = abs(self.v - self.wanted[0]) > _SPEED_TOLERANCE
        if self._has_holes:
            self._update_floor_contact()

    def may_push(self) -> bool:
        """Whether movable things slide or are so near that the robot may push them in the next step."""
        return self.obstacles.awake or (bool(self.obstacles.movables) and self._is_near_boxes())

    def _is_near_boxes(self) -> bool:
        return self._clearance.free_of_boxes - (self._clearance.free - self._clear_distance) < _NEAR_BOXES

    def _roll(self, dt: float, v: float, w: float) -> None:
        """Follow the arc of the mean speeds, then move out of any obstacle that was entered."""
        ahead, turn = (v + self.v) / 2 * dt, (w + self.w) / 2 * dt
        theta = self.theta + turn
        if abs(turn) < 1e-9:
            dx, dy = ahead * math.cos(self.theta), ahead * math.sin(self.theta)
        else:
            radius = ahead / turn
            dx = radius * (math.sin(theta) - math.sin(self.theta))
            dy = radius * (math.cos(self.theta) - math.cos(theta))
        self._clear_distance -= abs(ahead)
        if self._clear_distance > 0:
            self.x += dx
            self.y += dy
        elif ahead:
            v = self._move_along_walls(dx, dy, (self.theta + theta) / 2, dt, v)
        self.theta = theta
        self.v, self.w = v, w

    def _move_along_walls(self, dx: float, dy: float, heading: float, dt: float, v: float) -> float:
        """Move near walls; returns the speed ahead that is left."""
        free_position = self.obstacles.free_position(self.x + dx, self.y + dy)
        x, y = free_position if free_position is not None else (self.x, self.y)
        pushed = math.hypot(x - self.x - dx, y - self.y - dy) > 1e-9
        if pushed:
            real = ((x - self.x) * math.cos(heading) + (y - self.y) * math.sin(heading)) / dt
            v = max(-abs(v), min(abs(v), real))
        self.x, self.y = x, y
        self.update_clearance()
        return v

    def _push(self, dt: float) -> None:
        """Small steps among movable boxes: the solver shares the momentum, then walls limit the position."""
        push = Push(self, dt)
        for piece in range(1, SUBSTEPS + 1):
            push.begin(piece)
            self.obstacles.push(push.part)
            push.end()
        self.update_clearance()

    def after_push(self) -> None:
        """The robot has moved in the pieces of a ``Push``, together with others."""
        if not self.is_held:
            self._after_move()

    def update_clearance(self) -> None:
        """Look around the robot, unless nothing can have changed there."""
        position = (self.x, self.y)
        # A robot that a wall blocks stays in its place for many steps.
        if position != self._clearance_position or self.obstacles.movables or self.obstacles.is_shared:
            self._clearance_position = position
            self._clearance = self.obstacles.clearance_at(*position)
        self._clear_distance = self._clearance.free

    def _update_floor_contact(self) -> None:
        """A robot with a wheel over a hole has tipped: it stays until it is moved away."""
        self._hanging = self.robot.hanging_wheels(self.arena, self.x, self.y, self.theta) if self._has_holes else 0
        if self._hanging:
            self.v = self.w = 0.0


class Push:
    """
    A step of a robot among things that can be pushed, in ``SUBSTEPS`` pieces.

    Args:
        dt: of the whole step, s.
    """

    def __init__(self, world: World, dt: float) -> None:
        self._world = world
        self._wanted = (0.0, 0.0) if world.is_held else world.wanted
        self._first = (world.v, world.w)
        # Seconds of a piece.
        self.part = dt / SUBSTEPS
        # How much of the wanted speed the things that are pushed have left so far.
        self._left = 1.0
        # Speeds of the current piece, m/s and rad/s.
        self._ahead = self._turning = 0.0

    def begin(self, piece: int) -> None:
        """The robot moves in this piece, from 1 on."""
        world, part = self._world, piece / SUBSTEPS
        (v0, w0), (v, w) = self._first, self._wanted
        self._ahead = (v0 + (v - v0) * part) * self._left
        self._turning = w0 + (w - w0) * part
        world.obstacles.begin_push(world.x, world.y, world.theta, self._ahead, self._turning, self.part)

    def end(self) -> None:
        """The piece has passed: walls limit where the robot is."""
        world, part, wanted, turning = self._world, self.part, self._ahead, self._turning
        x, y, real = world.obstacles.pushed(world.theta, turning, part)
        free_position = world.obstacles.free_position(x, y)
        if free_position is None:
            free_position = (world.x, world.y)
        c, s = math.cos(world.theta + turning * part / 2), math.sin(world.theta + turning * part / 2)
        moved = ((free_position[0] - world.x) * c + (free_position[1] - world.y) * s) / part
        if math.hypot(free_position[0] - x, free_position[1] - y) > 1e-9:
            real = min(abs(real), abs(moved)) * math.copysign(1.0, moved)
        real = max(-abs(wanted), min(abs(wanted), real))
        if wanted:
            self._left *= max(0.0, real / wanted)
        world.x, world.y = free_position
        world.theta += turning * part
        world.v, world.w = real, turning
