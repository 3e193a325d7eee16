"""
State of a robot in a recorded run, for display: its pose and what its channels say, from what the program heard and
sent. The counterpart of ``Rosy.Robots.Telemetry``, which tells the same of a robot that drives. Pure.
"""

from __future__ import annotations

from collections.abc import Mapping

import msgspec

from ..robots import ROBOTS
from ..wire.channels import BadMessage, Channel, Values
from ..wire.telemetry import PoseShown, Shown
from ..wire.topics import CHANNELS, ODOMETRY
from ..world.events import VELOCITY_CHANNEL, Command
from ..world.robot import SensorBits
from ..world.world import held_after
from .link_log import publication

__all__ = ["RobotState"]


_SENSED_AT_START: dict[str, Values] = {}
_HELD_AT_START: dict[str, Values] = {}
"""Of all robots, since the robot link has one table of channels; where two differ, as the first of them has it."""
for _robot in reversed(ROBOTS.values()):
    _SENSED_AT_START |= _robot.states(SensorBits())
    _HELD_AT_START |= _robot.outputs


class RobotState:
    """Nothing touches the robot at first, and it is switched on."""

    def __init__(self) -> None:
        self.pose = PoseShown(0.0, 0.0, 0.0)
        self.speed, self.turn = 0.0, 0.0
        self._sensed = dict(_SENSED_AT_START)
        # What lasts of commands.
        self._held = dict(_HELD_AT_START)

    def hear(self, line: bytes) -> None:
        """A line for the program. What does not fit its topic is left out, as the program does."""
        published = publication(line)
        carried = _SENSED.get(published[0], ()) if published is not None else ()
        if published is None or not carried:
            return
        try:
            message = msgspec.json.decode(published[1])
            for channel in carried:
                if channel.is_in(message):
                    self._take(channel, channel.read(message))
        except (BadMessage, msgspec.DecodeError, UnicodeDecodeError, RecursionError):
            return

    def _take(self, channel: Channel, values: Values) -> None:
        if channel is ODOMETRY:
            x, y, theta, self.speed, self.turn = (float(value) for value in values)
            self.pose = PoseShown(x, y, theta)
        elif channel.is_indexed and channel.name in self._sensed:
            place, state = values
            states = list(self._sensed[channel.name])
            states[int(place)] = state
            self._sensed[channel.name] = tuple(states)
        else:
            self._sensed[channel.name] = values

    def obey(self, command: Command) -> None:
        """A command of the program: what lasts is shown."""
        held = self._held.get(command.channel)
        if held is not None:
            self._held[command.channel] = held_after(held, command.values)

    def channels(self) -> dict[str, Shown]:
        """What every channel says now."""
        shown: dict[str, Shown] = {VELOCITY_CHANNEL: [self.speed, self.turn]}
        values: Mapping[str, Values] = {**self._sensed, **self._held}
        shown.update((name, list(held)) for name, held in values.items())
        return shown


_SENSED: dict[str, tuple[Channel, ...]] = {
    topic: tuple(c for c in CHANNELS.values() if c.topic == topic and not c.is_command)
    for topic in {c.topic for c in CHANNELS.values() if not c.is_command}
}
"""The channels of each topic that the robot publishes."""
