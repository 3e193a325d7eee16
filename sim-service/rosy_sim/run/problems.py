"""Problems of runs that end without a message of the program, in sentences for learners."""

from __future__ import annotations

import msgspec

from ..errors import WorkerFailed
from ..robot_description import description, lacking
from ..sentences.sentence import tr
from ..wire.problem import Problem, problem
from ..wire.worker import Gone
from ..world.world import World

__all__ = [
    "broken_link",
    "died",
    "lost_robot",
    "missing_parts",
    "no_place_beside",
    "place_needed",
    "service_full",
    "stuck",
    "too_much_output",
    "worker_lost",
    "worker_problem",
]

_SIGXCPU, _SIGKILL, _SIGSEGV, _SIGSYS = 24, 9, 11, 31


def stuck(function: str | None, limit: float, time: float) -> Problem:
    """A step took longer than ``limit`` s of wall-clock time."""
    return problem(
        "stuck",
        tr(
            "`{function}` was still busy after {limit} seconds, so the robot was stopped.",
            function=function,
            limit=limit,
        )
        if function
        else tr("The program was still busy after {limit} seconds, so the robot was stopped.", limit=limit),
        tr(
            "Look for something in it that never comes to an end; "
            "a loop of tasks needs a `wait`, so that time can pass."
        ),
        function=function,
        time=time,
    )


def died(gone: Gone | None, time: float) -> Problem:
    """The program closed the link without `ended`."""
    if gone is not None and gone.problem is not None:
        return msgspec.structs.replace(gone.problem, time=time)
    function = gone.firing if gone is not None else None
    return problem(
        "died",
        tr("The program stopped while `{function}` was at work.", function=function)
        if function
        else tr("The program stopped without saying why."),
        tr("Perhaps it used too much memory or time; run it again, or make it smaller."),
        function=function,
        time=time,
    )


def broken_link(detail: str, time: float) -> Problem:
    """The program broke the protocol; ``detail`` is technical."""
    return problem(
        "broken-link",
        tr("The program sent something the robot does not understand, so the robot was stopped."),
        tr("Run it again; if that does not help, use fewer commands at once."),
        ghc=detail,
        time=time,
    )


def too_much_output(detail: str, time: float) -> Problem:
    """The program exceeded a limit of the protocol; ``detail`` is technical."""
    return problem(
        "too-much",
        tr("The program sent far too much at once, so the robot was stopped."),
        tr("Look for something in it that sends without end."),
        ghc=detail,
        time=time,
    )


def worker_lost(time: float | None = None) -> Problem:
    """The worker died with the program in it."""
    return problem(
        "worker-lost",
        tr("The part of Rosy that runs programs had to start again."),
        tr("Press Run once more."),
        time=time,
    )


def worker_problem(error: BaseException | None = None) -> Problem:
    """Why a program could not run, from the failure of a request to the worker."""
    if not isinstance(error, WorkerFailed):
        return worker_lost()
    return problem("worker-failed", error.sentence, tr("Tell the person who looks after this computer."))


def lost_robot(time: float) -> Problem:
    """The connection to a real robot broke."""
    return problem(
        "lost-robot",
        tr("The robot no longer answers."),
        tr("It stops by itself; look at its battery and its network."),
        time=time,
    )


def missing_parts(world: World, uses: list[str]) -> list[Problem]:
    """Why a program cannot run in a room whose robot lacks a part; none when it can."""
    robot = world.robot.name
    missing = lacking(robot, uses, lambda _option: True)
    if missing:
        return [
            problem(
                "missing-part",
                tr("The robot ({robot}) has no {parts}.", robot=description(robot)["title"], parts=", ".join(missing)),
                tr("Take out the functions that use it, or choose another robot."),
            )
        ]
    missing = world.missing_parts(uses)
    if not missing:
        return []
    return [
        problem(
            "missing-part",
            tr("The robot in this room has no {parts}.", parts=", ".join(missing)),
            tr("Give it a distance sensor in the room's settings, or take out the functions that use it."),
        )
    ]


def place_needed() -> Problem:
    """Another client has no place to run."""
    return problem(
        "place-needed",
        tr("This program was stopped, because another person needed a place to run."),
        tr("Programs that did nothing for a while are stopped first. Press Run to start it again."),
    )


def no_place_beside() -> Problem:
    """All places for programs are taken, and a further robot of a run does not wait for one."""
    return problem(
        "no-place",
        tr("All places for programs are taken at the moment, so this robot stands still."),
        tr("Use fewer robots, or press Run again when fewer programs run."),
    )


def address_full(limit: int) -> Problem:
    """A client address has as many pages as it may."""
    return problem(
        "room-full",
        tr("There are {limit} pages open from here, the most that there may be.", limit=limit),
        tr("Your program is kept, and this page joins as soon as one of them is closed."),
    )


def service_full(limit: int) -> Problem:
    """The service has as many pages as it may."""
    return problem(
        "room-full",
        tr("All {limit} places in this class are taken.", limit=limit),
        tr("Your program is kept, and this page joins as soon as a place is free."),
    )
