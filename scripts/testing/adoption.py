"""
Process that runs a command and adopts the processes that the command leaves behind, so that their processor time is counted.

In: the command as arguments, `--background` before it gives it only the processor time that others leave. Out: its exit status,
128 + N when signal N ended it. A browser or a service that is started detached belongs to no process that waits for it: its time would
be in no account. As a "child subreaper" (prctl(2)) this process becomes the parent of such processes and waits for them, and the kernel
adds their time to its own. Processes that still run when the command ends are neither waited for nor counted.
"""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import time
from collections.abc import Sequence
from pathlib import Path

__all__ = ["BACKGROUND", "BACKGROUND_NICE", "lower_priority", "run"]

BACKGROUND = "--background"

PR_SET_CHILD_SUBREAPER = 36
"""linux/prctl.h."""


BACKGROUND_NICE = 10
"""Nice value of the background: a tenth of the share of others where they want all of a processor, so that no test in it waits for its limit of time."""


def lower_priority() -> None:
    """
    Gives this process and all that it starts a low priority. Linux shares a processor out between sessions first, where
    it forms a group of each (sched(7), autogroups), and only within them by nice values: both are set.
    """
    os.nice(BACKGROUND_NICE)
    while True:
        try:
            Path("/proc/self/autogroup").write_text(str(BACKGROUND_NICE))
        except BlockingIOError:
            # Linux takes ten such requests of users per second.
            time.sleep(0.1)
        except OSError:
            # It forms no groups.
            return
        else:
            return


def run(command: Sequence[str]) -> int:
    """Runs the command to its end."""
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    # A termination is sent to the whole group: the command gets it as well, and its end is waited for.
    signal.signal(signal.SIGTERM, lambda _number, _frame: None)
    child = os.posix_spawnp(command[0], list(command), os.environ)
    while True:
        pid, status = os.wait()
        if pid == child:
            break
    while _reaps():
        pass
    code = os.waitstatus_to_exitcode(status)
    return code if code >= 0 else 128 - code


def _reaps() -> bool:
    """Takes one process that has ended; whether there was one."""
    try:
        return os.waitpid(-1, os.WNOHANG)[0] != 0
    except ChildProcessError:
        return False


if __name__ == "__main__":
    words = sys.argv[1:]
    if words[0] == BACKGROUND:
        words = words[1:]
        lower_priority()
    try:
        sys.exit(run(words))
    except OSError as error:
        print(f"{words[0]}: {error.strerror}", file=sys.stderr)
        sys.exit(127)
