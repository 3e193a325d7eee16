"""
``python -m rosy_sim.bench simulator [--pages N ...] [--seconds S] [--profile]``, ``recovery [--rounds N]``,
``memory``, ``day [--pupils N] [--rounds HOURS]``, ``class [--pupils N] [--seconds S]``, ``recording [--seconds S]``,
``attacks [--seconds S] [--only WORDS] [--small]``, and
``cluster [--programs N] [--rooms N] [--pupils N] [--seconds S] [--rounds N]``.
"""

from __future__ import annotations

import argparse
import asyncio
import sys

from ..config import discover
from ..errors import RosyError
from . import class_board, class_day, lockstep, pages, previews, recording, recovery, resting, world
from .attacks import under_attack
from .cluster import report as cluster
from .programs import MOVE, PATROL, SPEED_UP

__all__ = ["main"]

_ON_PAGES = {"a task with pauses": PATROL, "the default rate": MOVE, "a function that fires at 50 Hz": SPEED_UP}
"""Programs of many pages, by what they are."""


def main() -> int:
    """Print the tables."""
    parser = argparse.ArgumentParser(prog="python -m rosy_sim.bench")
    parser.add_argument(
        "name", choices=["simulator", "recovery", "class", "attacks", "recording", "cluster", "memory", "day"]
    )
    parser.add_argument("--pages", type=int, nargs="*", default=[50, 100, 150, 200])
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--runs", type=int, help="programs at once; the other pages wait (default: all drive)")
    parser.add_argument("--only", default="", help="attacks whose titles have this in them")
    parser.add_argument("--small", action="store_true", help="attacks of few pages on few, each once")
    parser.add_argument("--profile", action="store_true", help="say where the service's time goes")
    parser.add_argument("--pupils", type=int, default=30, help="of the class")
    parser.add_argument("--rounds", type=int, default=3, help="deaths of each kind, windows of time, or hours")
    parser.add_argument("--programs", type=int, default=40, help="that a cluster tests")
    parser.add_argument("--rooms", type=int, default=50, help="in which each of them is tested")
    options = parser.parse_args()
    try:
        if options.name == "memory":
            return resting.report()
        config = discover()
        if options.name == "recovery":
            asyncio.run(recovery.measure(config, options.rounds))
            return 0
        if options.name == "recording":
            recording.report(config, options.pages, options.seconds)
            return 0
        if options.name == "attacks":
            return 0 if under_attack.report(config, options.seconds, options.only, options.small) else 1
        if options.name == "cluster":
            return cluster.report(options)
        if options.name == "day":
            class_day.report(config, options.pupils, options.rounds)
            return 0
        if options.name == "class":
            late = class_board.report(config, options.pupils, options.seconds)
            print(f"  in time (99 % of the steps less than {pages.IN_TIME * 1e3:.0f} ms late): {late < pages.IN_TIME}")
            return 0
        world.report()
        lockstep.report(config)
        previews.report(config)
        for name, program in _ON_PAGES.items():
            print(f"  many pages, {name}:")
            held = 0
            for count in options.pages:
                late = pages.report(config, count, options.runs or count, options.seconds, options.profile, program)
                held = max(held, count) if late < pages.IN_TIME else held
            bar = f"99 % of the steps less than {pages.IN_TIME * 1e3:.0f} ms late"
            print(f"  in time ({bar}) with {name}: {held} pages; goal 200")
    except RosyError as error:
        print(f"rosy: {error}", file=sys.stderr)
        return error.exit_status
    return 0


sys.exit(main())
