"""
What each example does, read from the trace of a run with a fixed seed in its own world.

The random walk, the safety controller and the two together are held against the programs they follow:
kobuki_random_walker (random_walker_controller.hpp), kobuki_safety_controller (safety_controller.hpp) and
kobuki_apps' safe_random_walker. A test whose name says "unlike the reference" is a difference that the paper's
program has, and that stays: it reacts to each change once, where the reference looks at all its flags ten times
a second.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import pytest

from rosy_sim.config import discover
from rosy_sim.robots.kobuki.facts import MAX_SPEED, RADIUS
from rosy_sim.run.steps import lockstep
from rosy_sim.run.steps.command_conflicts import CommandConflict, CommandConflicts
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Lift, Press, Teleport
from rosy_sim.world.field_readers import Pose
from rosy_sim.worlds.gallery import named_world

from .real_runs import Ran, example, program, ran, velocities, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

LONG_WALKS = range(1, 1 + int(os.environ.get("ROSY_SEEDS", "4")))
"""Seeds of the walks of ten minutes."""

AT_THE_WALL = 5 - RADIUS
"""Where the middle of the robot is when it touches the wall ahead in `room`, m."""

TICK = 0.1
"""Time between two looks at the clock, s."""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


REMEMBERED = {("cruise", "safetyControl"), ("safetyControl", "cruise"), ("turn", "drive")}
"""
Winners and losers in examples. The page does not report them: one reads what the other one's events have written, or is
a task after the other.
"""


@pytest.fixture(autouse=True)
def no_false_alarm(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Functions of the examples do not override each other's commands."""
    found: list[CommandConflict] = []

    class Recorded(CommandConflicts):
        def observe(self, *of_step: Any) -> list[CommandConflict]:
            found.extend(super().observe(*of_step))
            return []

    monkeypatch.setattr(lockstep, "CommandConflicts", Recorded)
    yield
    assert {(conflict.winner, conflict.loser) for conflict in found} <= REMEMBERED


def test_move_drives_half_a_metre_a_second_until_the_wall(worker: BlockingWorker) -> None:
    run = example(worker, "move", 10)
    [bump] = run.heard("CenterBumper Pressed")
    assert {(v, w) for _, v, w in run.velocities()} == {(0.5, 0.0)}
    assert all(line["v"] == pytest.approx(0.5) for line in run.between(0.5, bump - 0.1))
    assert run.world.x == pytest.approx(AT_THE_WALL, abs=1e-3)
    assert (run.world.y, run.world.v) == (2.0, 0.0)


def test_accelerate_gets_faster_until_the_motors_can_do_no_more(worker: BlockingWorker) -> None:
    run = example(worker, "accelerate", 10)
    [bump] = run.heard("CenterBumper Pressed")
    speeds = [line["v"] for line in run.between(0, bump - 0.1)]
    assert speeds == sorted(speeds)
    assert (speeds[0], speeds[-1]) == (0.0, MAX_SPEED)
    assert all(v == pytest.approx(line["v"] + 0.5) for line in run.lines for v, _ in velocities(line))


def test_accelerate_and_play_plays_one_error_sound_per_press(worker: BlockingWorker) -> None:
    again = [(time, Teleport(Pose(3.0, 2.0, 0.0))) for time in (6.0, 11.0, 16.0)]
    run = example(worker, "accelerateAndPlay", 21, *again)
    presses = run.heard("Bumper", "Pressed")
    assert len(presses) == 4
    assert len(run.heard("Bumper", "Released")) == 3
    assert [line["t"] for line in run.lines for command in line["commands"] if command == "ErrorSound"] == presses
    assert max(line["v"] for line in run.lines) == MAX_SPEED


def test_forward_backward_goes_forwards_until_the_first_bump_and_backwards_after(worker: BlockingWorker) -> None:
    run = example(worker, "forwardBackward", 20)
    [bump] = run.heard("Pressed")
    assert all(line["v"] > 0 for line in run.between(0.1, bump))
    assert all(line["v"] <= 0 for line in run.between(bump + 0.1, 20))
    assert min(line["v"] for line in run.lines) == -MAX_SPEED
    assert run.world.x == pytest.approx(RADIUS, abs=1e-3)


def test_blink_has_the_light_on_in_every_second_second(worker: BlockingWorker) -> None:
    run = example(worker, "blink", 10)
    seen = [(line["t"], command) for line in run.lines for command in line["commands"]]
    assert {(command, int(time) % 2) for time, command in seen} == {("Led1 Orange", 0), ("Led1 Black", 1)}
    assert len(seen) == 100
    changes = [later[0] for earlier, later in pairwise(seen) if earlier[1] != later[1]]
    assert changes == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]


def test_wander_drives_ten_seconds_and_turns_five_by_the_clock_whatever_is_in_the_way(worker: BlockingWorker) -> None:
    run = example(worker, "wander", 45)
    wanted = [((0.2, 0.0) if time % 15 < 10 else (0.0, 0.5)) for time, _, _ in run.velocities()]
    assert [(v, w) for _, v, w in run.velocities()] == wanted
    assert len(wanted) == 450
    assert run.at(10)["x"] - run.at(0)["x"] == pytest.approx(2.0, abs=0.02)
    assert run.at(15)["theta"] - run.at(10)["theta"] == pytest.approx(2.5, abs=0.03)
    assert run.heard("Pressed")


# Tasks


def test_turn_ends_a_quarter_to_the_left_with_the_robot_at_rest(worker: BlockingWorker) -> None:
    run = example(worker, "turn", 20)
    world = run.rest()
    assert run.outcome.ended == "done"
    assert world.theta == pytest.approx(math.pi / 2, abs=0.02)
    assert (world.v, world.w) == (0.0, 0.0)
    assert (world.x, world.y) == (10.0, 10.0)


def test_move_ahead_drives_half_a_metre_and_comes_back(worker: BlockingWorker) -> None:
    run = example(worker, "moveAhead", 20)
    assert run.outcome.ended == "done"
    assert max(line["x"] for line in run.lines) == pytest.approx(10.5, abs=0.03)
    assert {line["y"] for line in run.lines} == {10.0}
    world = run.rest()
    assert world.x == pytest.approx(10.0, abs=0.03)
    assert (world.v, world.w) == (0.0, 0.0)


def test_draw_square_turns_at_four_corners_half_a_metre_apart_and_ends_where_it_began(worker: BlockingWorker) -> None:
    run = example(worker, "drawSquare", 60)
    assert run.outcome.ended == "done"
    corners: list[tuple[float, float]] = []
    for before, line in pairwise(run.lines):
        if before["w"] < 0.4 <= line["w"]:
            corners.append((line["x"], line["y"]))
    assert len(corners) == 4
    for here, (x, y) in zip(corners, [(10.5, 10.0), (10.5, 10.5), (10.0, 10.5), (10.0, 10.0)], strict=True):
        assert math.dist(here, (x, y)) < 0.03
    for one, next_one in pairwise([*corners, corners[0]]):
        assert math.dist(one, next_one) == pytest.approx(0.5, abs=0.03)
    world = run.rest()
    assert math.dist((world.x, world.y), (10.0, 10.0)) < 0.03
    assert world.theta == pytest.approx(2 * math.pi, abs=0.08)
    assert (world.v, world.w) == (0.0, 0.0)


def test_draw_star_draws_five_lines_of_a_metre_and_raises_the_pen(worker: BlockingWorker) -> None:
    run = example(worker, "drawStar", 90)
    assert run.outcome.ended == "done"
    assert [c for line in run.lines for c in line["commands"] if c.startswith("Pen") or c.endswith("Ink")] == [
        "BlueInk",
        "PenWidth 5.0e-2",
        "PenDown",
        "PenUp",
    ]
    drawn = [line for line in run.lines if line["v"] > 0.2]
    assert all(math.dist((line["x"], line["y"]), (10.0, 10.0)) < 1.05 for line in drawn)
    assert math.dist((run.world.x, run.world.y), (10.0, 10.0)) < 0.05
    assert run.world.channels()["Pen"] == (0,)


@pytest.mark.parametrize("room", ["oval", "crossing"])
def test_follow_line_drives_a_lap_and_turns_only_as_far_as_the_line_does(room: str, worker: BlockingWorker) -> None:
    run = example(worker, "followLine", 100, world=room)
    [goal] = run.outcome.goals
    assert goal.state == "done"
    assert {command for line in run.lines for command in line["commands"]} == {
        "Velocity 0.2 0.0",
        "Velocity 0.1 1.0",
        "Velocity 0.1 (-1.0)",
    } - ({"Velocity 0.1 (-1.0)"} if room == "oval" else set())


@pytest.mark.parametrize(("start", "distance"), [((1.5, 2.0, 0.0), 332), ((2.5, 2.0, 0.0), 232)])
def test_measure_says_the_distance_it_drove(
    start: tuple[float, float, float], distance: int, worker: BlockingWorker
) -> None:
    source, _ = program("measure")
    x, y, theta = start
    room = {**named_world("room"), "start": {"x": x, "y": y, "theta": theta}}
    run = ran(worker, source, 60, world=room)
    assert run.outcome.ended == "done"
    assert run.said == [f"{distance} centimetres"]
    assert 100 * (run.world.x - x) == pytest.approx(distance, abs=1)
    assert run.rest().v == 0.0


# The random walk (kobuki_random_walker, random_walker_controller.hpp)


def test_random_walk_shows_bumpers_on_led1_and_cliffs_on_led2(worker: BlockingWorker) -> None:
    walk = example(worker, "randomWalk", 60)
    edge = example(worker, "randomWalk", 8, world="table")
    assert len(walk.heard("Bumper", "Pressed")) > 5
    assert edge.heard("Cliff", "Hole")
    for run, sensor, light in ((walk, "Bumper", "Led1"), (edge, "Cliff", "Led2")):
        for line in run.lines:
            changes = [event for event in line["events"] if event.startswith(sensor)]
            wheels = any(event.startswith("Wheel") for event in line["events"])
            shown = [c for c in line["commands"] if c.startswith(light)]
            if not wheels:
                on = ("Pressed", "Hole")
                assert shown == [f"{light} {'Orange' if e.endswith(on) else 'Black'}" for e in changes]


def test_random_walk_shows_red_and_stands_while_its_wheels_hang_and_goes_on_after(worker: BlockingWorker) -> None:
    run = example(worker, "randomWalk", 4, (1.0, Lift("both", True)), (2.5, Lift("both", False)))
    assert {"Led1 Red", "Led2 Red"} <= set(run.at(1.0)["commands"])
    assert {velocity for line in run.between(1.0, 2.5) for velocity in velocities(line)} == {(0.0, 0.0)}
    assert {"Led1 Black", "Led2 Black"} <= set(run.at(2.5)["commands"])
    assert run.velocities()[-1][1:] == (0.5, 0.0)
    assert run.at(3.5)["v"] == pytest.approx(0.5)


def test_random_walk_turns_up_to_half_a_turn_to_either_side_after_each_bump(worker: BlockingWorker) -> None:
    """
    Forty times a hand sets the robot before a wall, and takes it into the open just after the bump, so that each turn
    is seen to its end. Duration in U(0, π/ω) and a side with probability ½, with ω = 1 rad/s.
    """
    cycle, cycles = 8.0, 40
    before_wall, open_floor = Pose(20 - RADIUS - 0.5, 10.0, 0.0), Pose(5.0, 10.0, 0.0)
    hands = [
        hand
        for i in range(cycles)
        for hand in ((i * cycle, Teleport(before_wall)), (i * cycle + 1.4, Teleport(open_floor)))
    ]
    run = example(worker, "randomWalk", cycle * cycles, *hands, world="empty")
    bumps = run.heard("Bumper", "Pressed")
    assert len(bumps) == cycles
    durations, sides = [], []
    for i, bump in enumerate(bumps):
        after = [(t, v, w) for t, v, w in run.velocities() if bump <= t < (i + 1) * cycle]
        end = next(t for t, v, _ in after if v == 0.5)
        turning = {(v, w) for t, v, w in after if t < end}
        assert turning <= {(0.0, 1.0)} or turning <= {(0.0, -1.0)}
        assert {(v, w) for t, v, w in after if t >= end} == {(0.5, 0.0)}
        durations.append(end - bump)
        sides += [w for _, w in turning]
    assert all(0 <= duration <= math.pi + 2 * TICK for duration in durations)
    assert (min(durations) < 0.8, max(durations) > 2.3) == (True, True)
    assert sum(durations) / cycles == pytest.approx(math.pi / 2, abs=0.6)
    assert min(sides.count(1.0), sides.count(-1.0)) >= cycles // 4


def test_random_walk_differs_with_the_seed_and_only_with_it(worker: BlockingWorker) -> None:
    one, same, other = (example(worker, "randomWalk", 20, seed=seed).lines for seed in (1, 1, 2))
    assert one == same
    assert one != other


def test_random_walk_does_not_back_off_and_may_push_a_wall_for_good(worker: BlockingWorker) -> None:
    """The reference pivots in contact with the wall too. Seed 2 ends with a turn that is too small."""
    run = example(worker, "randomWalk", 120, seed=2)
    assert {v for _, v, _ in run.velocities()} == {0.0, 0.5}
    assert max(run.heard("Bumper")) < 30
    assert all(line["v"] < 0.1 for line in run.between(100, 120))


def test_random_walk_unlike_the_reference_darkens_led1_when_one_of_two_bumpers_is_let_go(
    worker: BlockingWorker,
) -> None:
    """The reference keeps LED1 orange until none is pressed; the paper's `bumper` answers each change by itself."""
    pressed: set[str] = set()
    dark = 0
    for line in example(worker, "randomWalk", 60).lines:
        for event in line["events"]:
            if event.startswith("Bumper"):
                _, side, status = event.split()
                pressed = pressed | {side} if status == "Pressed" else pressed - {side}
        dark += bool(pressed) and [c for c in line["commands"] if c.startswith("Led1")][-1:] == ["Led1 Black"]
    assert dark > 0


def test_random_walk_unlike_the_reference_goes_on_when_the_first_of_two_wheels_is_down(
    worker: BlockingWorker,
) -> None:
    """The reference stands until neither wheel hangs; the paper's `wheel` has no flag per wheel."""
    run = example(worker, "randomWalk", 4, (1.0, Lift("both", True)), (2.0, Lift("left", False)))
    assert run.heard("Wheel", "Ground") == [2.0]
    assert run.velocities()[-1][1:] == (0.5, 0.0)
    assert run.world.v == 0.0


# The safety controller (kobuki_safety_controller, safety_controller.hpp)


def touching(side: float) -> Pose:
    """In `room`, a tenth of a metre before the wall ahead, which will be felt at this bearing."""
    return Pose(AT_THE_WALL - 0.1, 2.0, -math.radians(side))


@pytest.mark.parametrize(("bearing", "bumper", "away"), [(60, "Left", -0.4), (0, "Center", 0.0), (-60, "Right", 0.4)])
def test_safety_control_backs_off_from_a_wall_and_turns_away_from_it(
    bearing: float, bumper: str, away: float, worker: BlockingWorker
) -> None:
    run = example(worker, "safetyControl", 3, (0.0, Teleport(touching(bearing))))
    first = run.heard(f"Bumper {bumper}Bumper Pressed")[0]
    released = run.heard(f"Bumper {bumper}Bumper Released")[0]
    assert [velocity for line in run.between(first, released) for velocity in velocities(line)] == [(-0.1, away)]
    assert min(line["v"] for line in run.between(first, released + 0.1)) < -0.05
    turned = run.at(released)["theta"] - run.at(first)["theta"]
    assert math.copysign(1, turned) == math.copysign(1, away) if away else turned == 0


def test_safety_control_knocks_again_and_again_at_a_wall_straight_ahead(worker: BlockingWorker) -> None:
    run = example(worker, "safetyControl", 30)
    knocks = run.heard("Bumper CenterBumper Pressed")
    assert len(knocks) > 50
    assert {velocity for time in run.heard("Bumper", "Released") for velocity in velocities(run.at(time))} == {
        (0.2, 0.0)
    }
    assert min(line["x"] for line in run.between(knocks[0], 30.0)) > AT_THE_WALL - 0.02


def test_safety_control_keeps_the_robot_on_a_table_by_backing_off_from_its_edge(worker: BlockingWorker) -> None:
    run = example(worker, "safetyControl", 60, world="table")
    assert not run.heard("Wheel", "Air")
    holes = run.heard("Cliff CenterCliff Hole")
    assert len(holes) > 5
    for time in holes[:-1]:
        assert velocities(run.at(time)) == [(-0.1, 0.0)]
        assert min(line["v"] for line in run.between(time, time + 0.5)) == pytest.approx(-0.1)


@pytest.mark.parametrize(("heading", "side", "away"), [(0.8, "Right", 0.4), (-0.8, "Left", -0.4)])
def test_safety_control_turns_away_from_a_hole_at_its_side(
    heading: float, side: str, away: float, worker: BlockingWorker
) -> None:
    """Towards the right edge of the table at a slant, the sensor at the other side comes over it first."""
    run = example(worker, "safetyControl", 20, (0.0, Teleport(Pose(3.5, 2.0, heading))), world="table")
    first = run.heard("Cliff", "Hole")[0]
    assert run.heard(f"Cliff {side}Cliff Hole")[0] == first
    assert velocities(run.at(first)) == [(-0.1, away)]
    assert not run.heard("Wheel", "Air")


def test_safety_control_stops_when_a_wheel_hangs_and_goes_on_when_it_does_not(worker: BlockingWorker) -> None:
    run = example(worker, "safetyControl", 4, (1.0, Lift("left", True)), (2.0, Lift("left", False)))
    assert [velocity for line in run.between(1.0, 2.0) for velocity in velocities(line)] == [(0.0, 0.0)]
    assert velocities(run.at(2.0)) == [(0.2, 0.0)]
    assert run.at(3.0)["v"] == pytest.approx(0.2)


def test_safety_control_says_nothing_when_nothing_is_the_matter(worker: BlockingWorker) -> None:
    run = example(worker, "safetyControl", 10)
    assert all(line["fired"] == ["cruise"] for line in run.lines)
    assert {(v, w) for _, v, w in run.velocities()} == {(0.2, 0.0)}


def test_safety_control_unlike_the_reference_warns_once_per_press_and_not_ten_times_a_second(
    worker: BlockingWorker,
) -> None:
    """The reference sends at every tick while a flag is set; one message is obeyed for 0.6 s, then the base stops."""
    run = example(worker, "safetyControl", 30)
    warnings = [time for time, v, _ in run.velocities() if v < 0]
    assert warnings == run.heard("Bumper", "Pressed")


# The multiplexer, and the three together (kobuki_apps, safe_random_walker)


def test_mux_lets_nothing_else_pass_for_a_second_after_an_important_message(worker: BlockingWorker) -> None:
    run = example(worker, "mux", 6, (2.0, Press(0, True)), (2.2, Press(0, False)))
    assert all(velocities(line) == [(0.2, 0.2)] for line in run.between(0.02, 2.0))
    assert velocities(run.at(2.0)) == [(0.0, 1.0)]
    waiting = run.between(2.02, 3.02)
    assert [velocity for line in waiting for velocity in velocities(line)] == []
    assert all("M2 (Velocity 0.2 0.2)" in line["events"] for line in waiting)
    assert all(velocities(line) == [(0.2, 0.2)] for line in run.between(3.02, 6.0))


def test_mux_counts_the_second_from_the_last_important_message(worker: BlockingWorker) -> None:
    hands = [(2.0, Press(0, True)), (2.1, Press(0, False)), (2.6, Press(1, True)), (2.7, Press(1, False))]
    run = example(worker, "mux", 5, *hands)
    assert [time for time, v, _ in run.velocities() if v == 0.0] == [2.0, 2.6]
    assert next(time for time, v, _ in run.velocities() if time > 2.0 and v == 0.2) == pytest.approx(3.6, abs=0.03)


def warned(run: Ran) -> list[tuple[float, str]]:
    """Each bumper press and each hole, with its time."""
    return [
        (line["t"], event)
        for line in run.lines
        for event in line["events"]
        if event.endswith(("Bumper Pressed", "Cliff Hole"))
    ]


def test_safe_random_walk_lets_the_safety_controller_drive_for_a_second_after_each_bump(
    worker: BlockingWorker,
) -> None:
    run = example(worker, "safeRandomWalk", 120, world="room")
    away = {"Left": -0.4, "Center": 0.0, "Right": 0.4}
    times = [(time, next(side for side in away if side in event)) for time, event in warned(run)]
    assert {side for _, side in times} == set(away)
    for time, side in times:
        assert (-0.1, away[side]) in velocities(run.at(time))
        assert all(v == -0.1 for line in run.between(time, time + 1.0) for v, _ in velocities(line))


def test_safe_random_walk_backs_off_from_every_wall(worker: BlockingWorker) -> None:
    run = example(worker, "safeRandomWalk", 300, world="room")
    bumps = [time for time in run.heard("Bumper", "Pressed") if time < 299]
    assert len(bumps) > 20
    assert all(min(line["v"] for line in run.between(time, time + 0.5)) < -0.05 for time in bumps)


@pytest.mark.long
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_safe_random_walk_never_stays_stuck_at_a_wall(seed: int, worker: BlockingWorker) -> None:
    run = example(worker, "safeRandomWalk", 300, seed=seed, world="room")
    assert run.longest_stay(0.25) < 60
    assert max(line["x"] for line in run.lines) - min(line["x"] for line in run.lines) > 3
    assert max(line["y"] for line in run.lines) - min(line["y"] for line in run.lines) > 2


def test_safe_random_walk_stands_while_its_wheels_hang(worker: BlockingWorker) -> None:
    run = example(worker, "safeRandomWalk", 5, (1.0, Lift("both", True)), (3.0, Lift("both", False)))
    assert {velocity for line in run.between(1.0, 3.0) for velocity in velocities(line)} == {(0.0, 0.0)}
    assert run.at(4.9)["v"] == pytest.approx(0.2)


@pytest.mark.long
@pytest.mark.parametrize("seed", LONG_WALKS)
def test_safe_random_walk_stays_out_of_every_pit_for_ten_minutes(seed: int, worker: BlockingWorker) -> None:
    """As the reference, it warns for as long as a sensor sees the hole; `ROSY_SEEDS` asks for more seeds."""
    run = example(worker, "safeRandomWalk", 600, seed=seed)
    assert run.outcome.ended == "time"
    assert len(run.heard("Cliff", "Hole")) > 10
    assert run.heard("Wheel", "Air") == []
    assert run.longest_stay(0.25) < 60
