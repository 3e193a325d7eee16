"""
Process that discovers robots on ROS 2: ``python -m rosy_sim.ros2.discovery_process ADDRESS``.

Out, on standard output: a line of JSON, the robots at the address with their batteries, now and whenever they change.
It ends when its standard input does. It sends nothing but what discovery needs, and drives no robot.
"""

from __future__ import annotations

import select
import sys

from .battery import Battery, BatteryTopic, battery_topic, read_battery
from .nearby_robots import NearbyRobot, encode_robots
from .profiles import FoundRobot, are_several, find_robots, hosts_of, title_of
from .robot_bridge import robot_address
from .transports.address import Ros2Address, is_router, parse_ros2_address
from .transports.dds_messages import BadMessage, to_json
from .transports.dds_names import dds_topic
from .transports.graph import Graph, Quality
from .transports.open_transport import open_transport
from .transports.transport import Reader, Transport

__all__: list[str] = []

_PERIOD = 0.5
"""Seconds between two looks."""


class _Batteries:
    """Reads topics of batteries, each in the quality in which it is offered."""

    def __init__(self, transport: Transport) -> None:
        self._transport = transport
        self._readers: dict[BatteryTopic, tuple[Quality, Reader]] = {}
        self._last: dict[BatteryTopic, Battery] = {}

    def of(self, robot: FoundRobot, graph: Graph) -> Battery:
        """The last one that a robot has reported. Where robots share a topic it is not known whose it is."""
        topic = battery_topic(robot.kind, robot.namespace)
        is_shared = robot.host is not None or are_several(robot, graph.processes())
        if topic is None or is_shared or graph.topics().get(topic.name) != topic.type:
            return Battery()
        quality = graph.reading_quality(dds_topic(topic.name))
        known = self._readers.get(topic)
        if known is None or known[0] != quality:
            if known is not None:
                known[1].close()
            reader = self._transport.reader(dds_topic(topic.name), topic.type, quality, lambda: None)
            self._readers[topic] = known = (quality, reader)
        for message in known[1].take():
            # One that cannot be read says nothing of the battery.
            if not isinstance(message, BadMessage):
                self._last[topic] = read_battery(topic, to_json(topic.type, message))
        return self._last.get(topic, Battery())


def _robots(place: Ros2Address, graph: Graph, batteries: _Batteries) -> list[NearbyRobot]:
    topics = graph.topics()
    return [
        NearbyRobot(
            title_of(robot, topics),
            robot.namespace.strip("/"),
            place.domain,
            robot_address(place, robot).bare(),
            robot_address(place, robot).text(),
            batteries.of(robot, graph),
            any(is_router(host) for host in hosts_of(robot, graph.hosts())),
            are_several(robot, graph.processes()),
        )
        for robot in find_robots(topics, graph.hosts())
        if not place.namespace or robot.namespace == place.namespace
    ]


def _main(place: Ros2Address) -> None:
    transport = open_transport(place.domain, place.host)
    batteries = _Batteries(transport)
    told: list[NearbyRobot] | None = None
    while True:
        robots = _robots(place, transport.graph(), batteries)
        if robots != told:
            told = robots
            sys.stdout.buffer.write(encode_robots(robots) + b"\n")
            sys.stdout.flush()
        if select.select([0], [], [], _PERIOD)[0]:
            transport.close()
            return


if __name__ == "__main__":
    _given = parse_ros2_address(sys.argv[1])
    assert _given is not None
    _main(_given)
