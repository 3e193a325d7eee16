"""
Web application: the page socket, the HTTP API and the built page. Owns the page sessions and the worker, which start
and end with it.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import sys
import time
from collections.abc import AsyncIterator, Callable, Coroutine, Iterable, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.background import BackgroundTask
from starlette.middleware import Middleware
from starlette.middleware.cors import CORSMiddleware
from starlette.requests import HTTPConnection, Request
from starlette.responses import JSONResponse, PlainTextResponse, RedirectResponse, Response, StreamingResponse
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from ..classroom.classroom import Classroom
from ..classroom.hand_in_checks import HandInChecks
from ..classroom.store.class_store import ClassStore
from ..classroom.store.database import StoreError
from ..config import Config
from ..errors import BadInput, RosyError
from ..lessons.catalogue import lesson_json, lesson_list
from ..ownership.robot_registry import RobotRegistry
from ..ownership.run_recorder import RunRecorder
from ..previews.preview_pool import PreviewPool
from ..run.lateness import Lateness
from ..run.problems import address_full, service_full
from ..run.run_queue import RunQueue
from ..run.worker_session import RunServices
from ..sentence import Sentence, tr
from ..terminal_text import neutralize_line
from ..token_bucket import TokenBucket
from ..wire import page
from ..wording import in_terminal
from ..worker.prepared_runs import PreparedRuns
from ..worker.question_scheduler import QuestionScheduler
from ..worker.supervisor import WorkerStatus, WorkerSupervisor
from ..worlds.gallery import named_world, world_names
from .browser_safety import BrowserSafety
from .example_paths import ExamplePaths
from .examples import example_file, examples
from .http_failure import failure
from .pacing.loop_scheduler import LoopScheduler, PageTurns
from .pacing.paced_frames import WRITE
from .pacing.reading_pace import ReadingPace, message_cost
from .pacing.request_turns import RequestTurns
from .recording_upload import receive_recording
from .sessions.page_session import PageSession
from .sessions.ros_bridge import RosClient
from .sockets.address_slots import AddressSlots
from .sockets.class_sockets import ClassSockets
from .sockets.lesson_rehearsals import LessonRehearsals
from .sockets.projector_sockets import ProjectorSockets
from .sockets.room_tests import RoomTests
from .static_pages import StaticPages

__all__ = ["Service", "build_app"]

_POLICY_VIOLATION, _TRY_AGAIN = 1008, 1013
"""WebSocket close codes. RFC 6455, section 7.4.1, and its registry."""

_ROS_RATE = 500.0
"""Messages that a ROS client may send, a second."""


class Service:
    """Everything that lives as long as the application."""

    def __init__(self, config: Config, classroom: Classroom | None = None) -> None:
        self.config = config
        self.sessions: dict[str, PageSession] = {}
        self._slots = AddressSlots(config.limits.sessions, config.limits.address_sessions)
        self.loop_scheduler = LoopScheduler()
        # None without class mode.
        self.classroom = classroom
        # Ends the service, and says why; the server sets it.
        self.end: Callable[[Sentence], None] = lambda _: None
        self.lateness = Lateness()
        self.run_queue = RunQueue(config.limits.runs)
        self.worker = WorkerSupervisor(config, self._on_worker_status)
        self.recorder = RunRecorder(config.recordings, self._tell) if config.records else None
        self.robots = RobotRegistry(
            config.robots, config.robot_executable, time.monotonic, self._on_robots_change, self.recorder
        )
        self.example_paths = ExamplePaths(config.examples, self.worker, self.run_queue, config.limits)
        self.room_tests = RoomTests(config)
        self.lesson_rehearsals = LessonRehearsals(config, self.room_tests.queue)
        self._checks: HandInChecks | None = None
        self._class_sockets: ClassSockets | None = None
        self._projectors: ProjectorSockets | None = None
        if classroom is not None:
            self._checks = HandInChecks(classroom.tasks, config, self.room_tests.queue)
            self._class_sockets = ClassSockets(
                classroom, self._checks, self.sessions, _first_completed, self.loop_scheduler
            )
            self._projectors = ProjectorSockets(classroom, self.sessions, _first_completed, self.loop_scheduler)
        self.previews = PreviewPool(config)
        self.prepared_runs = PreparedRuns(self.worker, config.limits.prepared)
        self._run_services = RunServices(
            self.worker, self.run_queue, config.limits, self.lateness, QuestionScheduler(time.monotonic)
        )

    @staticmethod
    def _tell(sentence: Sentence) -> None:
        """Tell the person who started Rosy."""
        print(f"rosy: {neutralize_line(in_terminal(sentence))}", file=sys.stderr)

    def _on_worker_status(self, status: WorkerStatus) -> None:
        for session in self.sessions.values():
            session.outbox.put(page.WorkerState(status))

    def _on_robots_change(self) -> None:
        for session in self.sessions.values():
            session.ownership.send_robots()

    @contextlib.asynccontextmanager
    async def lifespan(self, _app: Starlette) -> AsyncIterator[None]:
        """Keep a worker while the application runs."""
        supervision = [asyncio.create_task(self.worker.run())]
        if self.classroom is not None:
            supervision.append(asyncio.create_task(self._keep_class(self.classroom)))
        try:
            yield
        finally:
            # Concurrently: no robot keeps driving while others are being stopped.
            await asyncio.gather(*(session.close() for session in list(self.sessions.values())))
            await self.previews.close()
            if self.recorder is not None:
                await self.recorder.close()
            if self._checks is not None:
                await self._checks.cancel()
            if self.classroom is not None:
                await self.classroom.close()
            for task in supervision:
                task.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await task

    async def _keep_class(self, classroom: Classroom) -> None:
        self.end(await classroom.keep_store())

    # Pages

    async def serve_page(self, socket: WebSocket) -> None:
        """Serve one page until it disconnects."""
        if not self._is_our_page(socket):
            await socket.close(_POLICY_VIOLATION)
            return
        address = socket.client.host if socket.client is not None else ""
        turns = PageTurns(self.loop_scheduler, address)
        await socket.accept()
        async with turns.turn():
            session = self._open(address, turns) if self._slots.take(address) else None
        if session is None:
            full = service_full(self._slots.total) if self._slots.is_full else address_full(self._slots.each)
            await socket.send_text(page.encode(page.Refusal(full.message, full.hint, full.sentences)))
            await socket.close(_TRY_AGAIN)
            return
        self.sessions[session.id] = session
        try:
            await _first_completed(
                _receive(socket, session, turns), _send(socket, session), session.outbox.overflowed.wait()
            )
        finally:
            del self.sessions[session.id]
            self._slots.free(address)
            await session.close()

    def _open(self, address: str, turns: PageTurns) -> PageSession:
        in_class = self.classroom is not None
        ident = secrets.token_urlsafe(9)
        return PageSession(
            ident, self._run_services, self.robots, self.previews, self.prepared_runs, turns, in_class, address
        )

    async def serve_ros(self, socket: WebSocket) -> None:
        """
        Serve a ROS client of a session's simulated robot. Any client may connect that knows the session's random name,
        such as Foxglove or a learner's own page with roslib.
        """
        session = self.sessions.get(socket.path_params["session"])
        if session is None or session.bridge.is_full:
            await socket.close(_POLICY_VIOLATION)
            return
        await socket.accept()
        turns = PageTurns(self.loop_scheduler, socket.client.host if socket.client is not None else "")
        client = session.join()
        try:
            await _first_completed(
                _receive_ros(socket, session, client, turns), _send_ros(socket, client), session.closed.wait()
            )
        finally:
            session.leave(client)

    async def serve_room_test(self, socket: WebSocket) -> None:
        """Serve a test in many rooms for the page of a session."""
        session = self.sessions.get(socket.path_params["session"])
        if session is None or not self._is_our_page(socket):
            await socket.close(_POLICY_VIOLATION)
            return
        await socket.accept()
        await self.room_tests.serve(socket, session.id, session.closed, session.safety)
        with contextlib.suppress(RuntimeError, WebSocketDisconnect):
            # The page may have closed it first.
            await socket.close()

    async def serve_lesson_rehearsals(self, socket: WebSocket) -> None:
        """Serve the rehearsals of a lesson for the page of a session."""
        session = self.sessions.get(socket.path_params["session"])
        if session is None or not self._is_our_page(socket):
            await socket.close(_POLICY_VIOLATION)
            return
        await socket.accept()
        await self.lesson_rehearsals.serve(socket, session.id, session.closed)
        with contextlib.suppress(RuntimeError, WebSocketDisconnect):
            # The page may have closed it first.
            await socket.close()

    async def serve_pupil(self, socket: WebSocket) -> None:
        """Serve a pupil's page in class mode."""
        if self._class_sockets is None or not self._is_our_page(socket):
            await socket.close(_POLICY_VIOLATION)
            return
        await self._class_sockets.serve_pupil(socket)

    async def serve_board(self, socket: WebSocket) -> None:
        """Serve the teacher's board in class mode."""
        if self._class_sockets is None or not self._is_our_page(socket):
            await socket.close(_POLICY_VIOLATION)
            return
        await self._class_sockets.serve_board(socket)

    async def serve_projector(self, socket: WebSocket) -> None:
        """Serve a projector in class mode."""
        if self._projectors is None or not self._is_our_page(socket):
            await socket.close(_POLICY_VIOLATION)
            return
        await self._projectors.serve(socket)

    def _is_our_page(self, socket: HTTPConnection) -> bool:
        """Whether a browser reports our own origin, or one of our cluster. Other clients report none."""
        origin = socket.headers.get("origin")
        if origin is None:
            return True
        page = urlsplit(origin).netloc
        return page == socket.headers.get("host") or page in self.config.origins

    # HTTP

    def _class_of_teacher(self, request: Request) -> Classroom | Response:
        """The class for a board that gives the teacher's key; a refusal for others."""
        if self.classroom is None:
            return failure(tr("There is no class."), 404)
        address = request.client.host if request.client is not None else ""
        if not self.classroom.admits_teacher(request.headers.get("x-rosy-key", ""), address):
            return failure(tr("This is not the teacher's key."), 403)
        return self.classroom

    async def backup(self, request: Request) -> Response:
        """Everything that the class stores, as a ZIP file."""
        classroom = self._class_of_teacher(request)
        if isinstance(classroom, Response):
            return classroom
        try:
            file = await classroom.backup()
        except (StoreError, OSError) as error:
            return failure(tr("The class cannot be read or stored: {why}", why=error), 500)
        chunks = iter(lambda: file.read(65536), b"")
        return StreamingResponse(
            chunks,
            media_type="application/zip",
            headers={"Cache-Control": "no-store"},
            background=BackgroundTask(file.close),
        )

    async def receive_recording(self, request: Request) -> Response:
        """Take the file of a recorded run from the page of a session, which looks at it next."""
        session = self.sessions.get(request.path_params["session"])
        if session is None or not self._is_our_page(request):
            return failure(tr("The page is not connected."), 404)
        return await receive_recording(request, session)

    async def hand_ins(self, request: Request) -> Response:
        """What was handed in for a task, as a ZIP file, for a board that gives the teacher's key."""
        classroom = self._class_of_teacher(request)
        if isinstance(classroom, Response):
            return classroom
        found = await classroom.hand_ins_zip(request.path_params["task"])
        if found is None:
            return failure(tr("There is no such task."), 404)
        return Response(found, media_type="application/zip", headers={"Cache-Control": "no-store"})

    async def health(self, _request: Request) -> Response:
        """State of the worker, number of pages and of runs, lateness of their steps."""
        return JSONResponse(
            {
                "worker": self.worker.state,
                "sessions": len(self.sessions),
                "runs": {"now": self.run_queue.running, "limit": self.run_queue.limit, "queued": self.run_queue.queued},
                "lateness": self.lateness.summary(),
            }
        )

    async def metrics(self, _request: Request) -> Response:
        """The same in the text format of Prometheus."""
        lateness = self.lateness.summary()
        values = {
            "rosy_pages": len(self.sessions),
            "rosy_runs": self.run_queue.running,
            "rosy_runs_limit": self.run_queue.limit,
            "rosy_runs_queued": self.run_queue.queued,
            "rosy_worker_ready": int(self.worker.state == "ready"),
            "rosy_store_ready": None if self.classroom is None else int(self.classroom.store_fault() is None),
            **{f"rosy_step_lateness_{name}": value for name, value in lateness.items()},
        }
        lines = [f"# TYPE {name} gauge\n{name} {value}\n" for name, value in values.items() if value is not None]
        return PlainTextResponse("".join(lines), media_type="text/plain; version=0.0.4")

    async def list_examples(self, _request: Request) -> Response:
        """Name, title, lesson and level of each."""
        return JSONResponse(examples(self.config.examples))

    async def one_example(self, request: Request) -> Response:
        """The project as it stands in its file."""
        found = example_file(self.config.examples, request.path_params["name"])
        if found is None:
            return failure(tr("There is no example of that name."), 404)
        return Response(found.read_bytes(), media_type="application/json")

    async def example_path(self, request: Request) -> Response:
        """The world of an example and the path that it drives there."""
        try:
            found = await self.example_paths.path(request.path_params["name"])
        except RosyError as error:
            return failure(error.sentence, 503)
        if found is None:
            return failure(tr("There is no example of that name."), 404)
        return JSONResponse(found)

    async def list_lessons(self, _request: Request) -> Response:
        """Name, course, titles of each, in their order."""
        return await self._lesson_answer(lesson_list)

    async def one_lesson(self, request: Request) -> Response:
        """A lesson with its room, programs and texts."""
        return await self._lesson_answer(lambda folder: lesson_json(folder, request.path_params["name"]))

    async def _lesson_answer(self, read: Callable[[Path], object]) -> Response:
        try:
            found = await asyncio.to_thread(read, self.config.examples / "lessons")
        except BadInput as error:
            return failure(error.sentence, 500)
        if found is None:
            return failure(tr("There is no lesson of that name."), 404)
        return JSONResponse(found)

    async def one_world(self, request: Request) -> Response:
        """A room of the gallery."""
        try:
            return JSONResponse(named_world(request.path_params["name"]))
        except BadInput as error:
            return failure(error.sentence, 404)

    async def list_worlds(self, _request: Request) -> Response:
        """Names."""
        return JSONResponse(world_names())


async def _first_completed(*works: Coroutine[Any, Any, object]) -> None:
    """Wait until one is done; cancel the others, and raise what it raised."""
    tasks = [asyncio.ensure_future(work) for work in works]
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
    for task in done:
        task.result()


async def _receive(socket: WebSocket, session: PageSession, turns: PageTurns) -> None:
    """
    Read until the page disconnects. A page whose messages are too many, or take too long to serve, is read more slowly,
    so that it delays no other.
    """
    now = asyncio.get_running_loop().time
    pace = ReadingPace(now())
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text = message.get("text") or message.get("bytes") or ""
        before = turns.spent
        await session.receive(text)
        if wait := pace.wait(len(text), turns.spent - before, now()):
            await asyncio.sleep(wait)


async def _receive_ros(socket: WebSocket, session: PageSession, client: RosClient, turns: PageTurns) -> None:
    now = asyncio.get_running_loop().time
    limit = TokenBucket(_ROS_RATE, _ROS_RATE, now())
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text = message.get("text") or message.get("bytes") or ""
        async with turns.turn(len(text)):
            session.receive_ros(client, text)
        if wait := limit.overdraw(message_cost(len(text)), now()):
            await asyncio.sleep(wait)


async def _send_ros(socket: WebSocket, client: RosClient) -> None:
    try:
        while True:
            frame = await client.get()
            if isinstance(frame, bytes):
                await socket.send_bytes(frame)
            else:
                await socket.send_text(frame)
    except (WebSocketDisconnect, RuntimeError):
        # The client disconnected during a send.
        return


async def _send(socket: WebSocket, session: PageSession) -> None:
    """Send until the page disconnects or stops reading."""
    write = socket.scope.get("extensions", {}).get(WRITE)
    if write is not None:
        session.outbox.write_with(write)
    try:
        while True:
            await socket.send_text(page.encode(await session.outbox.get()))
    except (WebSocketDisconnect, RuntimeError):
        # The page disconnected during a send; the receiver notices as well.
        return


async def _no_page(_request: Request) -> Response:
    return PlainTextResponse(in_terminal(tr("The page is not built yet; ./rosy start builds it.")), status_code=503)


async def _embed(_request: Request) -> Response:
    """The page as a part of another site. A browser keeps the program behind the ``#`` when it is redirected."""
    return RedirectResponse("./?embed")


async def _board(_request: Request) -> Response:
    """The teacher's board. A browser keeps the key behind the ``#`` when it is redirected."""
    return RedirectResponse("./board.html")


async def _projector(_request: Request) -> Response:
    """The page for the projector, which the board opens."""
    return RedirectResponse("./projector.html")


def _for_pages_of(origins: Iterable[str]) -> list[Middleware]:
    """
    Lets the boards of other services ask for files, with the teacher's key, and their pages send a recording. Fetch
    Standard, "CORS protocol".
    """
    allowed = [f"{scheme}://{origin}" for origin in origins for scheme in ("http", "https")]
    headers = ["X-Rosy-Key"]
    if not allowed:
        return []
    return [Middleware(CORSMiddleware, allow_origins=allowed, allow_headers=headers, allow_methods=["GET", "POST"])]


def build_app(
    config: Config,
    class_store: ClassStore | None = None,
    addresses: Callable[[], list[str]] = list,
    names: Iterable[str] | None = None,
    more: Sequence[BaseRoute] = (),
) -> Starlette:
    """
    The application; its worker starts with its lifespan.

    Args:
        config: paths and limits.
        class_store: the open class of class mode.
        addresses: where pupils reach the service.
        names: host names to serve beside IP addresses; ``None`` for every name.
        more: further routes.
    """
    classroom = Classroom(class_store, addresses, time.monotonic) if class_store is not None else None
    service = Service(config, classroom)
    routes: list[BaseRoute] = [
        WebSocketRoute("/api/session", service.serve_page),
        WebSocketRoute("/rosbridge/{session}", service.serve_ros),
        WebSocketRoute("/api/room-tests/{session}", service.serve_room_test),
        WebSocketRoute("/api/lesson-rehearsals/{session}", service.serve_lesson_rehearsals),
        WebSocketRoute("/api/class", service.serve_pupil),
        WebSocketRoute("/api/board", service.serve_board),
        WebSocketRoute("/api/projector", service.serve_projector),
        Route("/api/health", service.health),
        Route("/api/metrics", service.metrics),
        Route("/api/examples", service.list_examples),
        Route("/api/examples/{name}", service.one_example),
        Route("/api/examples/{name}/path", service.example_path),
        Route("/api/recordings/{session}", service.receive_recording, methods=["POST"]),
        Route("/api/lessons", service.list_lessons),
        Route("/api/lessons/{name}", service.one_lesson),
        Route("/api/worlds", service.list_worlds),
        Route("/api/worlds/{name}", service.one_world),
        *more,
    ]
    routes.append(Route("/embed", _embed))
    if classroom is not None:
        routes.append(Route("/board", _board))
        routes.append(Route("/projector", _projector))
        routes.append(Route("/api/hand-ins/{task:int}", service.hand_ins))
        routes.append(Route("/api/class-backup", service.backup))
    if config.api_docs.is_dir():
        routes.append(Mount("/api-docs", StaticPages(directory=config.api_docs, html=True)))
    if config.page.is_dir():
        routes.append(Mount("/", StaticPages(directory=config.page, html=True)))
    else:
        routes.append(Route("/", _no_page))
    middleware = [
        Middleware(BrowserSafety, names=names),
        *_for_pages_of(config.origins),
        Middleware(RequestTurns, scheduler=service.loop_scheduler),
    ]
    app = Starlette(routes=routes, lifespan=service.lifespan, middleware=middleware)
    app.state.service = service
    return app
