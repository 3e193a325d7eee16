"""
Names of ROS 2 in Zenoh, and back, as rmw_zenoh has them (its design document). Pure.

The key of a topic is ``<domain>/<topic>/<type>/<type hash>``, with the name of the type in DDS. What a process reads
and writes is in its liveliness tokens,
``@ros2_lv/<domain>/<session>/<node id>/<id>/<kind>/<enclave>/<namespace>/<node>/<topic>/<type>/<type hash>/<quality>``,
where ``%`` stands for a slash. The type hash of a topic is taken from these tokens: a message can only be received
under the hash that its reader has.
"""

from __future__ import annotations

from dataclasses import dataclass

from .dds_names import dds_request_topic, dds_topic
from .graph import Endpoint, Quality

__all__ = ["ZenohEndpoint", "node_token", "parse_token", "token_for", "topic_key"]

_NODE, _PUBLISHER, _SUBSCRIBER, _SERVER, _CLIENT = "NN", "MP", "MS", "SS", "SC"
"""Kinds of a token."""

_COUNTERPARTS = {_PUBLISHER: _SUBSCRIBER, _SUBSCRIBER: _PUBLISHER, _SERVER: _CLIENT}

_BEST_EFFORT, _TRANSIENT_LOCAL = "2", "1"
"""Numbers of the qualities in a token (rmw, types.h); those that it leaves empty are reliable and volatile."""

_VENDOR = b"\0\0"
"""No vendor of DDS (RTPS 2.5, 9.3.2); the name of the session follows, which is one for each process."""


@dataclass(frozen=True, slots=True)
class ZenohEndpoint:
    """A publisher, a subscriber or a server of another session, by its token."""

    domain: str
    session: str
    kind: str
    name: str
    """Of the topic or service, absolute."""
    type: str
    hash: str
    quality: Quality

    @property
    def is_reader(self) -> bool:
        """Whether it takes messages or requests."""
        return self.kind != _PUBLISHER

    @property
    def key(self) -> str:
        """Of its messages or requests."""
        return topic_key(self.domain, self.name, self.type, self.hash)

    def endpoint(self, host: str) -> Endpoint:
        """As DDS has it, where a service has a topic of its requests; ``host`` is the router over which it is known."""
        process = _VENDOR + self.session.encode()
        if self.kind == _SERVER:
            return Endpoint(dds_request_topic(self.name), f"{self.type}Request_", self.quality, process, host)
        return Endpoint(dds_topic(self.name), self.type, self.quality, process, host)


def topic_key(domain: str, name: str, type_name: str, type_hash: str) -> str:
    """The key of a topic's or service's absolute name; the hash may be ``*``, to listen to all."""
    return f"{domain}/{name.strip('/')}/{type_name}/{type_hash}"


def parse_token(key: str) -> ZenohEndpoint | None:
    """What a token stands for; ``None`` for nodes and clients."""
    parts = key.split("/")
    if len(parts) != 13 or parts[5] not in _COUNTERPARTS:
        return None
    _, domain, session, _, _, kind, _, _, _, name, type_name, type_hash, written = parts
    reliability, durability = (*written.split(":"), "")[:2]
    quality = Quality(reliability != _BEST_EFFORT, durability == _TRANSIENT_LOCAL)
    return ZenohEndpoint(domain, session, kind, name.replace("%", "/"), type_name, type_hash, quality)


def node_token(domain: str, session: str, node: str) -> str:
    """The token of the only node of a session."""
    return f"@ros2_lv/{domain}/{session}/0/0/{_NODE}/%/%/{node}"


def token_for(other: ZenohEndpoint, session: str, number: int, node: str) -> str:
    """
    The token of what reads from an endpoint or writes to it, in the same quality. ``number`` tells it from other tokens
    of its session.
    """
    written = f"{'' if other.quality.reliable else _BEST_EFFORT}:{_TRANSIENT_LOCAL if other.quality.latched else ''}"
    kind, name = _COUNTERPARTS[other.kind], other.name.replace("/", "%")
    place = f"@ros2_lv/{other.domain}/{session}/0/{number}/{kind}/%/%/{node}"
    return f"{place}/{name}/{other.type}/{other.hash}/{written}:,10:,:,:,,"
