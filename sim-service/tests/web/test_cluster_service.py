"""What a service of a cluster does beside that of a laptop: metrics, and pages from another service's origin."""

from __future__ import annotations

import asyncio
from dataclasses import replace

import httpx
import pytest
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus
from websockets.typing import Origin

from rosy_sim.config import Config

from ..conftest import PATIENCE, UNHURRIED
from .test_app import opened, serving


def test_metrics_are_in_the_format_of_prometheus(config: Config) -> None:
    async def ask() -> list[str]:
        async with serving(config) as (address, _), opened(address) as page:
            await page.op("hello")
            async with httpx.AsyncClient(timeout=PATIENCE) as client:
                answer = await client.get(f"http://{address}/api/metrics")
        assert answer.headers["content-type"].startswith("text/plain; version=0.0.4")
        return answer.text.splitlines()

    lines = asyncio.run(ask())
    assert lines[:2] == ["# TYPE rosy_pages gauge", "rosy_pages 1"]
    assert "rosy_step_lateness_p99 0.0" in lines
    assert all(line.startswith("# TYPE rosy_") or float(line.split(" ")[1]) >= 0 for line in lines)


def test_pages_of_the_cluster_are_let_in_and_no_others(config: Config) -> None:
    async def knock() -> None:
        async with serving(replace(config, origins=frozenset({"rosy.example"}))) as (address, _):
            url = f"ws://{address}/api/session"
            async with connect(url, origin=Origin("https://rosy.example"), **UNHURRIED) as page:
                assert '"hello"' in str(await page.recv())
            with pytest.raises(InvalidStatus):
                await connect(url, origin=Origin("https://elsewhere.example"), **UNHURRIED)

    asyncio.run(knock())
