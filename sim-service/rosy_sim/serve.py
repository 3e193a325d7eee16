"""
``./rosy start``: binds the port, serves the application until a signal, and leaves nothing behind.

Where the machine cannot build the worker's sandbox, only loopback is served unless the person insists.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import ipaddress
import os
import shutil
import signal
import socket
import sys
import webbrowser
from collections.abc import Iterator

import uvicorn
import uvloop

from .app import build_app
from .config import Config
from .errors import BadInput, WorkerMissing
from .reach import is_everybody, own_addresses
from .worker.launch import sandbox_fault

__all__ = ["serve"]

_ASKED_TWICE = 130
"""Exit status of what Ctrl-C ended, as shells count it: 128 and SIGINT."""

_NICE = -5
"""Priority of the service, and of the worker it starts; 0 is everybody's. setpriority(2)."""


def serve(config: Config, host: str, port: int, open_browser: bool, unprotected: bool) -> int:
    """Serve until SIGINT or SIGTERM; returns the exit status."""
    if not config.worker or shutil.which(config.worker[0]) is None:
        raise WorkerMissing
    fault = sandbox_fault() if config.sandbox else "the sandbox is turned off"
    if fault is not None and not (unprotected or _is_loopback(host)):
        raise BadInput(
            f"Programs cannot be locked in on this machine ({fault}), so Rosy only serves this machine itself; "
            "leave out --host, or add --unprotected when you trust everybody who can reach it."
        )
    listener = _bind(host, port)
    if fault is not None:
        print(f"rosy: programs run without their sandbox: {fault}.", file=sys.stderr)
    bound = listener.getsockname()[1]
    everybody = is_everybody(host)
    shown = "127.0.0.1" if everybody else f"[{host}]" if ":" in host else host
    address = f"http://{shown}:{bound}/"
    others = [f"http://{own}:{bound}/" for own in own_addresses()] if everybody else []
    _go_first()
    app = build_app(config)
    code = app.state.service.fleet.code if config.robots else None
    settings = uvicorn.Config(
        app,
        log_level="warning",
        access_log=False,
        ws="websockets-sansio",
        ws_max_size=config.limits.page_message,
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=2,
        lifespan="on",
        loop="uvloop",
    )
    try:
        with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
            runner.run(_serve(_Server(settings, address, others if everybody else None, open_browser, code), listener))
    finally:
        listener.close()
    return 0


class _Server(uvicorn.Server):
    """Says where it is once it is there."""

    def __init__(
        self, config: uvicorn.Config, address: str, others: list[str] | None, open_browser: bool, code: str | None
    ) -> None:
        super().__init__(config)
        self._address = address
        self._others = others
        self._code = code
        self._open_browser = open_browser

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """A signal ends the service well: unlike uvicorn's own, this does not die of it afterwards."""
        loop = asyncio.get_running_loop()
        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, self._asked_to_end)
        try:
            yield
        finally:
            for number in (signal.SIGINT, signal.SIGTERM):
                loop.remove_signal_handler(number)

    def _asked_to_end(self) -> None:
        if self.should_exit:
            # Asked again: at once. What drives or compiles ends with this process's pipes.
            os._exit(_ASKED_TWICE)
        self.should_exit = True

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """As uvicorn does, then the address."""
        await super().startup(sockets)
        print(f"Rosy is ready at {self._address} (Ctrl-C ends it)", flush=True)
        if self._others:
            print(f"Others on this network open {' or '.join(self._others)}", flush=True)
        elif self._others is not None:
            print("This machine is on no network yet; start Rosy again when it is.", flush=True)
        address = self._address
        if self._code is not None:
            # Behind the hash: a browser keeps that part to itself.
            address += f"#robots={self._code}"
            print(f"Its robots may be driven by whoever knows the code {self._code}: {address}", flush=True)
        if self._open_browser:
            await asyncio.to_thread(webbrowser.open, address)


async def _serve(server: _Server, listener: socket.socket) -> None:
    await server.serve(sockets=[listener])


def _go_first() -> None:
    """Steps must begin on time while browsers and compilers are busy; only an administrator may ask for that."""
    with contextlib.suppress(PermissionError):
        os.setpriority(os.PRIO_PROCESS, 0, _NICE)


def _is_loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def _bind(host: str, port: int) -> socket.socket:
    """
    A listening socket.

    Raises:
        BadInput: the port is taken or out of range, or the host is not ours.
    """
    if not 0 <= port <= 65535:
        raise BadInput(f"There is no port {port}; a port is a number from 0 to 65535.")
    try:
        family = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0][0]
    except (socket.gaierror, UnicodeError) as error:
        raise BadInput(f"There is no address called {host!r} here.") from error
    listener = socket.socket(family, socket.SOCK_STREAM)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((host, port))
        listener.listen(1024)
    except OSError as error:
        listener.close()
        if error.errno == errno.EADDRINUSE:
            raise BadInput(f"Port {port} is in use; choose another with --port, or end what uses it.") from error
        raise BadInput(f"Rosy cannot listen on {host}, port {port}: {error.strerror}.") from error
    listener.set_inheritable(True)
    return listener
