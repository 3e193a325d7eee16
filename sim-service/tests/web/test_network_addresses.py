"""Addresses on the network that a page may put into a link."""

from __future__ import annotations

import asyncio

import httpx
import pytest
from starlette.applications import Starlette

from rosy_sim.web.routes.network_addresses import NetworkAddresses

ON_THE_NETWORK = "http://192.168.1.5:8080/"
HERE = ["http://127.0.0.1:8080/", "http://[::1]:8080/", "http://localhost:8080/"]


@pytest.mark.parametrize(
    ("client", "page", "addresses", "told"),
    [
        ("127.0.0.1", "http://127.0.0.1:8080", [ON_THE_NETWORK], [ON_THE_NETWORK]),
        ("::1", "http://localhost:8080", [*HERE, ON_THE_NETWORK], [ON_THE_NETWORK]),
        ("127.0.0.1", "http://[::1]:8080", HERE, []),
        ("127.0.0.1", "http://127.0.0.1:8080", [], []),
        # A page elsewhere is not told the other networks of this computer, also not through a proxy on it.
        ("192.168.1.9", "http://192.168.1.5:8080", [ON_THE_NETWORK], []),
        ("127.0.0.1", "https://rosy.example.org", [ON_THE_NETWORK], []),
    ],
)
def test_a_page_on_this_computer_is_told_where_others_reach_it(
    client: str, page: str, addresses: list[str], told: list[str]
) -> None:
    app = Starlette(routes=NetworkAddresses(lambda: addresses).routes())

    async def ask() -> object:
        transport = httpx.ASGITransport(app=app, client=(client, 50000))
        async with httpx.AsyncClient(transport=transport, base_url=page) as asking:
            return (await asking.get("/api/addresses")).json()

    assert asyncio.run(ask()) == {"addresses": told}
