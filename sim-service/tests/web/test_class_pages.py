"""The short addresses of the teacher's board and the projector."""

from __future__ import annotations

import asyncio
from pathlib import Path
from unittest.mock import Mock

import httpx
import pytest
from starlette.applications import Starlette

from rosy_sim.web.routes.class_files import ClassFiles


@pytest.mark.parametrize("page", ["board", "projector"])
@pytest.mark.parametrize("query", ["", "?lang=de"])
def test_a_short_address_keeps_what_it_asks_for(page: str, query: str) -> None:
    async def ask() -> httpx.Response:
        transport = httpx.ASGITransport(Starlette(routes=ClassFiles(Mock(), Path()).routes()))
        async with httpx.AsyncClient(transport=transport, base_url="http://rosy") as client:
            return await client.get(f"/{page}{query}")

    assert asyncio.run(ask()).headers["location"] == f"./{page}.html{query}"
