"""
Robot configuration: the robots that pages may drive, from the options ``--robot NAME=ADDRESS`` and ``--robots FILE``,
where robots are discovered, from ``--robot ros2:DOMAIN``, and where the simulated one is on ROS 2, from ``--ros2``.
"""

from __future__ import annotations

import subprocess
from pathlib import Path

import msgspec

from ..errors import BadInput
from ..files import read_text
from ..ros2.robot_bridge import check_installed
from ..ros2.transports.address import parse_ros2_address
from ..sentences.sentence import tr, verbatim
from .driver_locks import canonical_address

__all__ = ["check_address", "read_nearby_addresses", "read_robot_configuration", "read_simulator_address"]

_MAX_DOMAIN = 232
"""Of ROS 2, whose ports are those of UDP (DDSI-RTPS 2.5, 9.6.2.3)."""

_MAX_NAME = 40
"""Characters of a robot's name."""


def read_robot_configuration(robot_executable: Path | None, given: list[str], file: Path | None) -> dict[str, str]:
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
            raise BadInput(tr("--robot takes a name and an address, such as --robot kitchen={text}.", text=text))
        pairs.append((name.strip(), address))
    robots: dict[str, str] = {}
    for name, address in pairs:
        if not name or len(name) > _MAX_NAME:
            raise BadInput(
                tr("A robot's name has 1 to {most} characters; {name} does not.", most=_MAX_NAME, name=repr(name))
            )
        if name in robots or canonical_address(address) in map(canonical_address, robots.values()):
            raise BadInput(tr("The robot {name} is there twice; give each robot one name.", name=name))
        check_address(robot_executable, address)
        robots[name] = address
    return robots


def read_nearby_addresses(robot_executable: Path | None, given: list[str]) -> tuple[list[str], tuple[str, ...]]:
    """
    The options that name a robot, and those that are addresses of ROS 2 without a name: all robots there are meant.

    Raises:
        BadInput: one of these addresses cannot be used.
    """
    nearby = [text for text in given if parse_ros2_address(text) is not None]
    for address in nearby:
        check_address(robot_executable, address)
        check_installed()
    return [text for text in given if text not in nearby], tuple(nearby)


def _in_file(file: Path) -> list[tuple[str, str]]:
    text = read_text(file, tr("list of robots"))
    try:
        return list(msgspec.json.decode(text, type=dict[str, str]).items())
    except msgspec.DecodeError as error:
        raise BadInput(
            tr(
                "{file} is no list of robots; it looks like {example}.",
                file=file,
                example='{"kitchen": "ws://HOST:9090"}',
            )
        ) from error


def check_address(robot_executable: Path | None, address: str) -> Path:
    """
    What speaks to the robot at an address; rosy-robot knows best what an address is.

    Raises:
        BadInput: this is none, or rosy-robot is not built.
    """
    if robot_executable is None:
        raise BadInput(tr("The part of Rosy that speaks to robots is not built yet; ./rosy run --robot builds it."))
    looked = subprocess.run([str(robot_executable), "check", address], capture_output=True, text=True, check=False)
    if looked.returncode != 0:
        # rosy-robot says it in the language of this machine's terminals.
        raise BadInput(verbatim(looked.stderr.strip().removeprefix("rosy: ").rstrip(".") + "."))
    return robot_executable


def read_simulator_address(given: str) -> str:
    """
    Where the simulated robot is on ROS 2: a domain, or an address such as ``ros2:7/lab``.

    Raises:
        BadInput: there is no such place, or this computer does not speak ROS 2.
    """
    place = parse_ros2_address(given if given.startswith("ros2:") else f"ros2:{given}")
    if place is None or place.domain > _MAX_DOMAIN or place.options:
        raise BadInput(
            tr(
                "--ros2 takes a domain of ROS 2, 0 to {most}, or an address such as ros2:7/lab; {text} is neither.",
                most=_MAX_DOMAIN,
                text=given,
            )
        )
    check_installed("./rosy start --ros2")
    return place.text()
