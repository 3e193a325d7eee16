"""
The web application: page socket, HTTP API, the built page. Holds the sessions and the worker; starts and
ends them with itself.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import time
from collections.abc import AsyncIterator, Coroutine
from typing import Any
from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import JSONResponse, PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from .bridge import Client
from .budget import Budget
from .config import Config
from .errors import BadInput
from .fleet import Fleet
from .library import example, examples, named_world, world_names
from .live import Lateness
from .pages import Pages
from .places import Places
from .sentences import room_full
from .session import Session
from .wire import page
from .worker.client import State, Worker

__all__ = ["Service", "build_app"]

_POLICY_VIOLATION, _TRY_AGAIN = 1008, 1013
"""WebSocket close codes. RFC 6455, section 7.4.1, and its registry."""

_PAGE_RATE, _ROS_RATE = 100.0, 500.0
"""Messages a second that a page and a ROS client may send for long."""

_COSTLY = 2000
"""Characters that count as another message: long ones are programs and rooms, which cost more to serve."""


class Service:
    """All that lives as long as the application."""

    def __init__(self, config: Config) -> None:
        self.config = config
        self.late = Lateness()
        self.sessions: dict[str, Session] = {}
        self.places = Places(config.limits.runs)
        self.worker = Worker(config, self._worker_changed)
        self.fleet = Fleet(config.robots, time.monotonic, self._robots_changed)

    def _worker_changed(self, state: State) -> None:
        for session in self.sessions.values():
            session.outbox.put(page.WorkerState(state))

    def _robots_changed(self) -> None:
        for session in self.sessions.values():
            session.helm.tell()

    @contextlib.asynccontextmanager
    async def lifespan(self, _app: Starlette) -> AsyncIterator[None]:
        """Keep a worker while the application runs."""
        keeper = asyncio.create_task(self.worker.run())
        try:
            yield
        finally:
            # All at once: a robot that drives must not wait until others stand.
            await asyncio.gather(*(session.close() for session in list(self.sessions.values())))
            keeper.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await keeper

    # Pages

    async def serve_page(self, socket: WebSocket) -> None:
        """One page from hello to goodbye."""
        if not _same_origin(socket):
            await socket.close(_POLICY_VIOLATION)
            return
        await socket.accept()
        if len(self.sessions) >= self.config.limits.sessions:
            full = room_full(self.config.limits.sessions)
            await socket.send_text(page.encode(page.Refusal(full.message, full.hint)))
            await socket.close(_TRY_AGAIN)
            return
        ident = secrets.token_urlsafe(9)
        session = Session(
            ident, self.worker, self.places, self.config.limits, self.late, self.fleet, self.config.speaker
        )
        self.sessions[session.id] = session
        try:
            await _first_of(_receive(socket, session), _send(socket, session), session.outbox.overflowed.wait())
        finally:
            del self.sessions[session.id]
            await session.close()

    async def serve_ros(self, socket: WebSocket) -> None:
        """
        A ROS client of a session's robot. Any page may connect that knows the session's name, which is
        random: that is what lets Foxglove or a learner's own page of roslib in.
        """
        session = self.sessions.get(socket.path_params["session"])
        if session is None or session.bridge.full:
            await socket.close(_POLICY_VIOLATION)
            return
        await socket.accept()
        client = session.join()
        try:
            await _first_of(_receive_ros(socket, session, client), _send_ros(socket, client), session.closed.wait())
        finally:
            session.leave(client)

    # HTTP

    async def health(self, _request: Request) -> Response:
        """State of the worker, number of pages and of runs, lateness of their steps."""
        return JSONResponse(
            {
                "worker": self.worker.state,
                "sessions": len(self.sessions),
                "runs": {"now": self.places.taken, "limit": self.places.limit, "queued": self.places.queued},
                "lateness": self.late.summary(),
            }
        )

    async def list_examples(self, _request: Request) -> Response:
        """Name, title and lesson of each."""
        return JSONResponse(examples(self.config.examples))

    async def one_example(self, request: Request) -> Response:
        """The project as it stands in its file."""
        found = example(self.config.examples, request.path_params["name"])
        if found is None:
            return JSONResponse({"message": "There is no example of that name."}, status_code=404)
        return Response(found, media_type="application/json")

    async def one_world(self, request: Request) -> Response:
        """A room of the gallery."""
        try:
            return JSONResponse(named_world(request.path_params["name"]))
        except BadInput as error:
            return JSONResponse({"message": str(error)}, status_code=404)

    async def list_worlds(self, _request: Request) -> Response:
        """Names."""
        return JSONResponse(world_names())


async def _first_of(*works: Coroutine[Any, Any, object]) -> None:
    """Until one is through; the others are cancelled, and what went wrong is raised."""
    tasks = [asyncio.ensure_future(work) for work in works]
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
    for task in done:
        task.result()


async def _receive(socket: WebSocket, session: Session) -> None:
    """Until the page leaves. One that asks too much at once is read more slowly, so that others get their turn."""
    now = asyncio.get_running_loop().time
    budget = Budget(_PAGE_RATE, 2 * _PAGE_RATE, now())
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text = message.get("text") or message.get("bytes") or ""
        session.receive(text)
        if wait := budget.overdraw(1 + len(text) / _COSTLY, now()):
            await asyncio.sleep(wait)


async def _receive_ros(socket: WebSocket, session: Session, client: Client) -> None:
    now = asyncio.get_running_loop().time
    budget = Budget(_ROS_RATE, _ROS_RATE, now())
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text = message.get("text") or message.get("bytes") or ""
        session.receive_ros(client, text)
        if wait := budget.overdraw(1 + len(text) / _COSTLY, now()):
            await asyncio.sleep(wait)


async def _send_ros(socket: WebSocket, client: Client) -> None:
    try:
        while True:
            await socket.send_text(await client.get())
    except (WebSocketDisconnect, RuntimeError):
        # The client left while something was on its way.
        return


async def _send(socket: WebSocket, session: Session) -> None:
    """Until the page leaves or stops reading."""
    try:
        while True:
            await socket.send_text(page.encode(await session.outbox.get()))
    except (WebSocketDisconnect, RuntimeError):
        # The page left while something was on its way; the receiver notices as well.
        return


def _same_origin(socket: WebSocket) -> bool:
    """Browsers say where a page came from; only our own may drive a session. Other clients say nothing."""
    origin = socket.headers.get("origin")
    return origin is None or urlsplit(origin).netloc == socket.headers.get("host")


async def _no_page(_request: Request) -> Response:
    return PlainTextResponse("The page is not built yet; ./rosy start builds it.", status_code=503)


def build_app(config: Config) -> Starlette:
    """The application; its worker starts with its lifespan."""
    service = Service(config)
    routes: list[BaseRoute] = [
        WebSocketRoute("/api/session", service.serve_page),
        WebSocketRoute("/rosbridge/{session}", service.serve_ros),
        Route("/api/health", service.health),
        Route("/api/examples", service.list_examples),
        Route("/api/examples/{name}", service.one_example),
        Route("/api/worlds", service.list_worlds),
        Route("/api/worlds/{name}", service.one_world),
    ]
    if config.api_docs.is_dir():
        routes.append(Mount("/api-docs", Pages(directory=config.api_docs, html=True)))
    if config.page.is_dir():
        routes.append(Mount("/", Pages(directory=config.page, html=True)))
    else:
        routes.append(Route("/", _no_page))
    app = Starlette(routes=routes, lifespan=service.lifespan)
    app.state.service = service
    return app
