"""
DDS participant: discovery, writers and readers of one domain, by Cyclone DDS.

Callbacks come from threads of DDS; the ones that are given here are called in those threads.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any
from xml.sax.saxutils import quoteattr

from cyclonedds.builtin import (
    BuiltinDataReader,
    BuiltinTopicDcpsParticipant,
    BuiltinTopicDcpsPublication,
    BuiltinTopicDcpsSubscription,
)
from cyclonedds.core import DDSException, InstanceState, Listener, Policy, Qos, ReadCondition, SampleState, ViewState
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from .dds_caller import DdsCaller
from .dds_messages import message_class, with_header
from .dds_names import dds_reply_topic, dds_request_topic
from .graph import Endpoint, Graph, Quality
from .transport import MOST_TAKEN, Caller, Reader, Writer

__all__ = ["DdsTransport"]

_MAX_ENDPOINTS = 5000
"""Of a domain; more are not looked at."""

_ALIVE = InstanceState.Alive | ViewState.Any | SampleState.Any

_CYCLONE = b"\x01\x10"
"""Cyclone DDS's number as a vendor (dds-foundation.org, DDSI-RTPS vendor and product IDs)."""

_SERVICE = Quality(True, False)
"""rmw, qos_profiles.h: rmw_qos_profile_services_default."""

_BLOCKING = duration(milliseconds=100)
"""What ROS 2 uses (rmw_cyclonedds: DDS_RELIABILITY max_blocking_time), shorter: the next velocity is due then."""


_HOST = re.compile(r"udp/([\d.]+):")
"""An address among those of a participant, which Cyclone DDS has as a property: ``udp/192.168.1.5:7410@2``."""


class DdsTransport:
    """
    ``address`` is a computer that alone is asked, without multicast: that does not go through a VPN or many a wireless
    network, and it reaches all robots of a domain where one is meant.
    """

    def __init__(self, domain: int, address: str | None = None) -> None:
        # The domain is closed when nothing refers to it.
        self._domain = Domain(domain, _configuration(address))
        self._participant = DomainParticipant(domain)
        self._writers = BuiltinDataReader(self._participant, BuiltinTopicDcpsPublication)
        self._readers = BuiltinDataReader(self._participant, BuiltinTopicDcpsSubscription)
        self._others = BuiltinDataReader(self._participant, BuiltinTopicDcpsParticipant)
        readers = (self._writers, self._readers, self._others)
        self._alive = {reader: ReadCondition(reader, _ALIVE) for reader in readers}
        self._topics: dict[tuple[str, str], Any] = {}

    def graph(self) -> Graph:
        """What has been discovered of other processes."""
        hosts = self._hosts()
        return Graph(self._discovered(self._writers, hosts), self._discovered(self._readers, hosts))

    def writer(self, topic: str, kind: str, quality: Quality) -> Writer:
        """Of a DDS topic."""
        return _Writer(DataWriter(self._participant, self._topic(topic, message_class(kind)), qos=_qos(quality)))

    def caller(self, service: str, kind: str) -> Caller | None:
        """Of a service; those of Cyclone DDS have a header of their own."""
        topic = dds_request_topic(service)
        servers = [e.participant[:2] for e in self.graph().readers if e.topic == topic]
        if not servers:
            return None
        made = with_header if _CYCLONE in servers else message_class
        replies = self._topic(dds_reply_topic(service), made(f"{kind}_Response"))
        caller = DdsCaller(kind, made(f"{kind}_Request"), has_header=_CYCLONE in servers)
        listener = Listener(on_data_available=lambda _reader: caller.take())
        # A service answers at once, so the reader is announced first.
        reader = DataReader(self._participant, replies, qos=_qos(_SERVICE), listener=listener)
        requests = self._topic(topic, made(f"{kind}_Request"))
        caller.use(DataWriter(self._participant, requests, qos=_qos(_SERVICE)), reader)
        return caller

    def reader(self, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]) -> Reader:
        """``on_data`` is called in a thread of DDS whenever there is something to take."""
        listener = Listener(on_data_available=lambda _reader: on_data())
        made = message_class(kind)
        return _Reader(DataReader(self._participant, self._topic(topic, made), qos=_qos(quality), listener=listener))

    def close(self) -> None:
        """A participant leaves when nothing refers to it."""

    def _topic(self, name: str, made: Any) -> Any:
        # A second one of the same name and type is refused or not, by the quality of the first.
        key = (name, made.__idl__.idl_transformed_typename)
        if key not in self._topics:
            self._topics[key] = Topic(self._participant, name, made)
        return self._topics[key]

    def _hosts(self) -> dict[Any, str]:
        """The addresses of participants by their keys."""
        hosts = {}
        for found in self._others.read(_MAX_ENDPOINTS, condition=self._alive[self._others]):
            properties = [policy for policy in found.qos if isinstance(policy, Policy.Property)]
            places = [p.value for p in properties if p.key == "__NetworkAddresses"]
            address = _HOST.search(places[0]) if places else None
            if address is not None:
                hosts[found.key] = address[1]
        return hosts

    def _discovered(self, reader: Any, hosts: Mapping[Any, str]) -> Iterator[Endpoint]:
        own = self._participant.guid
        for found in reader.read(_MAX_ENDPOINTS, condition=self._alive[reader]):
            if found.participant_key != own:
                reliability, durability = found.qos[Policy.Reliability], found.qos[Policy.Durability]
                quality = Quality(
                    isinstance(reliability, Policy.Reliability.Reliable),
                    durability not in (None, Policy.Durability.Volatile),
                )
                participant = found.participant_key
                host = hosts.get(participant, "")
                yield Endpoint(found.topic_name, found.type_name, quality, participant.bytes, host)


class _Writer:
    def __init__(self, writer: Any) -> None:
        self._writer = writer

    def write(self, message: Any) -> None:
        self._writer.write(message)

    def is_matched(self) -> bool:
        return bool(self._writer.get_matched_subscriptions())

    def flush(self) -> None:
        # A writer that is gone sends nothing again. At a timeout cyclonedds 11.0.1 itself fails: pub.py, wait_for_acks.
        with contextlib.suppress(DDSException, AttributeError):
            self._writer.wait_for_acks(duration(milliseconds=500))


class _Reader:
    def __init__(self, reader: Any) -> None:
        self._reader = reader

    def take(self) -> list[Any]:
        return [sample for sample in self._reader.take(MOST_TAKEN) if sample.sample_info.valid_data]

    def close(self) -> None:
        """A reader is closed when nothing refers to it."""


def _configuration(address: str | None) -> str:
    """
    As the manual of Cyclone DDS describes it, in its chapter on configuration. On one computer up to a hundred
    participants of a domain are looked for.
    """
    if address is None:
        general, index, peers = "", "auto", ""
    else:
        # At a random port: others still send to that of an earlier process, for as long as they believe it alive.
        general, index = "<General><AllowMulticast>false</AllowMulticast></General>", "none"
        peers = f"<Peers><Peer address={quoteattr(address)}/></Peers>"
    discovery = (
        f"<ParticipantIndex>{index}</ParticipantIndex><MaxAutoParticipantIndex>99</MaxAutoParticipantIndex>{peers}"
    )
    return f"<CycloneDDS><Domain>{general}<Discovery>{discovery}</Discovery></Domain></CycloneDDS>"


def _qos(quality: Quality) -> Qos:
    return Qos(
        Policy.Reliability.Reliable(_BLOCKING) if quality.reliable else Policy.Reliability.BestEffort,
        Policy.Durability.TransientLocal if quality.latched else Policy.Durability.Volatile,
        Policy.History.KeepLast(10),
        # What ROS 2 sends; newer versions of DDS would choose another encoding.
        Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False),
    )
