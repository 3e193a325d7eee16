"""Route of the file of a recorded run that a page sends: kept on the disk, without a name, until the page is gone."""

from __future__ import annotations

import asyncio
import tempfile
from collections.abc import Mapping
from typing import BinaryIO, cast

from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Route

from ...sentences.sentence import tr
from ..page_origins import PageOrigins
from ..sessions.page_session import PageSession
from .http_failure import failure

__all__ = ["MOST_BYTES", "RecordingUpload"]

MOST_BYTES = 50_000_000
"""Of a file: two hours of driving. A choice of ours."""

_NAME_LENGTH = 80


class RecordingUpload:
    """Takes the files; ``sessions`` are the page sessions by their random names."""

    def __init__(self, sessions: Mapping[str, PageSession], origins: PageOrigins) -> None:
        self._sessions = sessions
        self._origins = origins

    def routes(self) -> list[BaseRoute]:
        """Below ``/api``."""
        return [Route("/api/recordings/{session}", self._receive, methods=["POST"])]

    async def _receive(self, request: Request) -> Response:
        session = self._sessions.get(request.path_params["session"])
        if session is None or not self._origins.admit(request):
            return failure(tr("The page is not connected."), 404)
        return await _take(request, session)


async def _take(request: Request, session: PageSession) -> Response:
    """Take a file from the page of a session; the query has its ``name``."""
    name = request.query_params.get("name", "")[:_NAME_LENGTH]
    # Unbuffered: what is written is there for the process that reads it.
    file = cast(BinaryIO, tempfile.TemporaryFile(buffering=0))  # noqa: SIM115
    try:
        size = 0
        async for piece in request.stream():
            size += len(piece)
            if size > MOST_BYTES:
                file.close()
                return failure(tr("{path} is too large for a recording of a run.", path=name), 413)
            await asyncio.to_thread(file.write, piece)
    except (ClientDisconnect, asyncio.CancelledError):
        file.close()
        raise
    except OSError as error:
        file.close()
        return failure(tr("{path} cannot be written: {why}.", path=name, why=error.strerror or ""), 500)
    if session.closed.is_set():
        file.close()
        return failure(tr("The page is not connected."), 404)
    session.recordings.receive(file, name)
    return JSONResponse({})
