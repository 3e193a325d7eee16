"""
What can go wrong outside a learner's program, as a tree::

    RosyError                 ends a command with one sentence and an exit status
    ├── BadInput              a file, a world or an option that cannot be used      exit 1
    ├── OutputFailed          standard output cannot be written                     exit 1
    ├── RobotMissing          no robot answers at an address                        exit 2
    ├── WorkerMissing         no worker has been built                              exit 2
    ├── WorkerFailed          a worker cannot start on this computer                exit 2
    ├── WorkerLost            the worker died while it was needed                   exit 2
    └── WorkerRefused         the worker says our request was wrong                 exit 2

Problems of the program itself are values (``wire.problem.Problem``), never exceptions; a room that is no
room is ``world.arena.ArenaError``; a program that breaks the link is ``wire.link.LinkError``.
"""

from __future__ import annotations

from .sentences.sentence import Sentence, SentenceError, tr

__all__ = [
    "BadInput",
    "OutputFailed",
    "RobotMissing",
    "RosyError",
    "WorkerFailed",
    "WorkerLost",
    "WorkerMissing",
    "WorkerRefused",
]


class RosyError(SentenceError):
    """One sentence for the person at the keyboard."""

    exit_status = 2


class BadInput(RosyError):
    """A file, a world or an option that cannot be used."""

    exit_status = 1


class OutputFailed(RosyError):
    """Standard output cannot be written: the disk is full, or the reader has closed its end."""

    exit_status = 1

    def __init__(self, cause: OSError) -> None:
        super().__init__(tr("The output cannot be written: {why}.", why=cause.strerror or ""))
        self.reader_left = isinstance(cause, BrokenPipeError)


class RobotMissing(RosyError):
    """No robot answers at an address."""

    def __init__(self, address: str, sentence: Sentence | None = None) -> None:
        super().__init__(
            sentence or tr("No robot answers at {address}; is it on, and does its server run?", address=address)
        )


class WorkerMissing(RosyError):
    """No worker has been built."""

    def __init__(self) -> None:
        super().__init__(tr("The compiler part of Rosy is not built yet; ./rosy start builds it."))


class WorkerFailed(RosyError):
    """A worker cannot start on this computer; ``why`` is what it, its sandbox or the system reported."""

    def __init__(self, why: Sentence) -> None:
        super().__init__(
            tr("The compiler part of Rosy cannot start on this computer, so no program can run: {why}", why=why)
        )


class WorkerLost(RosyError):
    """The worker died while it was needed; ``detail`` is technical."""

    def __init__(self, detail: Sentence | str = "") -> None:
        super().__init__(
            tr("The compiler part of Rosy stopped unexpectedly ({detail}); try again.", detail=detail)
            if detail
            else tr("The compiler part of Rosy stopped unexpectedly; try again.")
        )


class WorkerRefused(RosyError):
    """The worker says our request was wrong."""

    def __init__(self, message: str) -> None:
        super().__init__(tr("The compiler part of Rosy did not accept the request: {message}", message=message))
