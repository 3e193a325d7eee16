"""
What is known of a ROS 2 graph: the writers and readers that DDS has discovered, as topics and services of ROS.

Pure. Also decides the quality of service with which a topic is read and written, so that it follows what the other side
offers: a reader that asks for more than a writer offers never hears it (DDS 1.4, 2.2.3).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from .dds_names import ros_service, ros_topic, ros_type

__all__ = ["Endpoint", "Graph", "Quality"]


@dataclass(frozen=True, slots=True)
class Quality:
    """Quality of service: ``reliable`` retransmits lost samples; ``latched`` is DDS's durability TRANSIENT_LOCAL."""

    reliable: bool
    latched: bool


@dataclass(frozen=True, slots=True)
class Endpoint:
    """A writer or a reader of another process."""

    topic: str
    """Of DDS."""

    type: str
    """Of DDS."""

    quality: Quality
    participant: bytes
    """GUID of its process; the first two bytes are the vendor's number (RTPS 2.5, 8.2.4)."""

    host: str = ""
    """The first network address of its computer; empty when it is not known."""


class Graph:
    """The graph at one moment."""

    def __init__(self, writers: Iterable[Endpoint] = (), readers: Iterable[Endpoint] = ()) -> None:
        self.writers = frozenset(writers)
        self.readers = frozenset(readers)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Graph) and (self.writers, self.readers) == (other.writers, other.readers)

    def __hash__(self) -> int:
        return hash((self.writers, self.readers))

    def topics(self) -> dict[str, str]:
        """
        All topics with their types, sorted; of a topic with several types that of its readers, whom a command has to
        reach.
        """
        found = {
            topic: kind
            for endpoints in (self.writers, self.readers)
            for endpoint in sorted(endpoints, key=lambda e: (e.topic, e.type))
            if (topic := ros_topic(endpoint.topic)) and (kind := ros_type(endpoint.type))
        }
        return dict(sorted(found.items()))

    def services(self) -> dict[str, str]:
        """All services with their types, sorted."""
        return {
            service: kind
            for endpoint in sorted(self.readers, key=lambda e: (e.topic, e.type))
            if (service := ros_service(endpoint.topic)) and (kind := ros_type(endpoint.type))
        }

    def hosts(self) -> dict[str, list[str]]:
        """The computers that write each topic, sorted, where they are known."""
        found: dict[str, set[str]] = {}
        for endpoint in self.writers:
            if endpoint.host and (topic := ros_topic(endpoint.topic)):
                found.setdefault(topic, set()).add(endpoint.host)
        return {topic: sorted(hosts) for topic, hosts in sorted(found.items())}

    def processes(self) -> dict[str, dict[str, int]]:
        """How many processes write each topic, by computer."""
        found: dict[str, dict[str, set[bytes]]] = {}
        for endpoint in self.writers:
            if topic := ros_topic(endpoint.topic):
                found.setdefault(topic, {}).setdefault(endpoint.host, set()).add(endpoint.participant)
        return {topic: {host: len(own) for host, own in hosts.items()} for topic, hosts in found.items()}

    def reader_types(self, topic: str) -> set[str]:
        """The types, as ROS has them, in which a DDS topic is read."""
        return {kind for e in self.readers if e.topic == topic and (kind := ros_type(e.type))}

    def reading_quality(self, topic: str) -> Quality:
        """With which a DDS topic can be heard from all its writers; the least one while there are none."""
        offered = [e.quality for e in self.writers if e.topic == topic]
        return Quality(
            bool(offered) and all(q.reliable for q in offered),
            bool(offered) and all(q.reliable and q.latched for q in offered),
        )

    def writing_quality(self, topic: str, latched: bool) -> Quality:
        """
        With which all readers of a DDS topic can be reached; a reliable writer also reaches those that ask for less.
        """
        return Quality(True, latched or any(e.quality.latched for e in self.readers if e.topic == topic))
