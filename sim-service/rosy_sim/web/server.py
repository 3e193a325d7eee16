"""
Server of ``./rosy start``: binds the port and serves the application until a signal.

On a machine that cannot build the worker's sandbox, only loopback is served unless ``--unprotected`` is given.
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
import time
import webbrowser
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import uvicorn
import uvloop
from starlette.routing import BaseRoute
from starlette.types import ASGIApp, Receive, Scope, Send

from ..classroom.command import deleted_sentence
from ..classroom.store.class_places import class_place, remove_expired
from ..classroom.store.class_store import Admission
from ..config import Config
from ..errors import BadInput, WorkerMissing
from ..garbage_collection import keep_what_is_loaded
from ..sentences.sentence import Argument, Sentence, tr
from ..sentences.wording import in_terminal
from ..worker.launcher import missing_sandbox, sandbox_warning
from .app import build_app
from .browser_safety import own_names
from .lan_addresses import is_unspecified, lan_addresses
from .memory_shortage import MemoryShortage
from .pacing.paced_frames import paced_frames
from .pacing.request_deadline import RequestDeadline
from .public_address import public_names
from .qr_code import qr_code_lines

__all__ = ["raise_priority", "serve"]

_INTERRUPTED = 130
"""Exit status of what Ctrl-C ended, as shells count it: 128 and SIGINT."""

_NICE = -5
"""Priority of the service, and of the worker it starts; 0 is the default. setpriority(2)."""


def serve(
    config: Config,
    host: str,
    port: int | range,
    open_browser: bool,
    unprotected: bool,
    announce: Callable[[int, Admission | None], None] | None = None,
    more: Sequence[BaseRoute] = (),
) -> int:
    """
    Serve until SIGINT or SIGTERM; returns the exit status.

    Args:
        port: where it listens; of a range, on the first that is free.
        announce: called with the port when the service is ready, in place of a greeting on the terminal.
        more: further routes.
    """
    if not config.worker or shutil.which(config.worker[0]) is None:
        raise WorkerMissing
    fault = missing_sandbox(config)
    # A proxy on this machine brings others to it.
    is_private = _is_loopback(host) and config.public is None
    if fault is not None and not (unprotected or is_private):
        raise BadInput(
            tr(
                "Programs cannot be locked in on this machine ({fault}), so Rosy only serves this machine "
                "itself; leave out --host, or add --unprotected when you trust all who can reach it.",
                fault=fault,
            )
        )
    listener = _bind(host, port) if isinstance(port, int) else _bind_first(host, port)
    if fault is not None:
        print(f"rosy: {in_terminal(sandbox_warning(fault))}", file=sys.stderr)
    bound = listener.getsockname()[1]
    is_any = is_unspecified(host)
    shown = "127.0.0.1" if is_any else f"[{host}]" if ":" in host else host
    address = f"http://{shown}:{bound}/" if config.public is None else f"{config.public}/"
    is_any = is_any and config.public is None

    def addresses() -> list[str]:
        if config.class_address is not None:
            return [config.class_address]
        return [f"http://{own}:{bound}/" for own in lan_addresses()] if is_any else [address]

    raise_priority()
    with contextlib.ExitStack() as stack:
        stack.callback(listener.close)
        classes = class_place(config.classes, config.class_database)
        if config.class_name:
            # A failure keeps no class from its lesson; ./rosy class reports it.
            with contextlib.suppress(BadInput):
                remove_expired(classes, time.time())
                for deleted in classes.deleted():
                    if deleted.announced is not None:
                        _say(deleted_sentence(deleted))
        store = stack.enter_context(classes.open(config.class_name)) if config.class_name else None
        app = build_app(config, store, addresses, own_names(host) | public_names(config), more)
        code = app.state.service.robots.code if config.robots or config.nearby else None
        admission = store.admission() if store else None
        is_shared = is_any or (config.public is not None and admission is not None)
        greet = _Greeting(address, addresses() if is_shared else None, code, admission, config.simulator_address).print
        if announce is not None:
            greet = partial(_announced, announce, bound, admission, address)
        shortage = MemoryShortage()
        server = _Server(_settings(shortage.around(app), config), greet, open_browser)
        app.state.service.end = server.end
        with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
            shortage.watch(runner.get_loop())
            runner.run(_serve(server, listener))
        if server.fault is not None:
            raise BadInput(server.fault)
    return 0


def _announced(
    announce: Callable[[int, Admission | None], None], port: int, admission: Admission | None, address: str
) -> str:
    announce(port, admission)
    return address


def _settings(app: ASGIApp, config: Config) -> uvicorn.Config:
    return uvicorn.Config(
        _without_cancellations(app),
        log_level="warning",
        access_log=False,
        # The address of a client is that of its connection, unless the person who starts Rosy names a proxy.
        proxy_headers=bool(config.proxies),
        forwarded_allow_ips=list(config.proxies),
        http=RequestDeadline,
        ws=paced_frames(),
        ws_max_size=config.limits.page_message,
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=2,
        lifespan="on",
        loop="uvloop",
    )


def _without_cancellations(app: ASGIApp) -> ASGIApp:
    """
    The application, whose requests end quietly when they are cancelled. uvicorn cancels those that are still open some
    seconds after the service was ended, and would log a traceback for each.
    """

    async def serve(scope: Scope, receive: Receive, send: Send) -> None:
        try:
            await app(scope, receive, send)
        except asyncio.CancelledError:
            if scope["type"] == "lifespan":
                raise

    return serve


@dataclass(frozen=True, slots=True)
class _Greeting:
    """What is printed when the service is ready."""

    address: str
    # Addresses for others; None when only this machine is served.
    others: list[str] | None
    robots_code: str | None
    # Code and key of the class; None without class mode.
    admission: Admission | None
    # Where the simulated robot is on ROS 2.
    simulator_address: str | None

    def print(self) -> str:
        """Print it; returns the address to open here."""
        _say(tr("Rosy is ready at {address} (Ctrl-C ends it)", address=self.address))
        if self.simulator_address is not None:
            _say(
                tr(
                    "The robot of the page that you open first is on ROS 2 too, at {address}: "
                    "it reads /cmd_vel and publishes /odom.",
                    address=self.simulator_address,
                )
            )
        if self.admission is not None:
            return self._print_class(self.admission)
        if self.others:
            _say(tr("Others on this network open {addresses}", addresses=_any_of(self.others)))
        elif self.others is not None:
            _say(_NO_NETWORK)
        if self.robots_code is None:
            return self.address
        # Behind the hash: a browser keeps that part to itself.
        address = f"{self.address}#robots={self.robots_code}"
        _say(
            tr(
                "Its robots may be driven with the code {code}: {address}",
                code=self.robots_code,
                address=address,
            )
        )
        return address

    def _print_class(self, admission: Admission) -> str:
        if self.others:
            # The code behind the hash saves typing it.
            print(qr_code_lines(f"{self.others[0]}#class={admission.code}"), flush=True)
            _say(tr("Pupils open     {addresses}", addresses=_any_of(self.others)))
        elif self.others is not None:
            _say(_NO_NETWORK)
        else:
            _say(tr("Pupils open     {addresses}", addresses=self.address))
        _say(tr("Class code      {code}", code=admission.code))
        board = f"{self.address}board#key={admission.teacher_key}"
        _say(tr("Teacher's board {address}", address=board))
        _say(tr("Keep the board's address to yourself: its key shows all programs."))
        if self.robots_code is not None:
            _say(tr("Code of the robots: {code}", code=self.robots_code))
        return board


_NO_NETWORK = tr("This machine is on no network yet; start Rosy again when it is.")


def _any_of(addresses: list[str]) -> Argument:
    """The first, or one of the others."""
    first, *rest = addresses
    return tr("{one} or {other}", one=first, other=_any_of(rest)) if rest else first


def _say(sentence: Sentence) -> None:
    print(in_terminal(sentence), flush=True)


class _Server(uvicorn.Server):
    """Says when it is ready."""

    def __init__(self, config: uvicorn.Config, greet: Callable[[], str], open_browser: bool) -> None:
        super().__init__(config)
        self._greet = greet
        self._open_browser = open_browser
        # Why it ended by itself.
        self.fault: Sentence | None = None

    def end(self, why: Sentence) -> None:
        """End, for a reason."""
        self.fault = why
        self.should_exit = True

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """End the service normally on a signal; uvicorn's own handler would raise it again afterwards."""
        loop = asyncio.get_running_loop()
        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, self._request_exit)
        try:
            yield
        finally:
            for number in (signal.SIGINT, signal.SIGTERM):
                loop.remove_signal_handler(number)

    def _request_exit(self) -> None:
        if self.should_exit:
            # The second signal ends the process at once; its children end when their pipes close.
            os._exit(_INTERRUPTED)
        self.should_exit = True

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """As uvicorn does, then the address."""
        await super().startup(sockets)
        address = self._greet()
        if self._open_browser:
            await asyncio.to_thread(webbrowser.open, address)


async def _serve(server: _Server, listener: socket.socket) -> None:
    keep_what_is_loaded()
    await server.serve(sockets=[listener])


def raise_priority() -> None:
    """Raise the priority, so that steps begin on time beside browsers and compilers. Needs administrator rights."""
    with contextlib.suppress(PermissionError):
        os.setpriority(os.PRIO_PROCESS, 0, _NICE)


def _is_loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def _bind_first(host: str, ports: range) -> socket.socket:
    """A listening socket on the first port that is free; raises as ``_bind`` does for the last one."""
    for port in ports[:-1]:
        with contextlib.suppress(BadInput):
            return _bind(host, port)
    return _bind(host, ports[-1])


def _bind(host: str, port: int) -> socket.socket:
    """
    A listening socket.

    Raises:
        BadInput: the port is taken or out of range, or the host is not ours.
    """
    if not 0 <= port <= 65535:
        raise BadInput(tr("There is no port {port}; a port is a number from 0 to 65535.", port=port))
    try:
        family = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0][0]
    except (socket.gaierror, UnicodeError) as error:
        raise BadInput(tr("There is no address called {host} here.", host=repr(host))) from error
    listener = socket.socket(family, socket.SOCK_STREAM)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((host, port))
        listener.listen(1024)
    except OSError as error:
        listener.close()
        if error.errno == errno.EADDRINUSE:
            raise BadInput(
                tr("Port {port} is in use; choose another with --port, or end what uses it.", port=port)
            ) from error
        raise BadInput(
            tr("Rosy cannot listen on {host}, port {port}: {why}.", host=host, port=port, why=error.strerror or "")
        ) from error
    listener.set_inheritable(True)
    return listener
