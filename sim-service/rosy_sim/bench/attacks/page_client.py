"""
Page as a client of the protocol, for benchmarks whose pages are in another process than the service.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from websockets.asyncio.client import ClientConnection, connect

__all__ = ["PageClient", "connected", "opened"]

Message = dict[str, Any]


class PageClient:
    """An open page."""

    def __init__(self, socket: ClientConnection, port: int, address: str) -> None:
        self._socket = socket
        self.port = port
        self.address = address

    async def send(self, op: str, **fields: Any) -> None:
        """Send a message."""
        await self._socket.send(json.dumps({"op": op, **fields}))

    async def answer(self, *ops: str) -> Message:
        """The next message of one of these kinds; those before it are dropped."""
        while True:
            message: Message = json.loads(await self._socket.recv())
            if message["op"] in ops:
                return message

    async def drain(self) -> None:
        """Read on and drop everything until the connection ends."""
        async for _ in self._socket:
            pass


@asynccontextmanager
async def connected(port: int, path: str, address: str = "127.0.0.1") -> AsyncIterator[ClientConnection]:
    """
    A socket of a service on this machine.

    Args:
        port: of the service.
        path: below ``/api``.
        address: the client's; all of 127.0.0.0/8 is this machine.
    """
    url = f"ws://127.0.0.1:{port}/api/{path}"
    async with connect(
        url, local_addr=(address, 0), open_timeout=None, ping_interval=None, compression=None, max_size=None
    ) as socket:
        try:
            yield socket
        finally:
            asyncio.get_running_loop().call_soon(socket.transport.abort)


@asynccontextmanager
async def opened(port: int, address: str, path: str = "session") -> AsyncIterator[PageClient]:
    """A page, or another client that sends messages."""
    async with connected(port, path, address) as socket:
        yield PageClient(socket, port, address)
