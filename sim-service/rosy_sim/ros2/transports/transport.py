"""
Transports of ROS 2: what a bridge, its guardian and the discovery need of DDS and of Zenoh, and both as one.

A transport knows the graph, and makes writers and readers of its topics, which are named as in DDS. Messages are those
of ``dds_messages.py``. Callbacks are called in threads of the transport.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from .graph import Graph, Quality

__all__ = ["MOST_TAKEN", "Answer", "Caller", "Reader", "Transport", "Transports", "Writer"]

MOST_TAKEN = 100
"""Messages that one look at a reader takes."""


Answer = Callable[[Any], None]
"""Takes the response of a service, a ``BadMessage`` in place of one that cannot be read, or ``None``: there is none."""


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


class Caller(Protocol):
    """Of one service; closed when nothing refers to it."""

    is_exact: bool
    """Whether it tells its own answers from those to others."""

    def is_matched(self) -> bool:
        """Whether the service hears it, and is heard."""

    def call(self, request: Any, on_answer: Answer) -> None:
        """``on_answer`` is called once, in a thread of the transport; never while a service does not answer."""


class Transport(Protocol):
    """One domain."""

    def graph(self) -> Graph:
        """What other processes read and write now."""

    def writer(self, topic: str, kind: str, quality: Quality) -> Writer:
        """Of a message type that has a definition."""

    def caller(self, service: str, kind: str) -> Caller | None:
        """Of a service that the graph has, of a type that has a definition; ``None`` where it is not there."""

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

    def caller(self, service: str, kind: str) -> Caller | None:
        """Of the first of them that has the service."""
        callers = (transport.caller(service, kind) for transport in self._transports)
        return next((caller for caller in callers if caller is not None), None)

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
