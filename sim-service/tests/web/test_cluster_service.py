"""
What a service of a cluster does beside that of a laptop: metrics with their dashboard, and pages and boards from
another origin.
"""

from __future__ import annotations

import asyncio
import json
import re
from dataclasses import replace
from pathlib import Path

import httpx
import pytest
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus
from websockets.typing import Origin

from rosy_sim.config import Config

from ..conftest import PATIENCE, UNHURRIED
from .page_client import opened, serving
from .test_class import teaching


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


DOCS = Path(__file__).resolve().parents[3] / "docs"


def test_the_dashboard_shows_metrics_that_a_class_has(config: Config) -> None:
    async def ask() -> str:
        async with teaching(config) as opened, httpx.AsyncClient(timeout=PATIENCE) as http:
            return (await http.get(f"http://{opened.address}/api/metrics")).text

    # `up` is made by Prometheus for each service that it asks.
    there = {line.split(" ")[0] for line in asyncio.run(ask()).splitlines() if not line.startswith("#")} | {"up"}
    dashboard = json.loads((DOCS / "district-dashboard.json").read_text())
    queries = [target["expr"] for panel in dashboard["panels"] for target in panel["targets"]]
    shown = {name for query in queries for name in re.findall(r"(\w+)\{", query)}
    assert shown == there
    assert all('{job="rosy", class=~"$class"}' in query for query in queries)


def test_the_dashboard_has_the_structure_that_grafana_imports() -> None:
    dashboard = json.loads((DOCS / "district-dashboard.json").read_text())
    assert dashboard["schemaVersion"] == 39
    (source,) = dashboard["__inputs"]
    reference = {"type": source["pluginId"], "uid": f"${{{source['name']}}}"}
    (variable,) = dashboard["templating"]["list"]
    assert (variable["name"], variable["type"], variable["datasource"]) == ("class", "query", reference)
    panels = dashboard["panels"]
    assert len({panel["id"] for panel in panels}) == len(panels)
    places = set()
    for panel in panels:
        assert panel["type"] == "timeseries"
        assert panel["title"]
        assert panel["fieldConfig"]["defaults"]["unit"] in ("short", "s", "percentunit")
        assert panel["datasource"] == reference
        assert [target["refId"] for target in panel["targets"]] == ["A", "B"][: len(panel["targets"])]
        assert all(target["datasource"] == reference and target["legendFormat"] for target in panel["targets"])
        place = panel["gridPos"]
        assert 0 <= place["x"] <= 24 - place["w"]
        places.add((place["x"], place["y"]))
    assert len(places) == len(panels)


def test_pages_of_the_cluster_are_let_in_and_no_others(config: Config) -> None:
    async def knock() -> None:
        async with serving(replace(config, origins=frozenset({"rosy.example"}))) as (address, _):
            url = f"ws://{address}/api/session"
            async with connect(url, origin=Origin("https://rosy.example"), **UNHURRIED) as page:
                assert '"hello"' in str(await page.recv())
            with pytest.raises(InvalidStatus):
                await connect(url, origin=Origin("https://elsewhere.example"), **UNHURRIED)

    asyncio.run(knock())


def test_a_board_of_the_cluster_gets_the_files_of_its_class_and_no_other_page_does(config: Config) -> None:
    async def ask() -> None:
        ours, others = "http://10.0.0.1:8080", "http://10.0.0.2:8080"
        async with (
            teaching(replace(config, origins=frozenset({"10.0.0.1:8080"}))) as opened,
            httpx.AsyncClient(base_url=f"http://{opened.address}", timeout=PATIENCE) as http,
        ):
            asks = {"Access-Control-Request-Method": "GET", "Access-Control-Request-Headers": "x-rosy-key"}
            for path in ("/api/hand-ins/1", "/api/class-backup"):
                assert (await http.options(path, headers={**asks, "Origin": others})).status_code == 400
                allowed = await http.options(path, headers={**asks, "Origin": ours})
                assert (allowed.status_code, allowed.headers["access-control-allow-origin"]) == (200, ours)
                for key, status in ((opened.key, 200 if path.endswith("backup") else 404), ("wrong", 403)):
                    answer = await http.get(path, headers={"Origin": ours, "X-Rosy-Key": key})
                    assert (answer.status_code, answer.headers["access-control-allow-origin"]) == (status, ours)
                answer = await http.get(path, headers={"Origin": others, "X-Rosy-Key": opened.key})
                assert "access-control-allow-origin" not in answer.headers

    asyncio.run(ask())
