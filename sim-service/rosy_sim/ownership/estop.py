"""
``./rosy estop [--robot ADDRESS]``: the emergency stop from any terminal.

Neither it nor what it imports needs more than the standard library: it works before anything is installed or built.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from ..errors import RosyError
from ..sentences.sentence import tr
from ..sentences.terminal_text import neutralize_line
from ..sentences.wording import in_terminal
from .driver_locks import emergency_stop

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
            print(f"rosy estop: {in_terminal(tr('it takes nothing, or --robot and an address.'))}", file=sys.stderr)
            # Wrong options stop all robots.
            address = None
    try:
        for driver in emergency_stop(address):
            stopped = tr("Stopped the robot at {address}.", address=neutralize_line(driver.address))
            print(in_terminal(stopped))
    except RosyError as error:
        print(f"rosy: {neutralize_line(in_terminal(error.sentence))}", file=sys.stderr)
        return error.exit_status
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
