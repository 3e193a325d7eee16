"""Routes of class mode: its pages, and files that a board downloads with the teacher's key."""

from __future__ import annotations

import re
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import IO

from starlette.background import BackgroundTask
from starlette.requests import Request
from starlette.responses import RedirectResponse, Response, StreamingResponse
from starlette.routing import BaseRoute, Route

from ...classroom.classroom import Classroom
from ...classroom.store.database import StoreError
from ...errors import BadInput
from ...lessons.catalogue import lesson_names
from ...sentences.sentence import tr
from .http_failure import failure

__all__ = ["ClassFiles"]

_NUMBER = re.compile(r"[0-9]{1,9}")
"""Of a task; Starlette's own reader of numbers fails on one that is too long."""


class ClassFiles:
    """
    Of a running class.

    Args:
        classroom: the class.
        examples: the folder of the examples, with the lessons.
    """

    def __init__(self, classroom: Classroom, examples: Path) -> None:
        self._classroom = classroom
        self._examples = examples

    def routes(self) -> list[BaseRoute]:
        """The pages, and the files below ``/api``."""
        return [
            Route("/board", _board),
            Route("/projector", _projector),
            Route("/api/hand-ins/{task}", self._hand_ins),
            Route("/api/class-backup", self._backup),
            Route("/api/class-study", self._study),
        ]

    async def _hand_ins(self, request: Request) -> Response:
        """What was handed in for a task, as a ZIP file."""
        if refused := self._refusal(request):
            return refused
        task = request.path_params["task"]
        found = await self._classroom.hand_ins_zip(int(task)) if _NUMBER.fullmatch(task) else None
        if found is None:
            return failure(tr("There is no such task."), 404)
        return Response(found, media_type="application/zip", headers={"Cache-Control": "no-store"})

    async def _backup(self, request: Request) -> Response:
        """Everything that the class stores, as a ZIP file."""
        return await self._zip(request, self._classroom.backup)

    async def _study(self, request: Request) -> Response:
        """What a study of the class may use, as a ZIP file."""

        async def make() -> IO[bytes]:
            return await self._classroom.study_export(lesson_names(self._examples / "lessons"))

        return await self._zip(request, make)

    async def _zip(self, request: Request, make: Callable[[], Awaitable[IO[bytes]]]) -> Response:
        if refused := self._refusal(request):
            return refused
        try:
            file = await make()
        except BadInput as error:
            return failure(error.sentence, 409)
        except (StoreError, OSError) as error:
            return failure(tr("The class cannot be read or stored: {why}", why=error), 500)
        return StreamingResponse(
            iter(lambda: file.read(65536), b""),
            media_type="application/zip",
            headers={"Cache-Control": "no-store"},
            background=BackgroundTask(file.close),
        )

    def _refusal(self, request: Request) -> Response | None:
        """For all but boards that give the teacher's key."""
        address = request.client.host if request.client is not None else ""
        if self._classroom.authenticator.admits_teacher(request.headers.get("x-rosy-key", ""), address):
            return None
        return failure(tr("This is not the teacher's key."), 403)


async def _board(request: Request) -> Response:
    """The teacher's board. A browser keeps the key behind the ``#`` when it is redirected."""
    return _page("./board.html", request)


async def _projector(request: Request) -> Response:
    """The page for the projector, which the board opens."""
    return _page("./projector.html", request)


def _page(address: str, request: Request) -> Response:
    """To a page, with what the address asks of it, such as its language."""
    query = request.url.query
    return RedirectResponse(f"{address}?{query}" if query else address)
