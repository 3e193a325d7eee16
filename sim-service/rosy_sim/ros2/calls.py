"""
Calls of services of ROS 2, for the clients of a bridge.

In: names and content as rosbridge has them. Out: responses, or why there is none. Where a transport cannot tell its own
answers from those to others, there is one call of a service at a time, and none while another program has a client
of it.
"""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from .transports.dds_messages import BadMessage, from_json, message_class, to_json
from .transports.dds_names import dds_request_topic, dds_topic
from .transports.graph import Graph
from .transports.transport import Caller, Reader, Transport

__all__ = ["CallFailed", "Calls", "soon"]

_POLL = 0.05
"""Seconds between two looks at whether a service hears a caller."""

_MATCH_TIMEOUT = 2.0
"""For a caller and a service that the graph has to find each other, s."""

_ANNOUNCED = 0.2
"""
Until a service knows a reader that knows it, s: it answers none that it does not know. Fast DDS's would wait for one
that has told who it is, which Cyclone DDS cannot (rmw_fastrtps, rmw_response.cpp).
"""

_LIMIT = 30.0
"""For an answer that may be lost, s."""


class CallFailed(Exception):
    """A call could not be carried out; its text is the reason."""


@dataclass(slots=True)
class _Open:
    """The client of a service, and the pending responses."""

    caller: Caller
    kind: str
    answers: set[asyncio.Future[Any]] = field(default_factory=set)
    turn: asyncio.Lock = field(default_factory=asyncio.Lock)


class Calls:
    """Of one bridge. ``graph`` gives the newest one."""

    def __init__(self, transport: Transport, graph: Callable[[], Graph]) -> None:
        self._transport = transport
        self._graph = graph
        self._open: dict[str, _Open] = {}

    def kind(self, service: str) -> str:
        """
        The type of a service.

        Raises:
            CallFailed: there is no such service.
        """
        kind = self._graph().services().get(service)
        if kind is None:
            raise CallFailed("no robot offers it")
        return kind

    async def call(self, service: str, args: Any, has_listener: bool) -> dict[str, Any]:
        """
        The response of a service. Without a listener it may also be another program's.

        Raises:
            CallFailed: there is none.
        """
        if not await self.open(service) and has_listener:
            topic = dds_request_topic(service)
            if any(endpoint.topic == topic for endpoint in self._graph().writers):
                raise CallFailed("another program calls it too, and over DDS the answers cannot be told apart")
        try:
            async with asyncio.timeout(None if self._open[service].caller.is_exact else _LIMIT):
                return await self.ask(service, args)
        except TimeoutError:
            raise CallFailed("it has not answered") from None

    async def open(self, service: str) -> bool:
        """
        Waits until a service that is there hears what is called. Whether the answers are exactly those to this
        process.

        Raises:
            CallFailed: it is not there, or its type is not known.
        """
        kind = self.kind(service)
        if any(message_class(f"{kind}_{part}") is None for part in ("Request", "Response")):
            raise CallFailed(f"there is no definition of {kind}")
        known = self._open.get(service)
        if known is not None and known.kind == kind:
            return known.caller.is_exact
        caller = self._transport.caller(service, kind)
        if caller is None:
            raise CallFailed("no robot offers it")
        self._open[service] = _Open(caller, kind)
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(_MATCH_TIMEOUT):
                while not caller.is_matched():  # noqa: ASYNC110 a thread of the transport tells it
                    await asyncio.sleep(_POLL)
        if not caller.is_exact:
            await asyncio.sleep(_ANNOUNCED)
        return caller.is_exact

    async def ask(self, service: str, args: Any) -> dict[str, Any]:
        """
        The response of a service that was opened, whenever it comes.

        Raises:
            CallFailed: there will be none.
        """
        opened = self._open.get(service)
        if opened is None:
            raise CallFailed("it is not there any more")
        if opened.caller.is_exact:
            return await self._ask(opened, args)
        async with opened.turn:
            return await self._ask(opened, args)

    def tell(self, service: str, args: Any) -> None:
        """Calls a service that was opened and may be gone; what it answers is not read."""
        opened = self._open.get(service)
        if opened is not None:
            opened.caller.call(_request(opened.kind, args), lambda _answer: None)

    def follow_graph(self) -> None:
        """Ends the calls of services that are gone."""
        services = self._graph().services()
        for service in [service for service in self._open if service not in services]:
            for answer in self._open.pop(service).answers:
                _settle(answer, None)

    def reader(self, topic: str, kind: str, on_data: Callable[[], None]) -> Reader:
        """Of a topic; ``on_data`` is called on the event loop."""
        loop = asyncio.get_running_loop()
        quality = self._graph().reading_quality(dds_topic(topic))
        return self._transport.reader(dds_topic(topic), kind, quality, lambda: soon(loop, on_data))

    async def _ask(self, opened: _Open, args: Any) -> dict[str, Any]:
        loop = asyncio.get_running_loop()
        answer: asyncio.Future[Any] = loop.create_future()
        opened.answers.add(answer)
        request = _request(opened.kind, args)
        try:
            opened.caller.call(request, lambda response: soon(loop, lambda: _settle(answer, response)))
            response = await answer
        finally:
            opened.answers.discard(answer)
        if response is None:
            raise CallFailed("it has not answered")
        if isinstance(response, BadMessage):
            raise CallFailed(str(response))
        return to_json(f"{opened.kind}_Response", response)


def soon(loop: asyncio.AbstractEventLoop, act: Callable[[], None]) -> None:
    """Acts on the event loop; a transport may say something while the process ends."""
    with contextlib.suppress(RuntimeError):
        loop.call_soon_threadsafe(act)


def _request(kind: str, args: Any) -> Any:
    try:
        return from_json(f"{kind}_Request", args, lambda: divmod(time.time_ns(), 10**9))
    except BadMessage as why:
        raise CallFailed(str(why)) from None


def _settle(answer: asyncio.Future[Any], response: Any) -> None:
    if not answer.done():
        answer.set_result(response)
