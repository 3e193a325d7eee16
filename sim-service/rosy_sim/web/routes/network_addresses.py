"""Route that tells a page on this computer under which addresses others on the network reach the service."""

from __future__ import annotations

import ipaddress
from collections.abc import Callable
from urllib.parse import urlsplit

from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Route

__all__ = ["NetworkAddresses"]


class NetworkAddresses:
    """``addresses``: where a service is reached, also those that lead only to this computer."""

    def __init__(self, addresses: Callable[[], list[str]]) -> None:
        self._addresses = addresses

    def routes(self) -> list[BaseRoute]:
        """Below ``/api``."""
        return [Route("/api/addresses", self._tell)]

    async def _tell(self, request: Request) -> Response:
        """None for a page elsewhere, also behind a proxy here: it need not know this computer's networks."""
        client = request.client.host if request.client is not None else ""
        is_here = _is_loopback(client) and _is_loopback(request.url.hostname or "")
        found = [one for one in self._addresses() if not _is_loopback(urlsplit(one).hostname or "")] if is_here else []
        return JSONResponse({"addresses": found}, headers={"Cache-Control": "no-store"})


def _is_loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"
