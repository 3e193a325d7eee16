"""
Routes of a cluster's page: where a class is, and the services of all classes as Prometheus discovers them.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable

from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

__all__ = ["class_routes"]


def class_routes(
    find: Callable[[str], Awaitable[str | None]], services: Callable[[], Awaitable[dict[str, str] | None]]
) -> list[Route]:
    """
    Below ``/api``.

    Args:
        find: HOST:PORT of the class of a name; ``None`` while it starts, and if no node serves it.
        services: HOST:PORT of all classes by name; ``None`` without an answer of the cluster.
    """

    async def place(request: Request) -> Response:
        address = await find(request.query_params.get("class", ""))
        uncached = {"Cache-Control": "no-store"}
        if address is None:
            return JSONResponse({}, status_code=503, headers=uncached)
        return JSONResponse({"address": address}, headers=uncached)

    async def targets(_request: Request) -> Response:
        # https://prometheus.io/docs/prometheus/latest/http_sd/
        found = await services()
        if found is None:
            return JSONResponse([], status_code=503)
        return JSONResponse([{"targets": [address], "labels": {"class": name}} for name, address in found.items()])

    return [Route("/api/place", place), Route("/api/services", targets)]
