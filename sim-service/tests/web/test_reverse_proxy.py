"""
Caddy with TLS in front of a Rosy with ``--public``, set up as docs/server.md writes it: WebSockets, origins, clients.

`./rosy test` unpacks Caddy from its Debian package into ``.rosy/caddy``; where a release has none this is left out.
"""

from __future__ import annotations

import asyncio
import json
import os
import re
import shutil
import ssl
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import httpx
import pytest
from websockets.asyncio.client import connect
from websockets.exceptions import WebSocketException

from ..conftest import FAKE_WORKER, PATIENCE
from ..ports import kept_port

ROOT = Path(__file__).resolve().parents[3]

CADDY = shutil.which("caddy") or shutil.which(str(ROOT / ".rosy/caddy/usr/bin/caddy"))

pytestmark = pytest.mark.skipif(CADDY is None, reason="Caddy is not there")

NAME = "rosy.example"

# As `start --public` serves, with a route that says who the service takes a client for.
SERVICE = """
import sys
from starlette.responses import PlainTextResponse
from starlette.routing import Route
from rosy_sim.config import discover
from rosy_sim.web.public_address import with_public_address
from rosy_sim.web.server import serve
who = Route("/api/who", lambda request: PlainTextResponse(request.client.host))
config = with_public_address(discover(), sys.argv[1])
sys.exit(serve(config, "127.0.0.1", 0, False, True, lambda port, _: print(port, flush=True), [who]))
"""


@pytest.fixture(scope="module")
def public(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[int, int, ssl.SSLContext]]:
    """Ports of Caddy and of the service behind it, and what trusts Caddy's certificate."""
    folder = tmp_path_factory.mktemp("caddy")
    port = kept_port()
    worker = folder / "worker"
    worker.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{FAKE_WORKER}"\n')
    worker.chmod(0o755)
    environment = {
        **os.environ,
        "PYTHONPATH": str(ROOT / "sim-service"),
        "HOME": str(folder),
        "XDG_DATA_HOME": str(folder),
    }
    environment |= {"XDG_CONFIG_HOME": str(folder), "ROSY_WORKER": str(worker), "ROSY_SANDBOX": "off"}
    with ExitStack() as stack:
        service = stack.enter_context(
            subprocess.Popen(
                [sys.executable, "-c", SERVICE, f"https://{NAME}:{port}"],
                env=environment,
                stdout=subprocess.PIPE,
                text=True,
            )
        )
        stack.callback(service.terminate)
        assert service.stdout is not None
        behind = int(service.stdout.readline())
        written = re.findall(r"^```\n(rosy\.example \{.*?)^```", (ROOT / "docs/server.md").read_text(), re.M | re.S)
        site = (
            written[0]
            .replace("rosy.example", f"https://{NAME}:{port}")
            .replace("127.0.0.1:8080", f"127.0.0.1:{behind}")
        )
        # No certificate of a public authority, and no other port.
        settings = "{\n\tdebug\n\tadmin off\n\tskip_install_trust\n\tauto_https disable_redirects\n}\n"
        (folder / "Caddyfile").write_text(settings + site.replace("{\n", "{\n\ttls internal\n", 1))
        caddy = stack.enter_context(
            subprocess.Popen(
                [str(CADDY), "run", "--config", str(folder / "Caddyfile"), "--adapter", "caddyfile"],
                env=environment,
                stderr=subprocess.PIPE,
                text=True,
            )
        )
        stack.callback(caddy.terminate)
        assert caddy.stderr is not None
        # It serves at once, and makes its certificate meanwhile: a connection before it has that at hand is refused.
        missing = {"serving initial configuration", "added certificate to cache"}
        for line in caddy.stderr:
            missing = {event for event in missing if event not in line}
            if not missing:
                break
        assert not missing
        yield port, behind, ssl.create_default_context(cafile=str(folder / "caddy/pki/authorities/local/root.crt"))


def test_a_client_is_who_the_proxy_says_and_not_who_it_says_itself(public: tuple[int, int, ssl.SSLContext]) -> None:
    port, _, trusted = public
    for address in ("127.0.0.5", "127.0.0.6"):
        transport = httpx.HTTPTransport(verify=trusted, local_address=address)
        with httpx.Client(transport=transport, timeout=PATIENCE) as client:
            answer = client.get(
                f"https://127.0.0.1:{port}/api/who",
                headers={"Host": f"{NAME}:{port}", "X-Forwarded-For": "203.0.113.9"},
                extensions={"sni_hostname": NAME},
            )
        assert answer.text == address


@pytest.mark.parametrize(
    ("origin", "is_admitted"), [(f"https://{NAME}:PORT", True), ("https://elsewhere.example", False)]
)
def test_pages_of_the_public_address_open_a_session_and_others_do_not(
    origin: str, is_admitted: bool, public: tuple[int, int, ssl.SSLContext]
) -> None:
    port, _, trusted = public

    async def first() -> str:
        url = f"wss://{NAME}:{port}/api/session"
        origin_header = origin.replace("PORT", str(port))
        async with connect(url, host="127.0.0.1", ssl=trusted, origin=origin_header, proxy=None) as socket:  # type: ignore[arg-type]
            return str(json.loads(await socket.recv())["op"])

    if is_admitted:
        assert asyncio.run(first()) == "hello"
    else:
        with pytest.raises(WebSocketException):
            asyncio.run(first())


def test_the_service_answers_to_the_public_name_and_to_no_other(public: tuple[int, int, ssl.SSLContext]) -> None:
    _, behind, _ = public
    for host, status in ((NAME, 200), ("elsewhere.example", 421)):
        answer = httpx.get(f"http://127.0.0.1:{behind}/api/health", headers={"Host": host}, timeout=PATIENCE)
        assert answer.status_code == status
