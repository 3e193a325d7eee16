"""
Middleware against attacks through a browser: refuses host names that are not this machine's, lets pages run scripts of
this service only, and lets other sites frame the embedded page only.

A page from elsewhere whose name was made to point at this machine (DNS rebinding) still sends its own name as ``Host``.
An IP address cannot be made to point elsewhere, so every address is accepted, also of a machine that forwards a port.
"""

from __future__ import annotations

import ipaddress
import socket
from collections.abc import Iterable
from urllib.parse import parse_qs, urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from ..sentences.sentence import tr
from ..sentences.wording import in_terminal

__all__ = ["BrowserSafety", "own_names"]

_POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
    "font-src 'self' data:; img-src 'self' data: blob:; frame-src 'self'; form-action 'none'; base-uri 'none'"
)
"""
Directives for every page but the guide's. Content Security Policy Level 3. Scripts and workers are files of this
service; the reader of programs is WebAssembly, which ``'wasm-unsafe-eval'`` allows, and no text becomes a script.
Blockly and CodeMirror add style elements. Small fonts, the icon and pictures in style sheets are data URLs, and a
diagram is saved as PNG by way of a blob. The board frames a pupil's program. No form is sent.
"""

_OWN_SERVICE = "connect-src 'self'"
"""Requests and WebSockets of this origin (CSP3, section 6.7.2.8: ``'self'`` matches ``ws:`` of the same host)."""

_NODES = f"{_OWN_SERVICE} http: ws:"
"""A page of a cluster also connects to the node that has its class, whose address it learns later (``cluster``)."""

_GUIDE = "/guide/"

_GUIDE_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self' data:; img-src 'self' data:; "
    "connect-src 'self'; form-action 'none'; base-uri 'none'; frame-ancestors 'none'"
)
"""
Directives for the guide: its pages load its own files, and contain no script or style. Their icon and small fonts are
data URLs.
"""


def own_names(host: str) -> frozenset[str]:
    """The names under which browsers reach this machine: its own ones, and that on which it listens."""
    name = socket.gethostname().lower()
    return frozenset({"localhost", host.lower(), name, f"{name.partition('.')[0]}.local"})


class BrowserSafety:
    """
    The application behind both checks.

    Args:
        app: the application.
        names: host names to serve; ``None`` for every name.
        has_nodes: whether pages connect to other nodes of a cluster.
    """

    def __init__(self, app: ASGIApp, names: Iterable[str] | None, has_nodes: bool = False) -> None:
        self._app = app
        self._names = None if names is None else frozenset(names)
        self._policy = f"{_POLICY}; {_NODES if has_nodes else _OWN_SERVICE}"

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve a request, or refuse it."""
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
        elif not self._is_own(Headers(scope=scope).get("host", "")):
            await _refuse(scope, receive, send)
        elif scope["type"] == "http":
            await self._app(scope, receive, _with_headers(send, scope, self._policy))
        else:
            await self._app(scope, receive, send)

    def _is_own(self, host: str) -> bool:
        if self._names is None:
            return True
        try:
            name = urlsplit(f"//{host}").hostname or ""
        except ValueError:
            return False
        return name.rstrip(".") in self._names or name.endswith(".localhost") or _is_address(name)


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


async def _refuse(scope: Scope, receive: Receive, send: Send) -> None:
    if scope["type"] == "websocket":
        await send({"type": "websocket.close", "code": 1008, "reason": ""})
        return
    # 421, RFC 9110 section 15.5.20: the request was directed at a server that does not answer for this name.
    sentence = tr("Rosy does not answer to this name. Open it with the address that it prints when it starts.")
    await PlainTextResponse(f"{in_terminal(sentence)}\n", status_code=421)(scope, receive, send)


def _with_headers(send: Send, scope: Scope, policy: str) -> Send:
    """
    Adds the headers to the response; only a page that asks to be embedded may be framed by other sites. One that asks
    for the teacher's board may be framed by this service, because it tells its frame what is chosen in it.
    """
    query = parse_qs(scope["query_string"].decode("latin-1"), keep_blank_values=True)
    is_embedded = "embed" in query
    is_on_board = query.get("embed") == ["board"]

    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            headers["X-Content-Type-Options"] = "nosniff"
            headers["Referrer-Policy"] = "no-referrer"
            if scope["path"].startswith(_GUIDE):
                headers["Content-Security-Policy"] = _GUIDE_POLICY
                headers["X-Frame-Options"] = "DENY"
            elif is_on_board:
                headers["Content-Security-Policy"] = f"{policy}; frame-ancestors 'self'"
                headers["X-Frame-Options"] = "SAMEORIGIN"
            elif is_embedded:
                headers["Content-Security-Policy"] = f"{policy}; frame-ancestors *"
            else:
                headers["Content-Security-Policy"] = f"{policy}; frame-ancestors 'none'"
                headers["X-Frame-Options"] = "DENY"
        await send(message)

    return sending
