"""
``./rosy estop [--robot ADDRESS]``: the emergency stop from any terminal.

Needs nothing but Python and these three files: whoever presses it does not wait for anything to be built or started.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from .drivers import emergency_stop
from .errors import RosyError

__all__ = ["main"]


def main(arguments: Sequence[str]) -> int:
    """Stop; returns the exit status."""
    match list(arguments):
        case []:
            address = None
        case ["--robot", named]:
            address = named
        case [word] if word.startswith("--robot="):
            address = word.removeprefix("--robot=")
        case _:
            print("rosy estop: it takes nothing, or --robot and an address.", file=sys.stderr)
            # In doubt everything stops.
            address = None
    try:
        for driver in emergency_stop(address):
            print(f"Stopped the robot at {driver.address}.")
    except RosyError as error:
        print(f"rosy: {error}", file=sys.stderr)
        return error.exit_status
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
