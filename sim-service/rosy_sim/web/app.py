"""
Web application: the routes of the sockets, of the HTTP API and of the built page, over one ``Service``.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.status import WS_1008_POLICY_VIOLATION
from starlette.websockets import WebSocket

from ..classroom.classroom import Classroom
from ..classroom.store.class_store import ClassStore
from ..config import Config
from ..sentences.sentence import tr
from ..sentences.wording import in_terminal
from .browser_safety import BrowserSafety
from .pacing.request_turns import RequestTurns
from .page_origins import PageOrigins
from .routes.catalogue import Catalogue
from .routes.class_files import ClassFiles
from .routes.example_paths import ExamplePaths
from .routes.monitoring import Monitoring
from .routes.network_addresses import NetworkAddresses
from .routes.recordings import RecordingUpload
from .service import Service
from .static_pages import StaticPages

__all__ = ["build_app"]


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
        addresses: where others on the network reach the service.
        names: host names to serve beside IP addresses; ``None`` for every name.
        more: further routes, those of a cluster, whose pages connect to its nodes.
    """
    classroom = Classroom(class_store, addresses, time.monotonic) if class_store is not None else None
    service = Service(config, classroom)
    origins = PageOrigins(config.origins)
    paths = ExamplePaths(config.examples, service.worker, service.budgets.runs, config.limits)
    routes = [
        *_sockets(service, origins),
        *Monitoring(service).routes(),
        *NetworkAddresses(addresses).routes(),
        *Catalogue(config.examples, paths).routes(),
        *RecordingUpload(service.sessions, origins, service.budgets.uploads).routes(),
        *(ClassFiles(classroom, config.examples).routes() if classroom is not None else ()),
        *more,
        *_pages(config),
    ]
    middleware = [
        Middleware(BrowserSafety, names=names, has_nodes=bool(more)),
        *origins.middleware(),
        Middleware(RequestTurns, scheduler=service.loop_scheduler),
    ]
    app = Starlette(routes=routes, lifespan=service.lifespan, middleware=middleware)
    app.state.service = service
    return app


def _sockets(service: Service, origins: PageOrigins) -> list[BaseRoute]:
    classes, projectors = service.class_sockets, service.projectors
    return [
        WebSocketRoute("/rosbridge/{session}", service.ros_clients.serve),
        origins.socket("/api/session", service.pages.serve),
        origins.socket("/api/room-tests/{session}", service.room_tests.serve),
        origins.socket("/api/lesson-rehearsals/{session}", service.lesson_rehearsals.serve),
        origins.socket("/api/class", classes.serve_pupil if classes is not None else _no_class),
        origins.socket("/api/board", classes.serve_board if classes is not None else _no_class),
        origins.socket("/api/projector", projectors.serve if projectors is not None else _no_class),
    ]


def _pages(config: Config) -> list[BaseRoute]:
    """The page last: it takes all paths that are left."""
    routes: list[BaseRoute] = [Route("/embed", _embed)]
    if config.api_docs.is_dir():
        routes.append(Mount("/api-docs", StaticPages(directory=config.api_docs, html=True)))
    if config.page.is_dir():
        routes.append(Mount("/", StaticPages(directory=config.page, html=True)))
    else:
        routes.append(Route("/", _no_page))
    return routes


async def _no_class(socket: WebSocket) -> None:
    await socket.close(WS_1008_POLICY_VIOLATION)


async def _embed(_request: Request) -> Response:
    """The page as a part of another site. A browser keeps the program behind the ``#`` when it is redirected."""
    return RedirectResponse("./?embed")


async def _no_page(_request: Request) -> Response:
    return PlainTextResponse(in_terminal(tr("The page is not built yet; ./rosy start builds it.")), status_code=503)
