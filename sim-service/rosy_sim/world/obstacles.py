"""
Obstacles of a room, in pymunk: clearance around a point, positions where a robot can stand, and how pushed
boxes move. Distances are exact (Chipmunk's signed distance to a shape), so a robot is moved back onto
the surface of a wall rather than bounced out of it: it never ends inside one, at any speed.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

import pymunk

from ..sentences.sentence import tr
from .arena import WALL_THICKNESS, Arena, Box, Round
from .field_readers import ArenaError
from .robot import Body

__all__ = ["FLOOR_FRICTION", "GRAVITY", "MAX_OVERLAPS", "MAX_WALLS", "Clearance", "Obstacles"]

GRAVITY = 9.81
"""m/s². Presses movable boxes onto the floor; the robot's plane itself has none."""

FLOOR_FRICTION = 0.3
"""Of a movable box on the floor, without unit. Wood on linoleum; our choice."""

_BORDER = 1.0
"""How thick the wall around the room is, m: more than a robot can enter in a step."""

_RANGE = 0.5
"""Range of distance queries from the robot's centre, m."""

_TOUCHING = 1e-6
"""Overlap that counts as touching, m."""

_MAX_OVERLAP = 5e-4
"""Overlap with a wall that may remain when several walls push, m."""

_BOX_OVERLAP = 1e-3
"""Overlap with a movable box that is left to the solver, m."""

_MAX_CORRECTIONS = 24
"""Corrections of a position before the robot stays where it was."""

_AT_REST = 1e-4
"""A box slower than this is at rest, m/s and rad/s."""

_DRAG_STEP, _DRAG_TURN = 0.01, 0.05
"""Steps in which a thing is dragged, m and rad; each is checked for collisions."""

_DRAG_GAP = 5e-4
"""Overlap with which a dragged thing counts as only touching, m."""

_MAX_DRAG = 2.0
"""Longest way of one drag message, m: a longer one is a slip of the mouse."""

MAX_OVERLAPS = 200
"""Pairs of a movable thing and another thing that may overlap in a room. The solver works on each pair in each step."""

MAX_WALLS = 8_000
"""
Walls that are made of wall tiles. A maze that fills the largest grid has 6,000; the 20,000 of a checkerboard take 0.3 s
to build and 26 MB.
"""

_MAX_DRAG_CONTACTS = 1000
"""
Contacts that one drag may look at: the longest drag past four things. A thing in a pile moves less far. A contact takes
some 10 µs.
"""

_STATIC, _MOVABLE, _ROBOT = 1, 2, 4


class Clearance(NamedTuple):
    """Clearance around a position: the distance free of obstacles, and the surfaces touched."""

    # Distance to the nearest surface beyond the contact gap, m; less than 0 when touching.
    free: float
    # Distance to the nearest movable surface, m.
    free_of_boxes: float
    # Directions (rad, in the room) from the centre towards each touched surface.
    contacts: tuple[float, ...]


class Obstacles:
    """
    Walls, blocks and boxes of an arena; none before they are added.

    Args:
        body: of the robot.
        room: those of a robot that is in this room already. Then the robots are obstacles to each other, and the things
            of the room are the same.
    """

    def __init__(self, body: Body, room: Obstacles | None = None) -> None:
        self._radius = body.radius
        self._contact_gap = body.contact_gap
        # Owns the space; None of the first robot.
        self._room = room
        self._space: pymunk.Space = _new_space() if room is None else room._space
        # The bodies of movable things, in the arena's order: boxes, then rounds.
        self.movables: list[pymunk.Body] = [] if room is None else room.movables
        self._movable_shapes: set[pymunk.Shape | None] = set() if room is None else room._movable_shapes
        self._friction_radii: list[float] = [] if room is None else room._friction_radii
        # Whether other robots are in the room, which move by themselves.
        self.is_shared = False
        # Whether a movable thing still slides; set by push().
        self.awake = False
        self._all_shapes = pymunk.ShapeFilter(mask=_STATIC | _MOVABLE)
        # Among things that do not move: the last question for a free position, and its answer.
        self._asked_position: tuple[float, float] | None = None
        self._found_position: tuple[float, float] | None = None
        # Contacts that the current drag may still look at.
        self._contacts_left = 0
        self._robot = pymunk.Body(body.mass, body.inertia)
        self._robot_shape = pymunk.Circle(self._robot, body.radius)
        self._robot_shape.filter = pymunk.ShapeFilter(categories=_ROBOT, mask=_MOVABLE)
        self._robot_shape.elasticity = 0.0
        self._robot_shape.friction = 0.1
        if room is not None:
            self._space.add(self._robot, self._robot_shape)

    def share(self, number: int) -> None:
        """Other robots are in the room from now on; this one has a number of its own among them, from 1 on."""
        self.is_shared = True
        # Shapes and questions of one group ignore each other: a robot is no obstacle to itself.
        self._robot_shape.filter = pymunk.ShapeFilter(number, _ROBOT, _MOVABLE)
        self._all_shapes = pymunk.ShapeFilter(number, mask=_STATIC | _MOVABLE | _ROBOT)

    def place(self, x: float, y: float) -> None:
        """Where the robot is, for the other robots in the room."""
        self._robot.position = (x, y)
        self._robot.velocity = (0.0, 0.0)
        self._space.reindex_shapes_for_body(self._robot)

    def add(self, arena: Arena) -> Iterator[None]:
        """Add what is in an arena, and the robot, in pieces of some 25 µs; once, and to the end."""
        space = self._space
        rectangles = list(islice(_solid_rectangles(arena), MAX_WALLS + 1))
        if len(rectangles) > MAX_WALLS:
            raise ArenaError("tiles", tr("the wall tiles make more than {most} walls; join some.", most=MAX_WALLS))
        yield
        for x, y, w, h in rectangles:
            self._fixed(pymunk.Poly(space.static_body, [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]))
            yield
        for wall in arena.walls:
            self._fixed(pymunk.Segment(space.static_body, (wall.x0, wall.y0), (wall.x1, wall.y1), WALL_THICKNESS / 2))
            yield
        things: tuple[Box | Round, ...] = (*arena.boxes, *arena.rounds)
        overlaps = 0
        for thing in things:
            self._thing(thing)
            if thing.movable:
                # Counted at once, because a pile takes long to build.
                overlaps += self._count_overlaps(self.movables[-1])
                _refuse_more_than(MAX_OVERLAPS, overlaps)
            yield
        # With what was added after them; those of two movable things are counted twice.
        overlaps = 0
        for moving in self.movables:
            overlaps += self._count_overlaps(moving)
            _refuse_more_than(2 * MAX_OVERLAPS, overlaps)
            yield
        space.add(self._robot, self._robot_shape)

    def __del__(self) -> None:
        # Each shape and body of pymunk refers to itself by its handle, and would wait for a full garbage collection.
        if self._room is not None:
            return
        for shape in (*self._space.shapes, self._robot_shape):
            shape._h = None
        for body in (*self._space.bodies, self._space.static_body, self._robot):
            body._data_handle = None

    def _count_overlaps(self, body: pymunk.Body) -> int:
        return sum(len(self._space.shape_query(shape)) for shape in body.shapes)

    def _fixed(self, shape: pymunk.Shape) -> None:
        shape.filter = pymunk.ShapeFilter(categories=_STATIC)
        shape.elasticity = 0.0
        shape.friction = 0.2
        self._space.add(shape)

    def _thing(self, thing: Box | Round) -> None:
        body = self._space.static_body
        if thing.movable:
            if isinstance(thing, Box):
                moment = pymunk.moment_for_box(thing.mass, (thing.w, thing.h))
                radius = math.hypot(thing.w, thing.h) / 3
            else:
                moment = pymunk.moment_for_circle(thing.mass, 0, thing.r)
                radius = thing.r * 2 / 3
            body = pymunk.Body(thing.mass, moment)
            body.position = (thing.x, thing.y)
            body.angle = thing.theta if isinstance(thing, Box) else 0.0
        shape: pymunk.Shape
        if isinstance(thing, Box):
            c, s = math.cos(thing.theta), math.sin(thing.theta)
            half = [(i * thing.w / 2, j * thing.h / 2) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            if thing.movable:
                shape = pymunk.Poly(body, half)
            else:
                shape = pymunk.Poly(body, [(thing.x + c * a - s * b, thing.y + s * a + c * b) for a, b in half])
        else:
            shape = pymunk.Circle(body, thing.r, (0, 0) if thing.movable else (thing.x, thing.y))
        if not thing.movable:
            self._fixed(shape)
            return
        shape.filter = pymunk.ShapeFilter(categories=_MOVABLE)
        shape.elasticity = 0.0
        shape.friction = 0.2
        self._space.add(body, shape)
        self.movables.append(body)
        self._movable_shapes.add(shape)
        self._friction_radii.append(radius)

    def poses(self) -> list[tuple[float, float, float]]:
        """Where the movable things are now: x, y, theta of each, in the arena's order."""
        return [(b.position.x, b.position.y, b.angle) for b in self.movables]

    def drag(self, thing: int, x: float, y: float, theta: float, robot: tuple[float, float]) -> None:
        """
        Drag a movable thing towards a pose, as far as neither walls, nor other things, nor the robot block it. In a
        pile, of which many things would have to be looked at, it moves a part of the way.
        """
        body = self.movables[thing]
        self._robot.position = robot
        self._space.reindex_shapes_for_body(self._robot)
        x0, y0 = body.position
        turn = math.remainder(theta - body.angle, math.tau)
        distance = min(math.hypot(x - x0, y - y0), _MAX_DRAG)
        pieces = max(1, math.ceil(distance / _DRAG_STEP), math.ceil(abs(turn) / _DRAG_TURN))
        far = distance / math.hypot(x - x0, y - y0) if distance else 0.0
        dx, dy, dtheta = (x - x0) * far / pieces, (y - y0) * far / pieces, turn / pieces
        self._contacts_left = _MAX_DRAG_CONTACTS
        for _ in range(pieces):
            if self._contacts_left < 0:
                break
            # A thing that is blocked slides along the obstacle, and ends where it touches it.
            if not any(self._try_move(body, *step) for step in ((dx, dy, dtheta), (dx, 0.0, 0.0), (0.0, dy, 0.0))):
                for fraction in (0.5, 0.25, 0.125, 0.0625, 0.03125):
                    self._try_move(body, dx * fraction, dy * fraction, dtheta * fraction)
                break
        body.velocity = (0.0, 0.0)
        body.angular_velocity = 0.0

    def depth(self, thing: int) -> float:
        """How deep a movable thing is inside walls, other things or the robot, m."""
        return self._overlap(self.movables[thing])

    def _try_move(self, body: pymunk.Body, dx: float, dy: float, turn: float) -> bool:
        """Move a thing a little, unless that increases its overlap."""
        if not (dx or dy or turn):
            return False
        before, angle = body.position, body.angle
        deep = self._overlap(body)
        body.position = (before.x + dx, before.y + dy)
        body.angle = angle + turn
        now = self._overlap(body)
        if now <= max(deep, _DRAG_GAP):
            return True
        body.position, body.angle = before, angle
        self._space.reindex_shapes_for_body(body)
        return False

    def _overlap(self, body: pymunk.Body) -> float:
        """How deep a thing is inside others, m."""
        self._space.reindex_shapes_for_body(body)
        deepest = 0.0
        for shape in body.shapes:
            for found in self._space.shape_query(shape):
                self._contacts_left -= 1
                # Chipmunk reports only what overlaps, and turns the sign when it has swapped the two shapes.
                for contact in found.contact_point_set.points:
                    deepest = max(deepest, abs(contact.distance))
        return deepest

    def clearance_at(self, x: float, y: float) -> Clearance:
        """The clearance around a robot at a point."""
        radius, contact_gap = self._radius, self._contact_gap
        free = free_of_boxes = _RANGE - radius
        contacts: list[float] = []
        for shape, _point, distance, gradient in self._space.point_query((x, y), _RANGE, self._all_shapes):
            gap = distance - radius
            free = min(free, gap - contact_gap)
            if shape in self._movable_shapes:
                free_of_boxes = min(free_of_boxes, gap)
            if gap < contact_gap:
                contacts.append(math.atan2(-gradient.y, -gradient.x))
        return Clearance(free, free_of_boxes, tuple(contacts))

    def distance(self, x: float, y: float, direction: float, farthest: float) -> float:
        """How far it is from a point to the first surface in a direction (rad, in the room); at most ``farthest`` m."""
        end = (x + farthest * math.cos(direction), y + farthest * math.sin(direction))
        hit = self._space.segment_query_first((x, y), end, 0.0, self._all_shapes)
        return farthest if hit is None else farthest * hit.alpha

    def free_position(self, x: float, y: float) -> tuple[float, float] | None:
        """The position nearest to a point where the robot touches but does not enter anything, if one is near."""
        if self._movable_shapes or self.is_shared:
            return self._searched_position(x, y)
        # A robot that pushes against a wall asks the same in each step.
        if (x, y) != self._asked_position:
            self._asked_position = (x, y)
            self._found_position = self._searched_position(x, y)
        return self._found_position

    def _searched_position(self, x: float, y: float) -> tuple[float, float] | None:
        for _ in range(_MAX_CORRECTIONS):
            depth, nx, ny = self._deepest(x, y)
            if depth <= _TOUCHING:
                return x, y
            x += nx * depth
            y += ny * depth
        return (x, y) if self._deepest(x, y)[0] <= _MAX_OVERLAP else None

    def _deepest(self, x: float, y: float) -> tuple[float, float, float]:
        if not self._movable_shapes:
            # The same, without a call of Python for each shape.
            nearest = self._space.point_query_nearest((x, y), self._radius, self._all_shapes)
            if nearest is None:
                return 0.0, 0.0, 0.0
            return self._radius - nearest.distance, nearest.gradient.x, nearest.gradient.y
        deepest, nx, ny = 0.0, 0.0, 0.0
        for shape, _point, distance, gradient in self._space.point_query((x, y), self._radius, self._all_shapes):
            depth = self._radius - distance
            if shape in self._movable_shapes:
                depth -= _BOX_OVERLAP
            if depth > deepest:
                deepest, nx, ny = depth, gradient.x, gradient.y
        return deepest, nx, ny

    def begin_push(self, x: float, y: float, theta: float, v: float, w: float, dt: float) -> None:
        """The robot is at a pose and moves with these speeds for ``dt`` seconds, during the next ``push``."""
        robot = self._robot
        c, s = math.cos(theta + w * dt / 2), math.sin(theta + w * dt / 2)
        robot.position = (x, y)
        robot.angle = theta
        robot.velocity = (v * c, v * s)
        robot.angular_velocity = w

    def push(self, dt: float) -> None:
        """Move all robots and movable things of the room for ``dt`` seconds."""
        self._space.step(dt)
        self.awake = False
        for body, radius in zip(self.movables, self._friction_radii, strict=True):
            self._apply_friction(body, radius, dt)

    def pushed(self, theta: float, w: float, dt: float) -> tuple[float, float, float]:
        """The robot's new x and y after a push of ``dt`` s, and the speed ahead that the things it pushes leave it."""
        c, s = math.cos(theta + w * dt / 2), math.sin(theta + w * dt / 2)
        position, velocity = self._robot.position, self._robot.velocity
        return position.x, position.y, velocity.x * c + velocity.y * s

    def _apply_friction(self, body: pymunk.Body, radius: float, dt: float) -> None:
        """Floor friction: a box loses speed, and turning, at the rate its weight allows."""
        loss = FLOOR_FRICTION * GRAVITY * dt
        speed, rim = body.velocity.length, abs(body.angular_velocity) * radius
        # Compared before it is divided: a speed may be so small that its inverse is none.
        if speed > loss:
            body.velocity = body.velocity * (1 - loss / speed)
        else:
            body.velocity = (0.0, 0.0)
        if rim > loss:
            body.angular_velocity *= 1 - loss / rim
        else:
            body.angular_velocity = 0.0
        if speed - loss > _AT_REST or rim - loss > _AT_REST:
            self.awake = True


def _new_space() -> pymunk.Space:
    space = pymunk.Space()
    space.iterations = 20
    space.collision_slop = 2e-4
    space.collision_bias = 1e-6
    space.collision_persistence = 3
    return space


def _refuse_more_than(most: int, overlaps: int) -> None:
    if overlaps > most:
        raise ArenaError("", tr("too many things lie on each other; give the movable ones places of their own."))


def _solid_rectangles(arena: Arena) -> Iterator[tuple[float, float, float, float]]:
    """The border and the wall tiles as few rectangles (x, y, w, h): runs of a row, merged upwards when equal."""
    w, h, b = arena.width, arena.height, _BORDER
    yield from ((-b, -b, w + 2 * b, b), (-b, h, w + 2 * b, b), (-b, 0.0, b, h), (w, 0.0, b, h))
    open_runs: dict[tuple[int, int], int] = {}
    rows = len(arena.tiles)
    tile = arena.tile

    for i, row in enumerate((*arena.tiles, "")):
        runs = _runs(row)
        known = set(runs)
        for run in [run for run in open_runs if run not in known]:
            top = open_runs.pop(run)
            yield run[0] * tile, (rows - i) * tile, (run[1] - run[0]) * tile, (i - top) * tile
        for run in runs:
            open_runs.setdefault(run, i)


def _runs(row: str) -> list[tuple[int, int]]:
    runs: list[tuple[int, int]] = []
    start = None
    for i, char in enumerate(row + "."):
        if char == "#" and start is None:
            start = i
        elif char != "#" and start is not None:
            runs.append((start, i))
            start = None
    return runs
