"""
Client of codegen's text service: names, renaming, signatures, layout and conflicts. ``protocol/README.md``, section 10.

The service is a Node process beside the language server or ``./rosy check``. It is started with the first request, and
again after it has died. Every answer has the id and the document's version of its request; one with others is dropped:
it belongs to a request that was cancelled. Where Node or the built codegen is missing, every request fails with
``TextServiceMissing``.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import msgspec

from ..errors import RosyError
from ..sentences.sentence import Sentence, tr, verbatim
from ..sentences.wording import machine_wording
from ..wire.problem import Edit, Place, Problem
from ..worker.background_process import reap
from .document import Document, without_surrogates
from .hover import KnownName

__all__ = ["Formatted", "Renamed", "Signature", "TextService", "TextServiceMissing", "Token"]

_T = TypeVar("_T")

PATIENCE = 30.0
"""For one answer, s. A renaming in 2,000 lines takes less than one."""

_MAX_LINE = 64 * 1024 * 1024
"""Longest answer, bytes."""


class TextServiceMissing(RosyError):
    """Node or the built codegen is missing, or the service does not answer."""

    def __init__(self, why: Sentence) -> None:
        super().__init__(tr("Renaming and layout do not work here: {why}.", why=why))
        self.no_conflicts = tr("Conflicts between functions were not looked for: {why}.", why=why)


class Token(msgspec.Struct, frozen=True):
    """A token of the lexer; ``kind`` is ``name``, ``type``, ``comment``, …"""

    kind: str
    start: Place
    end: Place
    text: str


class Signature(msgspec.Struct, frozen=True):
    """The parts of a function's type, and the number of the argument at the cursor, from 0."""

    name: str
    parts: list[str]
    argument: int


class Ready(msgspec.Struct, tag="ready", tag_field="op", frozen=True):
    """The first line."""

    names: list[KnownName]


class CursorAnswer(msgspec.Struct, tag="cursor", tag_field="op", frozen=True):
    """The token at a place."""

    id: int
    version: int | None
    token: Token | None


class Renamed(msgspec.Struct, tag="renamed", tag_field="op", frozen=True):
    """All places of a name, or why it keeps its name."""

    id: int
    version: int | None
    edits: list[Edit]
    why: str


class SignatureAnswer(msgspec.Struct, tag="signature", tag_field="op", frozen=True):
    """The call at a place."""

    id: int
    version: int | None
    signature: Signature | None


class Formatted(msgspec.Struct, tag="formatted", tag_field="op", frozen=True):
    """The text laid out; ``left`` definitions were left as they are."""

    id: int
    version: int | None
    text: str
    left: int


class ConflictsAnswer(msgspec.Struct, tag="conflicts", tag_field="op", frozen=True):
    """A warning for each two functions that override each other's commands."""

    id: int
    version: int | None
    problems: list[Problem]


class FailedAnswer(msgspec.Struct, tag="failed", tag_field="op", frozen=True):
    """The request itself was wrong."""

    id: int
    version: int | None
    message: str


Answer = CursorAnswer | Renamed | SignatureAnswer | Formatted | ConflictsAnswer | FailedAnswer


def _about(document: Document) -> dict[str, object]:
    return {"version": document.version, "source": document.source}


def _at(place: Place) -> dict[str, object]:
    return {"line": place.line, "column": place.column}


_ready = msgspec.json.Decoder(Ready)
_answers = msgspec.json.Decoder(Answer)


class TextService:
    """
    One request at a time; close() ends the process.

    Args:
        language: gives the tag of the language of its sentences when the process is started; the machine's by default.
    """

    def __init__(self, command_line: Path, language: Callable[[], str] = lambda: machine_wording().language) -> None:
        self._command_line = command_line
        self._language = language
        self._turn = asyncio.Lock()
        self._process: asyncio.subprocess.Process | None = None
        self._names: list[KnownName] = []
        self._ids = 0

    async def names(self) -> list[KnownName]:
        """Every name of Rosy and the Prelude."""
        async with self._turn:
            await self._started()
            return self._names

    async def token(self, document: Document, place: Place) -> Token | None:
        """The token that a place is in or right behind."""
        answer = await self._ask(CursorAnswer, op="cursor", **_about(document), **_at(place))
        return answer.token

    async def rename(self, document: Document, place: Place, name: str) -> Renamed:
        """Edits that rename what stands at a place."""
        name = without_surrogates(name)
        return await self._ask(Renamed, op="rename", **_about(document), **_at(place), name=name)

    async def signature(self, document: Document, place: Place, declared: object) -> Signature | None:
        """The call at a place; ``declared`` are the program's own names with their types."""
        answer = await self._ask(SignatureAnswer, op="signature", **_about(document), **_at(place), declared=declared)
        return answer.signature

    async def format(self, document: Document) -> Formatted:
        """The text in the printer's layout."""
        return await self._ask(Formatted, op="format", **_about(document))

    async def conflicts(self, document: Document) -> list[Problem]:
        """Functions that override each other's commands, as warnings in the service's language."""
        answer = await self._ask(ConflictsAnswer, op="conflicts", **_about(document))
        return answer.problems

    async def close(self) -> None:
        """End the process."""
        process, self._process = self._process, None
        if process is not None:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
            await reap(process)

    async def _ask(self, kind: type[_T], **request: object) -> _T:
        async with self._turn:
            process = await self._started()
            self._ids += 1
            line = msgspec.json.encode({"id": self._ids, **request}) + b"\n"
            try:
                async with asyncio.timeout(PATIENCE):
                    answer = await self._exchange(process, line, (self._ids, request["version"]))
            except (OSError, TimeoutError, ValueError, msgspec.DecodeError) as error:
                await self.close()
                raise TextServiceMissing(tr("its helper program stopped; the next attempt starts it again")) from error
            if not isinstance(answer, kind):
                # Both are faults of the program, not of its user.
                raise TextServiceMissing(
                    verbatim(answer.message if isinstance(answer, FailedAnswer) else "wrong answer")
                )
            return answer

    async def _exchange(self, process: asyncio.subprocess.Process, line: bytes, about: tuple[int, object]) -> Answer:
        assert process.stdin is not None
        assert process.stdout is not None
        # As a whole: a request that is cancelled meanwhile does not cut the line.
        process.stdin.write(line)
        await process.stdin.drain()
        while True:
            answer: Answer = _answers.decode(await process.stdout.readline())
            if (answer.id, answer.version) == about:
                return answer

    async def _started(self) -> asyncio.subprocess.Process:
        if self._process is not None and self._process.returncode is None:
            return self._process
        node = shutil.which("node")
        if node is None:
            raise TextServiceMissing(tr("Node is not installed"))
        if not self._command_line.exists():
            raise TextServiceMissing(tr("the conversions between blocks and Haskell are not built"))
        pipe = asyncio.subprocess.PIPE
        process = await asyncio.create_subprocess_exec(
            node,
            str(self._command_line),
            "text-service",
            stdin=pipe,
            stdout=pipe,
            limit=_MAX_LINE,
            env={**os.environ, "ROSY_LOCALE": self._language()},
        )
        self._process = process
        try:
            async with asyncio.timeout(PATIENCE):
                assert process.stdout is not None
                self._names = _ready.decode(await process.stdout.readline()).names
        except (TimeoutError, msgspec.DecodeError) as error:
            await self.close()
            raise TextServiceMissing(tr("its helper program does not start")) from error
        except asyncio.CancelledError:
            await self.close()
            raise
        return process
