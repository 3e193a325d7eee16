"""The world against closed form, against geometry, and against everything a fuzzer can think of."""

from __future__ import annotations

import math
import subprocess
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.robots.kobuki.facts import (
    COMMAND_TIMEOUT,
    MAX_ACCELERATION,
    MAX_ANGULAR_ACCELERATION,
    MAX_ANGULAR_SPEED,
    MAX_SPEED,
    MAX_WHEEL_SPEED,
    RADIUS,
    WHEELBASE,
)
from rosy_sim.robots.kobuki.sensors import bumper_bits
from rosy_sim.robots.shared.places import wrapped
from rosy_sim.world.arena import Arena, Pose, read_arena
from rosy_sim.world.events import Lift, Press, Reading, Teleport, velocity
from rosy_sim.world.motor_controller import MotorController, approach
from rosy_sim.world.time_step import STEP
from rosy_sim.world.world import ActionRefused, World

from ..conftest import events_of, hall
from ..extent import NIGHTLY

LEFT, CENTRE, RIGHT = 4, 2, 1


def drive(world: World, linear: float, angular: float, seconds: float) -> list[tuple[int, Reading]]:
    """Command every step; the events that come of it, with their step."""
    events = []
    for step in range(round(seconds / STEP)):
        events += [(step, event) for event in events_of(world)]
        world.command(velocity(linear, angular))
        world.integrate()
    return events


# Against closed form


@pytest.mark.parametrize("speed", [0.1, 0.5, 0.7, -0.3])
def test_straight_is_ramp_plus_distance(speed: float) -> None:
    world = hall()
    drive(world, speed, 0.0, 4.0)
    ramp = abs(speed) / MAX_ACCELERATION
    expected = math.copysign(abs(speed) * (4.0 - ramp / 2), speed)
    assert world.x - 10 == pytest.approx(expected, rel=0.005)
    assert (world.y, world.theta, world.v) == (10.0, 0.0, speed)


@pytest.mark.parametrize("spin", [0.5, -2.0, math.pi])
def test_spin_is_ramp_plus_angle(spin: float) -> None:
    world = hall()
    drive(world, 0.0, spin, 10.0)
    ramp = abs(spin) / MAX_ANGULAR_ACCELERATION
    assert world.theta == pytest.approx(math.copysign(abs(spin) * (10.0 - ramp / 2), spin), rel=0.005)
    assert (world.x, world.y) == (10.0, 10.0)


@pytest.mark.parametrize(("v", "w"), [(0.3, 0.5), (0.7, -1.0), (-0.2, 0.4)])
def test_an_arc_closes_to_its_circle(v: float, w: float) -> None:
    world = hall()
    drive(world, v, w, 1.0)
    centre = (world.x - v / w * math.sin(world.theta), world.y + v / w * math.cos(world.theta))
    for _ in range(200):
        world.sense()
        world.command(velocity(v, w))
        world.integrate()
        assert math.dist((world.x, world.y), centre) == pytest.approx(abs(v / w), rel=0.005)


def test_odometry_is_one_frame_whatever_the_start_pose() -> None:
    straight = hall()
    turned = World(read_arena({"size": [20, 20], "start": {"x": 4, "y": 7, "theta": 2.5}}), KOBUKI)
    assert turned.odometry() == (0.0, 0.0, 0.0, 0.0, 0.0)
    for world in (straight, turned):
        drive(world, 0.5, 0.4, 3.0)
    assert turned.odometry() == pytest.approx(straight.odometry(), abs=1e-9)


def test_backwards_at_heading_zero_decreases_x() -> None:
    world = World(read_arena({"size": [20, 20], "start": {"x": 10, "y": 10, "theta": math.pi}}), KOBUKI)
    drive(world, -0.5, 0.0, 1.0)
    assert world.odometry()[0] < -0.4
    assert world.x > 10.4


# The motors


@given(st.floats(1e-4, 1.0), st.floats(-1e3, 1e3), st.floats(-5.0, 5.0))
def test_a_speed_never_changes_faster_than_its_limit(dt: float, target: float, value: float) -> None:
    after = approach(dt, MAX_ACCELERATION, target, value)
    assert abs(after - value) <= MAX_ACCELERATION * dt * (1 + 1e-9)
    assert min(value, target) - 1e-12 <= after <= max(value, target) + 1e-12


@given(
    st.lists(
        st.tuples(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.sampled_from([1e-3, STEP, 0.1, 0.7])),
        min_size=1, max_size=20,
    )
)  # fmt: skip
def test_limits_hold_for_every_dt(plan: list[tuple[float, float, float]]) -> None:
    world = World(read_arena({"size": [100, 100], "start": {"x": 50, "y": 50, "theta": 0}}), KOBUKI)
    for linear, angular, dt in plan:
        v, w, x, y = world.v, world.w, world.x, world.y
        world.command(velocity(linear, angular))
        world.integrate(dt)
        assert abs(world.v) <= MAX_SPEED
        assert abs(world.w) <= MAX_ANGULAR_SPEED
        assert abs(world.v) + abs(world.w) * WHEELBASE / 2 <= MAX_WHEEL_SPEED + 1e-9
        assert abs(world.v - v) <= MAX_ACCELERATION * dt + 1e-9
        assert abs(world.w - w) <= MAX_ANGULAR_ACCELERATION * dt + 1e-9
        assert math.dist((x, y), (world.x, world.y)) <= MAX_SPEED * dt + 1e-9


@pytest.mark.parametrize(
    ("asked", "driven"),
    [
        ((0.7, 3.0), (0.7 * 0.7 / 1.045, 3.0 * 0.7 / 1.045)),
        ((-0.7, 3.0), (-0.7 * 0.7 / 1.045, 3.0 * 0.7 / 1.045)),
        ((0.7, 0.0), (0.7, 0.0)),
        ((0.0, math.pi), (0.0, math.pi)),
        ((0.3, -3.0), (0.3, -3.0)),
        # Each speed within its own limit first, as the guard of a real robot does.
        ((9.0, 9.0), (0.7 * 0.7 / (0.7 + math.pi * 0.115), math.pi * 0.7 / (0.7 + math.pi * 0.115))),
    ],
)  # fmt: skip
def test_no_wheel_turns_faster_than_it_can_and_the_curve_stays(
    asked: tuple[float, float], driven: tuple[float, float]
) -> None:
    world = World(read_arena({"size": [100, 100], "start": {"x": 50, "y": 50, "theta": 0}}), KOBUKI)
    drive(world, *asked, 2.0)
    assert (world.v, world.w) == pytest.approx(driven)


def test_the_watchdog_stops_a_robot_that_is_told_nothing() -> None:
    world = hall()
    world.command(velocity(0.5, 0.0))
    speeds = []
    for _ in range(60):
        world.integrate()
        speeds.append(world.v)
    last_full = max(i for i, v in enumerate(speeds) if v == 0.5)
    assert (last_full + 1) * STEP == pytest.approx(COMMAND_TIMEOUT)
    assert speeds[-1] == 0.0


def test_the_watchdog_sleeps_before_the_first_command_and_wakes_for_the_next() -> None:
    motors = MotorController(KOBUKI.limits)
    for _ in range(100):
        motors.next(STEP, 0.0, 0.0)
    motors.command(0.5, 0.0)
    assert motors.next(STEP, 0.0, 0.0)[0] > 0


# Walls and bumpers


@pytest.mark.parametrize(
    ("bearing", "bits"),
    [
        (0, CENTRE), (29, CENTRE), (30, CENTRE | LEFT), (31, LEFT), (89, LEFT), (90, LEFT), (91, 0), (180, 0),
        (-30, CENTRE | RIGHT), (-60, RIGHT), (-91, 0), (359, CENTRE), (-300, LEFT), (720 + 45, LEFT),
    ],
)  # fmt: skip
def test_a_contact_presses_the_zone_it_is_in(bearing: float, bits: int) -> None:
    for heading in (0.0, 1.0, -3.0, math.pi, 20.0):
        assert bumper_bits([math.radians(bearing) + heading], heading) == bits


def test_several_contacts_press_several_zones() -> None:
    assert bumper_bits([math.radians(70), math.radians(-70)], 0.0) == LEFT | RIGHT


@given(st.floats(-50, 50))
def test_wrapping_keeps_the_direction(angle: float) -> None:
    assert -math.pi < wrapped(angle) <= math.pi
    assert math.cos(wrapped(angle)) == pytest.approx(math.cos(angle), abs=1e-9)


def test_a_robot_stops_at_a_wall_and_says_so_once() -> None:
    world = World(read_arena({"size": [5, 4], "start": {"x": 1.5, "y": 2, "theta": 0}}), KOBUKI)
    events = drive(world, 0.5, 0.0, 10.0)
    assert [event for _, event in events] == [Reading("RobotStatus", (1,)), Reading("Bumper", (1, 1))]
    assert world.x == pytest.approx(5 - RADIUS, abs=1e-3)
    assert world.v == 0.0
    assert [event for _, event in drive(world, -0.5, 0.0, 1.0)] == [Reading("Bumper", (1, 0))]


def test_a_robot_in_a_corner_feels_both_walls() -> None:
    world = World(read_arena({"size": [3, 3], "start": {"x": 2, "y": 2, "theta": math.pi / 4}}), KOBUKI)
    drive(world, 0.5, 0.0, 5.0)
    assert world.sensors.bumpers == LEFT | RIGHT


def test_a_pinned_robot_told_to_turn_turns_no_faster_than_told() -> None:
    world = World(read_arena({"size": [5, 4], "start": {"x": 4.5, "y": 2, "theta": 0.3}}), KOBUKI)
    for _ in range(2000):
        world.sense()
        _, _, _, v, w = world.odometry()
        world.command(velocity(v + 0.5, w))
        world.integrate()
    assert abs(world.w) < 1e-6


coordinates = st.floats(0.3, 5.7)
walls = st.lists(st.tuples(coordinates, coordinates, coordinates, coordinates), max_size=6)
boxes = st.lists(
    st.tuples(coordinates, coordinates, st.floats(0.05, 1.0), st.floats(0.05, 1.0), st.floats(-3, 3), st.booleans()),
    max_size=8,
)
tiles = st.lists(st.text("#....O", min_size=12, max_size=12), min_size=12, max_size=12)
commands = st.lists(
    st.tuples(st.floats(-1, 1), st.floats(-4, 4), st.integers(1, 40)), min_size=1, max_size=12
)  # fmt: skip


@st.composite
def arenas(draw: st.DrawFn) -> World:
    """Rooms full of junk, with the robot wherever it fits."""
    value: dict[str, object] = {
        "size": [6, 6],
        "walls": [{"from": [a, b], "to": [c, d]} for a, b, c, d in draw(walls)],
        "boxes": [
            {"x": x, "y": y, "w": w, "h": h, "theta": t, "movable": m} for x, y, w, h, t, m in draw(boxes)
        ],
    }  # fmt: skip
    if draw(st.booleans()):
        value["tiles"] = draw(tiles)
    from rosy_sim.world.arena import ArenaError

    theta = draw(st.floats(-4, 4))
    for x, y in [(3, 3), (1, 1), (5, 1), (1, 5), (5, 5), (3, 1), (3, 5), (1, 3), (5, 3)]:
        try:
            return World(read_arena({**value, "start": {"x": x, "y": y, "theta": theta}}), KOBUKI)
        except ArenaError:
            continue
    return World(read_arena({"size": [6, 6], "start": {"x": 3, "y": 3, "theta": theta}}), KOBUKI)


def wall_depth(world: World) -> float:
    """How far the robot is inside something that cannot move, m: from the shapes themselves, without pymunk."""
    arena = world.arena
    x, y = world.x, world.y
    gaps = [x, y, arena.width - x, arena.height - y]
    for wall in arena.walls:
        dx, dy = wall.x1 - wall.x0, wall.y1 - wall.y0
        length = dx * dx + dy * dy
        t = max(0.0, min(1.0, ((x - wall.x0) * dx + (y - wall.y0) * dy) / length)) if length else 0.0
        gaps.append(math.dist((x, y), (wall.x0 + t * dx, wall.y0 + t * dy)) - 0.025)
    for box in arena.boxes:
        if not box.movable:
            gaps.append(_rectangle_gap(x, y, box.x, box.y, box.w, box.h, box.theta))
    gaps += [math.dist((x, y), (round_.x, round_.y)) - round_.r for round_ in arena.rounds if not round_.movable]
    for row, text in enumerate(arena.tiles):
        for column, char in enumerate(text):
            if char == "#":
                cx, cy = (column + 0.5) * arena.tile, (len(arena.tiles) - row - 0.5) * arena.tile
                gaps.append(_rectangle_gap(x, y, cx, cy, arena.tile, arena.tile, 0.0))
    return RADIUS - min(gaps)


def _rectangle_gap(x: float, y: float, cx: float, cy: float, w: float, h: float, theta: float) -> float:
    c, s = math.cos(theta), math.sin(theta)
    u, v = abs(c * (x - cx) + s * (y - cy)) - w / 2, abs(c * (y - cy) - s * (x - cx)) - h / 2
    return math.hypot(max(u, 0), max(v, 0)) + min(max(u, v), 0)


@settings(max_examples=150 if NIGHTLY else 40, deadline=None)
@given(arenas(), commands)
def test_physics_holds_in_any_room(world: World, plan: list[tuple[float, float, int]]) -> None:
    """Never inside a wall, never faster than told, sensors agree with geometry."""
    for linear, angular, steps in plan:
        for _ in range(steps):
            x, y = world.x, world.y
            world.sense()
            world.command(velocity(linear, angular))
            world.integrate()
            assert wall_depth(world) <= 1e-3
            assert abs(world.v) <= MAX_SPEED
            assert abs(world.w) <= MAX_ANGULAR_SPEED
            if not world.obstacles.movables:
                assert math.dist((x, y), (world.x, world.y)) <= MAX_SPEED * STEP + 1e-7
        bits = world.sensors
        if bits.bumpers and not world.obstacles.movables:
            assert wall_depth(world) > -2e-3
        hanging = 0
        for bit, side in ((2, 0.115), (1, -0.115)):
            px, py = world.x - side * math.sin(world.theta), world.y + side * math.cos(world.theta)
            hanging |= bit if world.arena.is_hole(px, py) else 0
        assert bits.wheels == hanging


@settings(max_examples=30, deadline=None)
@given(st.floats(-1.5, 1.5), st.floats(0.05, 0.7), st.floats(0.2, 0.6), st.floats(-0.3, 0.3))
def test_pushing_a_box_never_makes_energy(theta: float, speed: float, size: float, aside: float) -> None:
    box = {"x": 11, "y": 10 + aside, "w": size, "h": size, "theta": theta, "movable": True, "mass": 1.0}
    world = hall(boxes=[box])
    body = world.obstacles.movables[0]
    fastest = 0.0
    for _ in range(250):
        world.sense()
        world.command(velocity(speed, 0.0))
        world.integrate()
        fastest = max(fastest, body.velocity.length)
    assert fastest <= 2.0 * speed
    for _ in range(200):
        world.sense()
        world.integrate()
    assert body.velocity.length < 1e-3
    assert body.angular_velocity < 1e-2


def test_a_light_box_moves_and_a_heavy_one_does_not() -> None:
    moved = []
    for mass in (0.5, 200.0):
        world = hall(boxes=[{"x": 11, "y": 10, "w": 0.4, "h": 0.4, "movable": True, "mass": mass}])
        drive(world, 0.3, 0.0, 8.0)
        moved.append(world.obstacles.poses()[0][0] - 11)
        assert world.sensors.bumpers == CENTRE
    assert moved[0] > 0.5
    assert moved[1] < 0.02


# Holes, hands, order

PIT: dict[str, object] = {
    "tile": 0.5, "tiles": ["........", "....OO..", "....OO..", "........"], "start": {"x": 0.5, "y": 1.0, "theta": 0},
}  # fmt: skip


def test_a_robot_sees_the_edge_before_its_wheels_reach_it_then_tips_and_stays() -> None:
    world = World(read_arena(PIT), KOBUKI)
    events = drive(world, 0.3, 0.0, 15.0)
    assert [event for _, event in events][:2] == [Reading("RobotStatus", (1,)), Reading("Cliff", (1, 1))]
    wheels = [event for _, event in events if event.channel == "Wheel"]
    assert wheels == [Reading("Wheel", (0, 1)), Reading("Wheel", (1, 1))]
    assert [event for _, event in drive(world, -0.5, 0.0, 3.0)] == []
    assert world.v == 0.0
    world.apply(Teleport(Pose(0.5, 1.0, 0.0)))
    assert Reading("Wheel", (0, 0)) in world.sense()


def test_a_robot_that_brakes_at_the_cliff_stays_on_the_floor() -> None:
    world = World(read_arena(PIT), KOBUKI)
    speed = 0.5
    for _ in range(500):
        if any(event.channel == "Cliff" for event in world.sense()):
            speed = 0.0
        world.command(velocity(speed, 0.0))
        world.integrate()
    assert world.sensors.wheels == 0
    assert world.sensors.cliffs == CENTRE


def test_events_of_one_packet_come_in_kobukis_order() -> None:
    world = World(read_arena(PIT), KOBUKI)
    world.sense()
    world.apply(Lift("both", True))
    world.apply(Press(2, True))
    world.apply(Press(0, True))
    world.apply(Teleport(Pose(0.0, 0.0, math.radians(180 + 45))))
    kinds = [(event.channel, event.values[0]) for event in events_of(world)]
    assert kinds == [("Button", 0), ("Button", 2), ("Bumper", 0), ("Bumper", 2), ("Wheel", 0), ("Wheel", 1)]
    assert events_of(world) == []


@pytest.mark.parametrize(
    ("changes", "sensed"),
    [
        # A click between two steps.
        ([[True, False]], [[1], [0], []]),
        ([[True], [False]], [[1], [0], []]),
        # Let go and pressed again between two steps.
        ([[True], [False, True]], [[1], [0], [1], []]),
        ([[True, False], [], [True, False]], [[1], [0], [1], [0], []]),
        # More clicks than a robot can sense are one.
        ([[True, False, True, False]], [[1], [0], []]),
        ([[False]], [[], []]),
    ],
)
def test_a_press_is_sensed_however_short_it_is(changes: list[list[bool]], sensed: list[list[int]]) -> None:
    world = hall()
    world.sense()
    found = []
    for step in range(len(sensed)):
        for down in changes[step] if step < len(changes) else []:
            world.apply(Press(1, down))
        found.append([event.values[1] for event in events_of(world)])
        world.integrate()
    assert found == sensed


def test_a_lifted_robot_does_not_move() -> None:
    world = hall()
    world.apply(Lift("left", True))
    drive(world, 0.5, 0.5, 1.0)
    assert (world.x, world.y, world.theta) == (10.0, 10.0, 0.0)
    world.apply(Lift("both", False))
    drive(world, 0.5, 0.0, 1.0)
    assert world.x > 10


def test_a_hand_cannot_put_the_robot_into_a_wall() -> None:
    tiles = ["......", ".####.", "......"]
    world = World(read_arena({"tile": 0.5, "tiles": tiles, "start": {"x": 0.25, "y": 0.25}}), KOBUKI)
    world.apply(Teleport(Pose(1.5, 0.45, 0.0)))
    assert wall_depth(world) <= 1e-3
    with pytest.raises(ActionRefused):
        world.apply(Teleport(Pose(-3, 0, 0)))


def test_odometry_does_not_notice_a_hand() -> None:
    world = hall()
    drive(world, 0.5, 0.3, 2.0)
    before = world.odometry()
    world.apply(Teleport(Pose(3, 3, -2)))
    assert world.odometry()[:3] == pytest.approx(before[:3], abs=1e-9)


# The same again

_TWICE = """
from tests.world.test_world import trace_of_a_busy_room
print(trace_of_a_busy_room())
"""


def trace_of_a_busy_room() -> str:
    """A long run among boxes as text, every float to the last bit."""
    value = {
        "size": [4, 4], "start": {"x": 1, "y": 2, "theta": 0.1}, "walls": [{"from": [3, 1], "to": [2.5, 3]}],
        "boxes": [
            {"x": 1.6 + i * 0.2, "y": 1.2 + i * 0.35, "w": 0.3, "h": 0.2, "theta": i, "movable": True} for i in range(5)
        ],
    }  # fmt: skip
    world = World(read_arena(value), KOBUKI)
    lines = []
    for step in range(1500):
        lines.append(repr((world.sense(), world.odometry(), world.obstacles.poses())))
        world.command(velocity(0.5 * math.sin(step / 70), 1.5 * math.cos(step / 110)))
        world.integrate()
    return "\n".join(lines)


def test_the_same_inputs_give_the_same_bytes_in_another_process() -> None:
    runs = [
        subprocess.run([sys.executable, "-c", _TWICE], capture_output=True, check=True, cwd=_root()).stdout
        for _ in range(2)
    ]
    assert runs[0] == runs[1]
    assert runs[0].decode().strip() == trace_of_a_busy_room()


def _root() -> str:
    from pathlib import Path

    return str(Path(__file__).resolve().parents[2])


def test_tiles_count_from_the_top_and_points_from_the_bottom() -> None:
    arena: Arena = read_arena({"tiles": ["O.", ".#"], "start": {"x": 0.25, "y": 0.25}})
    assert [arena.tile_at(x, y) for x, y in [(0.2, 0.8), (0.8, 0.8), (0.2, 0.2), (0.8, 0.2), (5, 5)]] == list("O..##")
