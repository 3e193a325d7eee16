"""How a run can end without the program's own word, as problems a learner can read."""

from __future__ import annotations

import msgspec

from .wire.problem import Problem, problem
from .wire.worker import Gone

__all__ = ["broken_link", "died", "lost_robot", "room_full", "stuck", "too_much", "worker_lost"]

_SIGXCPU, _SIGKILL, _SIGSEGV, _SIGSYS = 24, 9, 11, 31


def stuck(function: str | None, limit: float, time: float) -> Problem:
    """A step took longer than ``limit`` s of wall-clock time."""
    who = f"`{function}`" if function else "The program"
    return problem(
        "stuck",
        f"{who} was still busy after {limit:g} seconds, so the robot was stopped.",
        "Look for something in it that never comes to an end; a loop of tasks needs a `wait`, so that time can pass.",
        function=function,
        time=time,
    )


def died(gone: Gone | None, time: float) -> Problem:
    """The program closed the link without a word."""
    if gone is not None and gone.problem is not None:
        return msgspec.structs.replace(gone.problem, time=time)
    function = gone.firing if gone is not None else None
    who = (
        f"The program stopped while `{function}` was at work" if function else "The program stopped without saying why"
    )
    return problem(
        "died",
        f"{who}.",
        "Perhaps it used too much memory or time; run it again, or make it smaller.",
        function=function,
        time=time,
    )


def broken_link(detail: str, time: float) -> Problem:
    """The program sent what the protocol does not allow; ``detail`` is for the curious."""
    return Problem(
        severity="error",
        kind="broken-link",
        message="The program sent something the robot does not understand, so the robot was stopped.",
        hint="Run it again; if that does not help, use fewer commands at once.",
        ghc=detail,
        time=time,
    )


def too_much(detail: str, time: float) -> Problem:
    """The program sent more than the robot, or anybody, can take; ``detail`` is for the curious."""
    return Problem(
        severity="error",
        kind="too-much",
        message="The program sent far too much at once, so the robot was stopped.",
        hint="Look for something in it that sends without end.",
        ghc=detail,
        time=time,
    )


def worker_lost(time: float | None = None) -> Problem:
    """The worker died with the program in it."""
    return problem(
        "worker-lost", "The part of Rosy that runs programs had to start again.", "Press Run once more.", time=time
    )


def lost_robot(time: float) -> Problem:
    """The connection to a real robot broke."""
    return problem(
        "lost-robot",
        "The robot no longer answers.",
        "It stops by itself; look at its battery and its network.",
        time=time,
    )


def room_full(limit: int) -> Problem:
    """No more pages."""
    return problem(
        "room-full",
        f"All {limit} places in this class are taken.",
        "Your program is kept, and this page comes in as soon as somebody leaves.",
    )
