"""
Transports of ROS 2: what a bridge, its guardian and the discovery need of DDS and of Zenoh, and both as one.

A transport knows the graph, and makes writers and readers of its topics, which are named as in DDS. Messages are those
of ``dds_messages.py``. Callbacks are called in threads of the transport.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from .graph import Graph, Quality

__all__ = ["MOST_TAKEN", "Reader", "Transport", "Transports", "Writer"]

MOST_TAKEN = 100
"""Messages that one look at a reader takes."""


class Writer(Protocol):
    """Of one topic and type; closed when nothing refers to it."""

    def write(self, message: Any) -> None:
        """Send a message to all that read it now."""

    def is_matched(self) -> bool:
        """Whether there is something that reads it."""

    def flush(self) -> None:
        """Wait until what was written has arrived, for half a second at most."""


class Reader(Protocol):
    """Of one topic and type."""

    def take(self) -> list[Any]:
        """The messages that have arrived, the oldest first; a ``BadMessage`` in place of one that cannot be read."""

    def close(self) -> None:
        """It hears nothing from now on."""


class Transport(Protocol):
    """One domain."""

    def graph(self) -> Graph:
        """What other processes read and write now."""

    def writer(self, topic: str, kind: str, quality: Quality) -> Writer:
        """Of a message type that has a definition."""

    def request_writer(self, service: str, kind: str) -> Writer:
        """Of the requests of a service, whose type has a definition; their answers are not read."""

    def reader(self, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]) -> Reader:
        """``on_data`` is called whenever there is something to take."""

    def close(self) -> None:
        """Leave the domain. What was written is sent first."""


class Transports:
    """Several transports as one, for robots of which it is not known what they speak."""

    def __init__(self, transports: Sequence[Transport]) -> None:
        self._transports = transports

    def graph(self) -> Graph:
        """Of all of them."""
        graphs = [transport.graph() for transport in self._transports]
        return Graph(
            (writer for graph in graphs for writer in graph.writers),
            (reader for graph in graphs for reader in graph.readers),
        )

    def writer(self, topic: str, kind: str, quality: Quality) -> Writer:
        """Writes to all of them."""
        return _Writers([transport.writer(topic, kind, quality) for transport in self._transports])

    def request_writer(self, service: str, kind: str) -> Writer:
        """Writes to all of them."""
        return _Writers([transport.request_writer(service, kind) for transport in self._transports])

    def reader(self, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]) -> Reader:
        """Reads from all of them."""
        return _Readers([transport.reader(topic, kind, quality, on_data) for transport in self._transports])

    def close(self) -> None:
        """Leave all of them."""
        for transport in self._transports:
            transport.close()


class _Writers:
    def __init__(self, writers: Sequence[Writer]) -> None:
        self._writers = writers

    def write(self, message: Any) -> None:
        for writer in self._writers:
            writer.write(message)

    def is_matched(self) -> bool:
        return any(writer.is_matched() for writer in self._writers)

    def flush(self) -> None:
        for writer in self._writers:
            writer.flush()


class _Readers:
    def __init__(self, readers: Sequence[Reader]) -> None:
        self._readers = readers

    def take(self) -> list[Any]:
        return [message for reader in self._readers for message in reader.take()]

    def close(self) -> None:
        for reader in self._readers:
            reader.close()
