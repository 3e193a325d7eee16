"""A robot that slips, drifts and hears late: astray as told, the same for the same seed, ideal when all is zero."""

from __future__ import annotations

import math
import statistics

import pytest

from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.robots.kobuki.facts import MAX_ANGULAR_SPEED, MAX_SPEED
from rosy_sim.world.arena import ArenaError, read_arena
from rosy_sim.world.events import velocity
from rosy_sim.world.world import Odometry, World


def odometry(realism: dict[str, float], seed: int, seconds: float = 8.0, spin: float = 0.3) -> tuple[Odometry, World]:
    room = {"size": [40, 40], "start": {"x": 20, "y": 20, "theta": 1.0}, "realism": realism}
    world = World(read_arena(room), KOBUKI, seed)
    for _ in range(round(seconds * 50)):
        world.sense()
        world.command(velocity(0.5, spin))
        world.integrate()
    return world.odometry(), world


def test_all_zero_is_ideal() -> None:
    assert odometry({}, 1)[0] == pytest.approx(odometry({}, 1)[1]._truth(), abs=1e-6)


@pytest.mark.parametrize("realism", [{"slip": 0.1}, {"drift": 0.05}, {"noise": 0.02}])
def test_belief_goes_astray_and_the_seed_decides_how(realism: dict[str, float]) -> None:
    one, world = odometry(realism, 1)
    assert one == odometry(realism, 1)[0]
    assert one != odometry(realism, 2)[0]
    assert one != pytest.approx(world._truth(), abs=1e-4)


def test_wheels_that_slip_take_the_robot_less_far_than_its_odometry_says() -> None:
    for seed in range(20):
        believed, world = odometry({"slip": 0.1}, seed, 8.0, 0.0)
        ideal, _ = odometry({}, seed, 8.0, 0.0)
        driven = math.dist((world.x, world.y), (20, 20))
        assert math.hypot(*believed[:2]) > 1.01 * driven
        assert driven < 0.99 * ideal[0]


def test_wheels_that_slip_differently_bend_a_straight_path_and_the_gyro_sees_it() -> None:
    headings = []
    for seed in range(20):
        believed, world = odometry({"slip": 0.1}, seed, 8.0, 0.0)
        headings.append(world.theta - 1.0)
        assert believed[2] == pytest.approx(world.theta - 1.0, abs=1e-9)
    assert max(headings) > 0.1 > -0.1 > min(headings)


@pytest.mark.parametrize("realism", [{"drift": 0.2}, {"noise": 0.2}])
def test_what_only_the_robot_believes_does_not_move_it(realism: dict[str, float]) -> None:
    (_, astray), (_, ideal) = odometry(realism, 5), odometry({}, 5)
    assert (astray.x, astray.y, astray.theta) == (ideal.x, ideal.y, ideal.theta)


def test_slipping_wheels_keep_to_the_limits_of_the_motors() -> None:
    for seed in range(10):
        room = {"size": [40, 40], "start": {"x": 20, "y": 20}, "realism": {"slip": 0.5}}
        world = World(read_arena(room), KOBUKI, seed)
        for step in range(400):
            world.sense()
            world.command(velocity(0.7, 3.0 if step % 100 < 50 else -0.5))
            world.integrate()
            assert abs(world.v) <= MAX_SPEED
            assert abs(world.w) <= MAX_ANGULAR_SPEED


def test_a_slipping_robot_at_a_wall_does_not_count_what_it_does_not_drive() -> None:
    room = {"size": [4, 4], "start": {"x": 2, "y": 2}, "realism": {"slip": 0.1}}
    world = World(read_arena(room), KOBUKI, 1)
    for _ in range(1500):
        world.sense()
        world.command(velocity(0.5, 0.0))
        world.integrate()
    assert world.odometry()[0] < 3.0


def test_drift_grows_with_the_square_root_of_time() -> None:
    errors = [odometry({"drift": 0.1}, seed, seconds=4.0, spin=0.0)[0][2] for seed in range(60)]
    assert statistics.stdev(errors) == pytest.approx(0.1 * math.sqrt(4.0), rel=0.35)


def test_late_commands_start_the_robot_later() -> None:
    prompt, late = odometry({}, 1, 2.0, 0.0)[1], odometry({"latency": 0.4}, 1, 2.0, 0.0)[1]
    assert math.dist((late.x, late.y), (20, 20)) == pytest.approx(
        math.dist((prompt.x, prompt.y), (20, 20)) - 0.2, abs=0.011
    )


def test_the_ghost_stands_where_the_robot_believes_to_be() -> None:
    believed, world = odometry({"slip": 0.2}, 3)
    ghost = world.ghost()
    assert ghost is not None
    assert math.dist(ghost[:2], (20, 20)) == pytest.approx(math.hypot(*believed[:2]))
    assert World(read_arena({"size": [4, 4], "start": {"x": 2, "y": 2}}), KOBUKI).ghost() is None


@pytest.mark.parametrize(
    ("realism", "path"), [(7, "realism"), ({"fog": 1}, "realism.fog"), ({"slip": -1}, "realism.slip")]
)
def test_a_realism_that_is_none_is_refused(realism: object, path: str) -> None:
    with pytest.raises(ArenaError) as caught:
        read_arena({"size": [4, 4], "start": {"x": 2, "y": 2}, "realism": realism})
    assert caught.value.path == path
