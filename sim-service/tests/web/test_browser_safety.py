"""Host names and headers against attacks through a browser."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest
from starlette.responses import PlainTextResponse
from starlette.types import Message

from rosy_sim.web.browser_safety import BrowserSafety, own_names


def ask(host: str, query: str = "", kind: str = "http", path: str = "/", has_nodes: bool = False) -> list[Message]:
    """What the middleware sends about a request."""
    sent: list[Message] = []

    async def send(message: Message) -> None:
        sent.append(message)

    async def receive() -> Message:
        return {"type": "http.request"}

    scope: dict[str, Any] = {
        "type": kind,
        "method": "GET",
        "path": path,
        "query_string": query.encode(),
        "headers": [(b"host", host.encode())],
    }
    app = PlainTextResponse("hello") if kind == "http" else _accept
    asyncio.run(BrowserSafety(app, own_names("class.example"), has_nodes)(scope, receive, send))
    return sent


async def _accept(_scope: Any, _receive: Any, send: Any) -> None:
    await send({"type": "websocket.accept"})


def headers(sent: list[Message]) -> dict[str, str]:
    return {name.decode(): value.decode() for name, value in sent[0]["headers"]}


@pytest.mark.parametrize(
    "host", ["127.0.0.1:8080", "[::1]:8080", "192.168.0.7", "localhost:8080", "LOCALHOST", "class.example:1"]
)
def test_addresses_and_own_names_are_served(host: str) -> None:
    assert ask(host)[0]["status"] == 200
    assert ask(host, kind="websocket")[0]["type"] == "websocket.accept"


@pytest.mark.parametrize(
    "host", ["rebound.example:8080", "", "localhost.rebound.example", "127.0.0.1.rebound.example", "[::1", "a@b:c"]
)
def test_a_name_that_was_made_to_point_here_is_refused(host: str) -> None:
    assert ask(host)[0]["status"] == 421
    assert ask(host, kind="websocket")[0]["type"] == "websocket.close"


def test_the_page_inside_of_the_board_is_framed_by_this_service_only() -> None:
    answer = headers(ask("localhost", "embed=board"))
    assert "frame-ancestors 'self'" in answer["content-security-policy"]
    assert answer["x-frame-options"] == "SAMEORIGIN"


@pytest.mark.parametrize(
    ("query", "framed"), [("", False), ("example=a", False), ("embed", True), ("lang=de&embed", True)]
)
def test_only_the_embedded_page_is_framed_by_others(query: str, framed: bool) -> None:
    found = headers(ask("localhost", query))
    assert ("frame-ancestors 'none'" in found["content-security-policy"]) is not framed
    assert ("x-frame-options" in found) is not framed
    assert found["x-content-type-options"] == "nosniff"


def test_the_guide_runs_no_script_but_its_own_files_and_is_not_framed() -> None:
    policy = headers(ask("localhost", "embed", path="/guide/index.html"))["content-security-policy"]
    assert "default-src 'none'" in policy
    assert "script-src 'self';" in policy
    assert "unsafe" not in policy
    assert "frame-ancestors 'none'" in policy


def directives(sent: list[Message]) -> dict[str, str]:
    """The directives of the Content Security Policy by name."""
    policy = headers(sent)["content-security-policy"]
    return {name: value for name, _, value in (one.strip().partition(" ") for one in policy.split(";"))}


@pytest.mark.parametrize("path", ["/", "/board.html", "/projector.html", "/prelude.html", "/guide/index.html"])
@pytest.mark.parametrize("query", ["", "example=a", "embed", "embed=board", "class=7b"])
def test_pages_run_and_load_and_reach_what_this_service_has_only(path: str, query: str) -> None:
    found = directives(ask("localhost", query, path=path))
    is_guide = path.startswith("/guide/")
    assert found.pop("frame-ancestors")
    assert found.pop("style-src") == ("'self'" if is_guide else "'self' 'unsafe-inline'")
    assert found.pop("frame-src", "'self'") == "'self'"
    assert found == {
        "default-src": "'none'",
        "script-src": "'self'" if is_guide else "'self' 'wasm-unsafe-eval'",
        "font-src": "'self' data:",
        "img-src": "'self' data:" if is_guide else "'self' data: blob:",
        "connect-src": "'self'",
        "form-action": "'none'",
        "base-uri": "'none'",
    }


def test_pages_of_a_cluster_reach_its_nodes() -> None:
    found = directives(ask("localhost", "class=7b", has_nodes=True))
    assert found["connect-src"] == "'self' http: ws:"
    assert found["default-src"] == "'none'"
