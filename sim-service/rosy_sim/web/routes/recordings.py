"""Route of the file of a recorded run that a page sends: kept on the disk, without a name, until the page is gone."""

from __future__ import annotations

import asyncio
import tempfile
from collections.abc import Mapping
from typing import BinaryIO, cast

from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Route

from ...accounting.resources import UPLOAD_SECONDS
from ...accounting.slots import Slots
from ...sentences.sentence import tr
from ..page_origins import PageOrigins
from ..sessions.page_recordings import UploadedFile
from ..sessions.page_session import PageSession
from .http_failure import failure

__all__ = ["MOST_BYTES", "RecordingUpload"]

MOST_BYTES = 50_000_000
"""Of a file: two hours of driving. A choice of ours."""

_NAME_LENGTH = 80


class RecordingUpload:
    """
    Takes the files.

    Args:
        sessions: the page sessions by their random names.
        origins: whose pages may send one.
        space: bytes of all files that are kept at once.
    """

    def __init__(self, sessions: Mapping[str, PageSession], origins: PageOrigins, space: Slots) -> None:
        self._sessions = sessions
        self._origins = origins
        self._space = space

    def routes(self) -> list[BaseRoute]:
        """Below ``/api``."""
        return [Route("/api/recordings/{session}", self._receive, methods=["POST"])]

    async def _receive(self, request: Request) -> Response:
        session = self._sessions.get(request.path_params["session"])
        if session is None or not self._origins.admit(request):
            return failure(tr("The page is not connected."), 404)
        return await _take(request, session, self._space)


async def _take(request: Request, session: PageSession, space: Slots) -> Response:
    """Take a file from the page of a session; the query has its ``name``."""
    name = request.query_params.get("name", "")[:_NAME_LENGTH]
    # Unbuffered: what is written is there for the process that reads it.
    file = UploadedFile(
        cast(BinaryIO, tempfile.TemporaryFile(buffering=0)),  # noqa: SIM115
        space,
        session.client.name,
    )
    refused = await _write(request, session, file, name)
    if refused is not None:
        file.close()
        return refused
    session.recordings.receive(file, name)
    return JSONResponse({})


async def _write(request: Request, session: PageSession, file: UploadedFile, name: str) -> Response | None:
    """Write the body of the request; the failure if it cannot be kept."""
    try:
        async with asyncio.timeout(UPLOAD_SECONDS):
            async for piece in request.stream():
                if file.size + len(piece) > MOST_BYTES:
                    return failure(tr("{path} is too large for a recording of a run.", path=name), 413)
                if not file.reserve(len(piece)):
                    return failure(
                        tr(
                            "There is no room for {path} now: uploaded recordings take all of it. "
                            "Close a page that has one, or try again later.",
                            path=name,
                        ),
                        507,
                    )
                await asyncio.to_thread(file.file.write, piece)
                if session.closed.is_set():
                    break
    except (ClientDisconnect, TimeoutError):
        # One that has disconnected does not read the answer.
        return failure(tr("{path} did not arrive in time. Send it again.", path=name), 408)
    except asyncio.CancelledError:
        file.close()
        raise
    except OSError as error:
        return failure(tr("{path} cannot be written: {why}.", path=name, why=error.strerror or ""), 500)
    return failure(tr("The page is not connected."), 404) if session.closed.is_set() else None
