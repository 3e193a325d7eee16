"""Battery and charger: the battery drains everywhere and charges in the dock."""

from __future__ import annotations

import pytest

from rosy_sim.robots.kobuki.power import CHARGING_TIME, RUN_TIME, Power
from rosy_sim.world.world import World

from ..conftest import hall

DOCK = {"x": 10, "y": 10, "theta": 0}


def pass_time(world: World, seconds: float) -> dict[str, tuple[float | int | str, ...]]:
    """What the channels say after so long; the devices take it in one piece, which for them makes no difference."""
    for device in world._timed_devices:
        device.integrate(world, seconds)
    # The world reads its devices anew after each piece of time, also after none.
    world.integrate(0.0)
    return world.channels()


def test_a_full_battery_drains_to_the_dangerous_voltage_in_its_run_time() -> None:
    world = hall()
    assert (world.channels()["Battery"], world.channels()["Charger"]) == ((16.5,), (0,))
    assert pass_time(world, 0.95 * RUN_TIME)["Battery"] == (13.2,)
    assert pass_time(world, RUN_TIME)["Battery"] == (13.0,)


def test_the_voltage_is_rounded_at_every_charge() -> None:
    world = hall()
    power = next(device for device in world._devices if isinstance(device, Power))
    for _ in range(5_000):
        power.integrate(world, RUN_TIME / 4_999)
        volts = 13.2 + (power._charge - 0.05) * (16.5 - 13.2) / (1 - 0.05)
        assert power.values(world)["Battery"] == (round(volts, 1),)


def test_a_battery_charges_in_the_dock_until_it_is_full() -> None:
    world = hall(dock=DOCK, battery=0.5)
    assert (world.channels()["Battery"], world.channels()["Charger"]) == ((14.8,), (6,))
    assert pass_time(world, CHARGING_TIME / 4)["Battery"] == (15.6,)
    full = pass_time(world, CHARGING_TIME)
    assert (full["Battery"], full["Charger"]) == ((16.5,), (2,))


@pytest.mark.parametrize(
    ("dock", "charger"),
    [
        ({"x": 10.04, "y": 10, "theta": 0.3}, 6),
        ({"x": 10.06, "y": 10, "theta": 0}, 0),
        ({"x": 10, "y": 10, "theta": 0.4}, 0),
        ({"x": 10, "y": 10, "theta": 3.14}, 0),
    ],
)
def test_only_a_robot_at_the_contacts_is_docked(dock: dict[str, float], charger: int) -> None:
    assert hall(dock=dock, battery=0.5).channels()["Charger"] == (charger,)
