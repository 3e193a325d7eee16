"""``python -m rosy_sim.bench simulator [--pages N] [--seconds S]``."""

from __future__ import annotations

import argparse
import sys

from ..config import discover
from ..errors import RosyError
from . import lockstep, pages, world

__all__ = ["main"]


def main() -> int:
    """Print the tables."""
    parser = argparse.ArgumentParser(prog="python -m rosy_sim.bench")
    parser.add_argument("name", choices=["simulator"])
    parser.add_argument("--pages", type=int, nargs="*", default=[20, 60, 150])
    parser.add_argument("--seconds", type=float, default=10.0)
    options = parser.parse_args()
    try:
        config = discover()
        world.report()
        lockstep.report(config)
        for count in options.pages:
            pages.report(config, count, options.seconds)
    except RosyError as error:
        print(f"rosy: {error}", file=sys.stderr)
        return error.exit_status
    return 0


sys.exit(main())
