"""
Which robots pages may drive, as the person says who starts the service: ``--robot NAME=ADDRESS`` and ``--robots FILE``.
"""

from __future__ import annotations

import subprocess
from pathlib import Path

import msgspec

from .drivers import way
from .errors import BadInput

__all__ = ["configured", "usable"]

_MAX_NAME = 40
"""Characters of a robot's name."""


def configured(speaker: Path | None, given: list[str], file: Path | None) -> dict[str, str]:
    """
    Names and addresses, those of the file first.

    Raises:
        BadInput: one of them cannot be used.
    """
    pairs = _in_file(file) if file is not None else []
    for text in given:
        name, equals, address = text.partition("=")
        # An address has an equals sign of its own in its options.
        if not equals or "://" in name or name.startswith("serial:"):
            raise BadInput(f"--robot takes a name and an address, such as --robot kitchen={text}.")
        pairs.append((name.strip(), address))
    robots: dict[str, str] = {}
    for name, address in pairs:
        if not name or len(name) > _MAX_NAME:
            raise BadInput(f"A robot's name has 1 to {_MAX_NAME} characters; {name!r} does not.")
        if name in robots or way(address) in map(way, robots.values()):
            raise BadInput(f"The robot {name} is there twice; give each robot one name.")
        usable(speaker, address)
        robots[name] = address
    return robots


def _in_file(file: Path) -> list[tuple[str, str]]:
    try:
        return list(msgspec.json.decode(file.read_bytes(), type=dict[str, str]).items())
    except OSError as error:
        raise BadInput(f"{file} cannot be read: {error.strerror}.") from error
    except msgspec.DecodeError as error:
        raise BadInput(f'{file} is no list of robots; it looks like {{"kitchen": "ws://HOST:9090"}}.') from error


def usable(speaker: Path | None, address: str) -> Path:
    """
    What speaks to the robot at an address; rosy-robot knows best what an address is.

    Raises:
        BadInput: this is none, or rosy-robot is not built.
    """
    if speaker is None:
        raise BadInput("The part of Rosy that speaks to robots is not built yet; ./rosy run --robot builds it.")
    looked = subprocess.run([str(speaker), "check", address], capture_output=True, text=True, check=False)
    if looked.returncode != 0:
        raise BadInput(looked.stderr.strip().removeprefix("rosy: ").rstrip(".") + ".")
    return speaker
