"""Values of the options of ``run``: each is checked, and what was not given has its default."""

from __future__ import annotations

import argparse
import math
import random

from ..errors import BadInput
from ..programs.program_file import ProgramFile
from ..robots import ROBOTS, robot_names
from ..run.steps.velocity_guard import SafetySettings
from ..sentences.sentence import Sentence, tr
from ..world.arena import Arena
from ..worlds.gallery import DEFAULT_WORLD, load_world, named_world, usable_arena

__all__ = [
    "DEFAULT_SECONDS",
    "MAX_SECONDS",
    "arena_of",
    "moment_of",
    "safety_of",
    "safety_options",
    "seconds_of",
    "seed_of",
    "speed_of",
    "with_options",
]

DEFAULT_SECONDS = 60.0
"""How long `run` simulates when neither `--seconds` nor the program says, s."""

MAX_SECONDS = 7 * 24 * 3600.0
"""Longest run, s."""


def seconds_of(wanted: float | None) -> float:
    if wanted is None:
        return DEFAULT_SECONDS
    if not 0 <= wanted <= MAX_SECONDS:
        raise BadInput(tr("--seconds must be between 0 and {most}.", most=MAX_SECONDS))
    return wanted


def speed_of(wanted: str | None) -> float | None:
    if wanted is None or wanted == "max":
        return None
    try:
        speed = float(wanted)
    except ValueError:
        speed = math.nan
    if not 0.01 <= speed <= 1000:
        raise BadInput(tr("--speed must be a number between 0.01 and 1000, or max."))
    return speed


def seed_of(options: argparse.Namespace) -> int:
    seed: int | None = options.seed
    return seed if seed is not None else random.SystemRandom().randrange(2**31)


def moment_of(wanted: str | None) -> float | None:
    """The time that is to be explained, s; None for the last command."""
    if not wanted:
        return None
    try:
        moment = float(wanted)
    except ValueError:
        moment = math.nan
    if not 0 <= moment <= MAX_SECONDS:
        raise BadInput(tr("--explain stands at the end, or takes a time in seconds: --explain 3.4."))
    return moment


def is_simulated(options: argparse.Namespace) -> bool:
    """Whether the program drives in the simulator: ``--robot`` is absent, or the name of a robot and no address."""
    return options.robot is None or ":" not in options.robot


def arena_of(program: ProgramFile, options: argparse.Namespace) -> Arena:
    """The room of a run, with the robot that the options name, or else its own."""
    json: object
    where: str | Sentence
    if options.world is not None:
        json, where = load_world(options.world), options.world
    elif program.world is None or isinstance(program.world, str):
        where = program.world or DEFAULT_WORLD
        json = named_world(where)
    else:
        json, where = program.world, tr("The world in {file}", file=options.file)
    if options.robot is not None:
        if options.robot not in ROBOTS:
            raise BadInput(
                tr(
                    "The simulator has no robot {name}; it has {names}. "
                    "A real robot has an address, such as ws://HOST:9090.",
                    name=repr(options.robot),
                    names=robot_names(),
                )
            )
        if isinstance(json, dict):
            json = {**json, "robot": options.robot}
    return usable_arena(json, where)


def safety_options(options: argparse.Namespace) -> dict[str, str | float]:
    """The options about safety that were given, named as in the address of a robot."""
    given = {name: getattr(options, name) for name in ("safety", "max_speed", "max_turn")}
    for name in ("max_speed", "max_turn"):
        if given[name] is not None and not 0 <= given[name] < math.inf:
            raise BadInput(tr("--{name} must be a number from 0.", name=name.replace("_", "-")))
    return {name: value for name, value in given.items() if value is not None}


def safety_of(options: argparse.Namespace) -> SafetySettings:
    """Safety rules and limits of the simulated robot: off, unless one of the options is given."""
    given = safety_options(options)
    return SafetySettings(given.get("safety", "on" if given else "off") == "on", options.max_speed, options.max_turn)


def with_options(address: str, given: dict[str, str | float]) -> str:
    """The address of a robot with further options, which come after its own."""
    if not given:
        return address
    return address + ("&" if "?" in address else "?") + "&".join(f"{name}={value}" for name, value in given.items())
