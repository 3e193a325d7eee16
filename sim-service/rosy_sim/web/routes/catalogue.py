"""Routes of what a page may open: examples with the paths that they drive, lessons and rooms."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path

from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Route

from ...errors import BadInput, RosyError
from ...lessons.catalogue import lesson_json, lesson_list
from ...lessons.challenges import challenge_json, challenge_list
from ...sentences.sentence import tr
from ...worlds.gallery import named_world, world_names
from .example_paths import ExamplePaths
from .examples import example_file, examples
from .http_failure import failure

__all__ = ["Catalogue"]


class Catalogue:
    """
    Examples, lessons and challenges of a folder, and the rooms of the gallery.

    Args:
        folder: of the examples.
        paths: that the examples drive.
    """

    def __init__(self, folder: Path, paths: ExamplePaths) -> None:
        self._folder = folder
        self._paths = paths

    def routes(self) -> list[BaseRoute]:
        """Below ``/api``."""
        return [
            Route("/api/examples", self._examples),
            Route("/api/examples/{name}", self._example),
            Route("/api/examples/{name}/path", self._example_path),
            Route("/api/lessons", self._lessons),
            Route("/api/lessons/{name}", self._lesson),
            Route("/api/challenges", self._challenges),
            Route("/api/worlds", self._worlds),
            Route("/api/worlds/{name}", self._world),
        ]

    async def _examples(self, _request: Request) -> Response:
        """Name, title, lesson and level of each."""
        return JSONResponse(examples(self._folder))

    async def _example(self, request: Request) -> Response:
        """The project as it stands in its file."""
        found = example_file(self._folder, request.path_params["name"])
        if found is None:
            return failure(tr("There is no example of that name."), 404)
        return Response(found.read_bytes(), media_type="application/json")

    async def _example_path(self, request: Request) -> Response:
        """The world of an example and the path that it drives there."""
        try:
            found = await self._paths.path(request.path_params["name"])
        except RosyError as error:
            return failure(error.sentence, 503)
        if found is None:
            return failure(tr("There is no example of that name."), 404)
        return JSONResponse(found)

    async def _lessons(self, _request: Request) -> Response:
        """Name, course, titles of each, in their order."""
        return await self._lesson_answer(lambda folder: lesson_list(folder / "lessons"))

    async def _lesson(self, request: Request) -> Response:
        """A lesson or a challenge with its room, programs and texts."""
        name = request.path_params["name"]
        return await self._lesson_answer(
            lambda folder: lesson_json(folder / "lessons", name) or challenge_json(folder / "challenges", name)
        )

    async def _challenges(self, _request: Request) -> Response:
        """Name, stars and titles of each, in their order."""
        return await self._lesson_answer(lambda folder: challenge_list(folder / "challenges"))

    async def _lesson_answer(self, read: Callable[[Path], object]) -> Response:
        try:
            found = await asyncio.to_thread(read, self._folder)
        except BadInput as error:
            return failure(error.sentence, 500)
        if found is None:
            return failure(tr("There is no lesson of that name."), 404)
        return JSONResponse(found)

    async def _worlds(self, _request: Request) -> Response:
        """Names."""
        return JSONResponse(world_names())

    async def _world(self, request: Request) -> Response:
        """A room of the gallery."""
        try:
            return JSONResponse(named_world(request.path_params["name"]))
        except BadInput as error:
            return failure(error.sentence, 404)
