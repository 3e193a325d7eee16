"""
What can go wrong outside a learner's program, as a tree::

    RosyError                 ends a command with one sentence and an exit status
    ├── BadInput              a file, a world or an option that cannot be used      exit 1
    ├── WorkerMissing         no worker has been built                              exit 2
    ├── WorkerLost            the worker died while it was needed                   exit 2
    └── WorkerRefused         the worker says our request was wrong                 exit 2

Problems of the program itself are values (``wire.problem.Problem``), never exceptions; a room that is no
room is ``world.arena.ArenaError``; a program that breaks the link is ``wire.link.LinkError``.
"""

from __future__ import annotations

__all__ = ["BadInput", "RosyError", "WorkerLost", "WorkerMissing", "WorkerRefused"]


class RosyError(Exception):
    """One sentence for the person at the keyboard."""

    exit_status = 2


class BadInput(RosyError):
    """A file, a world or an option that cannot be used."""

    exit_status = 1


class WorkerMissing(RosyError):
    """No worker has been built."""

    def __init__(self) -> None:
        super().__init__("The compiler part of Rosy is not built yet; ./rosy start builds it.")


class WorkerLost(RosyError):
    """The worker died while it was needed."""

    def __init__(self, detail: str = "") -> None:
        super().__init__(
            f"The compiler part of Rosy stopped unexpectedly{f' ({detail})' if detail else ''}; try again."
        )


class WorkerRefused(RosyError):
    """The worker says our request was wrong."""

    def __init__(self, message: str) -> None:
        super().__init__(f"The compiler part of Rosy did not accept the request: {message}")
