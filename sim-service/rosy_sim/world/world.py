"""
The world: an arena with its robot, advanced in steps of 20 ms by whoever owns it.

A step is ``sense()``, then any number of ``command()``, then ``integrate()``. The world never looks at a
clock and draws no random numbers of its own, so two worlds treated alike stay alike to the last bit.
"""

from __future__ import annotations

import math

from .arena import Arena, ArenaError, Pose
from .drive import Drive
from .events import Command, Event, Hand, Led, Lift, Move, Press, Say, Sound, Teleport, Velocity
from .facts import RADIUS, STEP
from .realism import Belief, Latency, Slip
from .room import Room
from .sensors import Bits, bumper_bits, cliff_bits, edges, hanging_wheels

__all__ = ["HandRefused", "Odometry", "World"]

_SUBSTEPS = 4
"""Pieces of a step while boxes are being pushed."""

_NEAR_BOXES = 0.03
"""Distance at which movable boxes join the physics, m: more than a step of travel."""

_AS_TOLD = 1e-6
"""A robot slower than it should be by more than this is held by something, m/s and rad/s."""

_LIFTED = {"left": 2, "right": 1, "both": 3}


class HandRefused(Exception):
    """A hand cannot do that; the text says why."""


Odometry = tuple[float, float, float, float, float]
"""x, y (m), theta (rad) from the start pose, linear (m/s) and angular (rad/s) speed."""


class World:
    """
    One robot in one room.

    Raises:
        ArenaError: the robot cannot stand where the arena starts it.
    """

    def __init__(self, arena: Arena, seed: int = 0) -> None:
        self.arena = arena
        realism = arena.realism
        self._belief = Belief(realism, seed) if realism is not None else None
        self._slip = Slip(realism.slip, seed) if realism is not None and realism.slip else None
        # The speeds for which slipping wheels turn, m/s and rad/s; what they rolled in the last step, m.
        self._wheels = (0.0, 0.0)
        self._rolled = 0.0
        self._latency = Latency(realism.latency) if realism is not None and realism.latency else None
        self.room = Room(arena)
        self._drive = Drive()
        self._holes = any("O" in row for row in arena.tiles)
        # Ground truth, in the room: m, m, rad (not wrapped), m/s, rad/s. Changed by integrate() and hand().
        self.x, self.y, self.theta = arena.start
        self.v = self.w = 0.0
        # The frame of the odometry, as a pose in the room. A teleport moves it along.
        self._origin = arena.start
        # What is pressed and lifted by hands, as bits.
        self._buttons = 0
        self._lifted = 0
        # Bits of the last sense(); the first reference is all zero, as in the driver.
        self._sensed = Bits()
        self._announced = False
        # LED colours, 0 black .. 3 red.
        self.leds = [0, 0]
        self._check_start()
        self._hanging = 0
        self._near = self.room.look(self.x, self.y)
        # How far the robot may still go before the surroundings must be looked at again, m.
        self._budget = self._near.free

    def _check_start(self) -> None:
        x, y, theta = self.arena.start
        tile = self.arena.tile_at(x, y)
        if not (0 <= x < self.arena.width and 0 <= y < self.arena.height):
            raise ArenaError("start", "the robot would start outside the room.")
        if tile == "#" or self.room.look(x, y).free < -0.002:
            raise ArenaError(
                "start", f"the robot would start inside a wall; it needs {2 * RADIUS:.2f} metres of free floor."
            )
        if tile == "O" or hanging_wheels(self.arena, x, y, theta):
            raise ArenaError("start", "the robot would start over a hole; it needs floor under it.")

    @property
    def bits(self) -> Bits:
        """What the robot feels now."""
        cliffs = cliff_bits(self.arena, self.x, self.y, self.theta) if self._holes else 0
        contacts = self._near.contacts
        return Bits(
            self._buttons,
            bumper_bits(contacts, self.theta) if contacts else 0,
            cliffs,
            self._hanging | self._lifted,
        )

    def sense(self) -> list[Event]:
        """What changed since the last time, as the base reports it in one packet."""
        now = self.bits
        found = edges(self._sensed, now)
        self._sensed = now
        if not self._announced:
            self._announced = True
            return [Event("robot_state", 0, 1), *found]
        return found

    def odometry(self) -> Odometry:
        """Where the robot believes it is, in the frame of the place it started from."""
        if self._belief is not None:
            return (*self._belief.pose, *self._belief.speeds)
        return self._truth()

    def _truth(self) -> Odometry:
        ox, oy, otheta = self._origin
        dx, dy = self.x - ox, self.y - oy
        c, s = math.cos(otheta), math.sin(otheta)
        return c * dx + s * dy, c * dy - s * dx, self.theta - otheta, self.v, self.w

    def ghost(self) -> tuple[float, float, float] | None:
        """Where the robot believes it is, as a pose in the room; ``None`` when it is right."""
        if self._belief is None:
            return None
        ox, oy, otheta = self._origin
        x, y, theta = self._belief.pose
        c, s = math.cos(otheta), math.sin(otheta)
        return ox + c * x - s * y, oy + s * x + c * y, otheta + theta

    def command(self, command: Command) -> None:
        """Obey a command from the next integrate() on, or later when the world is slow."""
        if self._latency is not None and isinstance(command, Velocity):
            self._latency.send(command)
        else:
            self._obey(command)

    def _obey(self, command: Command) -> None:
        match command:
            case Velocity(linear, angular):
                self._drive.command(linear, angular)
            case Led(led, colour):
                self.leds[led - 1] = colour
            case Sound() | Say():
                pass

    def hand(self, hand: Hand) -> None:
        """
        Let a hand press, lift or move the robot, or push a movable thing.

        Raises:
            HandRefused: there is no room for the robot there, or no such thing.
        """
        match hand:
            case Press(button, down):
                bit = 1 << button
                self._buttons = self._buttons | bit if down else self._buttons & ~bit
            case Lift(side, up):
                wheels = _LIFTED[side]
                self._lifted = self._lifted | wheels if up else self._lifted & ~wheels
            case Teleport(pose):
                self._teleport(pose)
            case Move(thing, pose):
                if thing >= len(self.room.movables):
                    raise HandRefused("There is no such thing to push in this room.")
                self.room.carry(thing, *pose, robot=(self.x, self.y))
                self._look()

    def _teleport(self, pose: Pose) -> None:
        x, y, theta = pose
        if not (0 <= x <= self.arena.width and 0 <= y <= self.arena.height):
            raise HandRefused("That place is outside the room.")
        place = self.room.place(x, y)
        if place is None or self.arena.tile_at(*place) == "#":
            raise HandRefused("There is no room for the robot there.")
        px, py, ptheta, _, _ = self._truth()
        otheta = theta - ptheta
        c, s = math.cos(otheta), math.sin(otheta)
        self.x, self.y = place
        self.theta = theta
        self._origin = Pose(self.x - (c * px - s * py), self.y - (s * px + c * py), otheta)
        self.v = self.w = 0.0
        self._wheels = (0.0, 0.0)
        self._look()
        self._feel_floor()

    def integrate(self, dt: float = STEP) -> None:
        """Let ``dt`` seconds pass. Long times are cut into steps."""
        for _ in range(max(1, math.ceil(dt / STEP - 1e-9))):
            part = min(dt, STEP)
            dt -= part
            if self._latency is not None:
                for command in self._latency.arrive(part):
                    self._obey(command)
            if self._belief is None:
                self._integrate(part)
            else:
                theta = self.theta
                self._roll_wheels(part)
                self._belief.moved(self._rolled, self.theta - theta, self._wheels[0], self.w, part)

    def _roll_wheels(self, dt: float) -> None:
        """A step in which what the wheels do and what the robot does are two things."""
        x, y, theta = self.x, self.y, self.theta
        before = self._wheels
        wheels = self._drive.next(dt, *before)
        v, w = self._slip.on_floor(*wheels, dt) if self._slip is not None else wheels
        self._integrate_at(v, w, dt)
        if abs(self.v - v) < _AS_TOLD and abs(self.w - w) < _AS_TOLD:
            self._wheels = wheels
            self._rolled = (before[0] + wheels[0]) / 2 * dt
            return
        # Something holds the robot, and its wheels with it.
        self._wheels = (self.v, self.w)
        heading = (theta + self.theta) / 2
        self._rolled = (self.x - x) * math.cos(heading) + (self.y - y) * math.sin(heading)

    def _integrate(self, dt: float) -> None:
        v, w = self._drive.next(dt, self.v, self.w)
        self._integrate_at(v, w, dt)

    def _integrate_at(self, v: float, w: float, dt: float) -> None:
        """Move for ``dt`` s towards these speeds, as far as the room lets the robot."""
        if self._hanging or self._lifted:
            self.v = self.w = 0.0
            if self.room.awake:
                self.room.push(self.x, self.y, self.theta, 0.0, 0.0, dt)
            return
        boxes = self.room.awake or (self.room.movables and self._near_boxes())
        if boxes:
            self._push(dt, v, w)
        elif v or w or self.v or self.w:
            self._roll(dt, v, w)
        else:
            return
        if self._holes:
            self._feel_floor()

    def _near_boxes(self) -> bool:
        return self._near.free_of_boxes - (self._near.free - self._budget) < _NEAR_BOXES

    def _roll(self, dt: float, v: float, w: float) -> None:
        """Follow the arc of the mean speeds, then step back out of whatever was entered."""
        ahead, turn = (v + self.v) / 2 * dt, (w + self.w) / 2 * dt
        theta = self.theta + turn
        if abs(turn) < 1e-9:
            dx, dy = ahead * math.cos(self.theta), ahead * math.sin(self.theta)
        else:
            radius = ahead / turn
            dx = radius * (math.sin(theta) - math.sin(self.theta))
            dy = radius * (math.cos(self.theta) - math.cos(theta))
        self._budget -= abs(ahead)
        if self._budget > 0:
            self.x += dx
            self.y += dy
        elif ahead:
            v = self._press_on(dx, dy, (self.theta + theta) / 2, dt, v)
        self.theta = theta
        self.v, self.w = v, w

    def _press_on(self, dx: float, dy: float, heading: float, dt: float, v: float) -> float:
        """Move where walls may be; returns the speed ahead that is left."""
        place = self.room.place(self.x + dx, self.y + dy)
        x, y = place if place is not None else (self.x, self.y)
        pushed = math.hypot(x - self.x - dx, y - self.y - dy) > 1e-9
        if pushed:
            real = ((x - self.x) * math.cos(heading) + (y - self.y) * math.sin(heading)) / dt
            v = max(-abs(v), min(abs(v), real))
        self.x, self.y = x, y
        self._look()
        return v

    def _push(self, dt: float, v: float, w: float) -> None:
        """Small steps among movable boxes: the solver shares the momentum, walls have the last word."""
        v0, w0 = self.v, self.w
        left = 1.0
        for i in range(1, _SUBSTEPS + 1):
            part = dt / _SUBSTEPS
            wanted = (v0 + (v - v0) * i / _SUBSTEPS) * left
            turning = w0 + (w - w0) * i / _SUBSTEPS
            x, y, real = self.room.push(self.x, self.y, self.theta, wanted, turning, part)
            place = self.room.place(x, y)
            if place is None:
                place = (self.x, self.y)
            c, s = math.cos(self.theta + turning * part / 2), math.sin(self.theta + turning * part / 2)
            moved = ((place[0] - self.x) * c + (place[1] - self.y) * s) / part
            if math.hypot(place[0] - x, place[1] - y) > 1e-9:
                real = min(abs(real), abs(moved)) * math.copysign(1.0, moved)
            real = max(-abs(wanted), min(abs(wanted), real))
            if wanted:
                left *= max(0.0, real / wanted)
            self.x, self.y = place
            self.theta += turning * part
            self.v, self.w = real, turning
        self._look()

    def _look(self) -> None:
        self._near = self.room.look(self.x, self.y)
        self._budget = self._near.free

    def _feel_floor(self) -> None:
        """A robot with a wheel over a hole has tipped: it stays until a hand takes it away."""
        self._hanging = hanging_wheels(self.arena, self.x, self.y, self.theta) if self._holes else 0
        if self._hanging:
            self.v = self.w = 0.0
