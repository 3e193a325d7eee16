"""
The command ``./rosy robots``: the robots nearby on ROS 2, a line for each with its kind, its address, Zenoh where it
speaks that in place of DDS, and its battery.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Sequence
from pathlib import Path

from ..errors import BadInput, RobotMissing, RosyError
from ..ownership.robot_configuration import check_address
from ..ownership.robot_discovery import discover_robots
from ..ros2.battery import Battery
from ..ros2.nearby_robots import NearbyRobot
from ..ros2.robot_bridge import check_installed
from ..ros2.transports.address import parse_ros2_address
from ..sentences.sentence import Sentence, tr
from ..sentences.wording import in_terminal

__all__ = ["list_robots"]


def list_robots(
    robot_executable: Path | None,
    addresses: Sequence[str],
    seconds: float,
    print_text: Callable[[str], None],
    is_enough: Callable[[Sequence[NearbyRobot]], bool] = lambda _robots: False,
) -> int:
    """
    Print what is discovered in so many seconds, or as soon as it is enough; returns the exit status.

    Raises:
        BadInput: an address is none of ROS 2, or rosy-robot is not built.
        RobotMissing: there is no robot.
    """
    for address in addresses:
        if parse_ros2_address(address) is None:
            raise BadInput(
                tr(
                    "Robots are discovered on ROS 2, at addresses such as {example}; {address} is none.",
                    example="ros2:0",
                    address=address,
                )
            )
        check_address(robot_executable, address)
    check_installed()
    robots = asyncio.run(_discovered(addresses, seconds, is_enough))
    if not robots:
        raise _none(addresses)
    rows = [(robot.title, robot.bare, "Zenoh" if robot.zenoh else "", _battery_text(robot.battery)) for robot in robots]
    # A column that is empty takes no place.
    widths = [max(len(row[column]) for row in rows) for column in range(4)]
    for row in rows:
        print_text("  ".join(f"{text:{width}}" for text, width in zip(row, widths, strict=True) if width).rstrip())
    for robot in robots:
        if robot.several:
            print_text(in_terminal(_several(robot)))
    return 0


def _several(robot: NearbyRobot) -> Sentence:
    return tr(
        "Several robots answer on the same topics at {address}, and one program drives all of them: "
        "give each a namespace.",
        address=robot.bare,
    )


async def _discovered(
    addresses: Sequence[str], seconds: float, is_enough: Callable[[Sequence[NearbyRobot]], bool]
) -> Sequence[NearbyRobot]:
    found: Sequence[NearbyRobot] = ()
    enough = asyncio.Event()

    def show(robots: Sequence[NearbyRobot]) -> None:
        nonlocal found
        found = robots
        if is_enough(robots):
            enough.set()

    discovery = asyncio.create_task(discover_robots(addresses, show))
    with contextlib.suppress(TimeoutError):
        async with asyncio.timeout(seconds):
            await enough.wait()
    discovery.cancel()
    with contextlib.suppress(asyncio.CancelledError):
        await discovery
    return found


def _none(addresses: Sequence[str]) -> RosyError:
    shown = ", ".join(addresses)
    return RobotMissing(
        shown,
        tr(
            "No robot is found at {address}: is it on, in the same network, and in this domain of ROS 2?", address=shown
        ),
    )


def _battery_text(battery: Battery) -> str:
    if battery.charge is not None:
        return f"{battery.charge} %"
    return "" if battery.volts is None else f"{battery.volts:.1f} V"
