"""One world without a program: sense, command, integrate, as many steps a second as it gives."""

from __future__ import annotations

import statistics
import time

from ..robots import robot_in
from ..run.steps.lockstep import Lockstep
from ..world.arena import Arena, read_arena
from ..world.events import velocity
from ..world.time_step import STEP
from ..world.world import World

__all__ = ["report"]

_STEPS = 20_000
_ROUNDS = 5

_BOXES = [{"x": 11 + 0.5 * i, "y": 10 + 0.02 * i, "w": 0.3, "h": 0.3, "movable": True} for i in range(10)]

_ROOMS: dict[str, dict[str, object]] = {
    "driving freely": {"size": [100, 100], "start": {"x": 50, "y": 50}},
    "against a wall": {"size": [5, 4], "start": {"x": 4.7, "y": 2}},
    "pushing ten boxes": {"size": [20, 20], "start": {"x": 10, "y": 10}, "boxes": _BOXES},
}


def report() -> None:
    """Print a row per room."""
    for name, value in _ROOMS.items():
        arena = read_arena(value)
        rates = [_STEPS / _world(arena) for _ in range(_ROUNDS)]
        _row(f"world alone, {name}", rates)
    arena = read_arena(_ROOMS["driving freely"])
    _row("world and robot link, program that answers at once", [_STEPS / _link(arena) for _ in range(_ROUNDS)])


def _row(name: str, rates: list[float]) -> None:
    rate = statistics.median(rates)
    print(f"  {name:<56} {rate:>9,.0f} steps/s   {rate * STEP:>7,.0f} x real time")


def _world(arena: Arena) -> float:
    world = World(arena, robot_in(arena))
    began = time.perf_counter()
    for step in range(_STEPS):
        world.sense()
        world.odometry()
        if step % 5 == 0:
            world.command(velocity(0.5, 0.1))
        world.integrate()
    return time.perf_counter() - began


def _link(arena: Arena) -> float:
    lockstep = Lockstep(World(arena, robot_in(arena)), 1)
    lockstep.feed(b'{"op":"ready"}\n')
    command = (
        b'{"op":"publish","topic":"/mobile_base/commands/velocity","msg":{"linear":{"x":0.5},"angular":{"z":0.1}}}\n'
    )
    began = time.perf_counter()
    for step in range(_STEPS):
        lockstep.sense()
        settled = b'{"op":"settled","step":%d,"fired":["move"]}\n' % step
        lockstep.feed(command + settled if step % 5 == 0 else settled)
        lockstep.integrate()
    return time.perf_counter() - began
