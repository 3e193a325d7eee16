"""
Client of codegen's text service: names, renaming, signatures and layout. ``protocol/README.md``, section 10.

The service is a Node process beside the language server. It is started with the first request, and again after it has
died. Where Node or the built codegen is missing, every request fails with ``TextServiceMissing``.
"""

from __future__ import annotations

import asyncio
import contextlib
import shutil
from pathlib import Path
from typing import TypeVar

import msgspec

from ..errors import RosyError
from ..sentences.sentence import Sentence, tr, verbatim
from ..wire.problem import Edit, Place
from ..worker.background_process import reap
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
    token: Token | None


class Renamed(msgspec.Struct, tag="renamed", tag_field="op", frozen=True):
    """All places of a name, or why it keeps its name."""

    id: int
    edits: list[Edit]
    why: str


class SignatureAnswer(msgspec.Struct, tag="signature", tag_field="op", frozen=True):
    """The call at a place."""

    id: int
    signature: Signature | None


class Formatted(msgspec.Struct, tag="formatted", tag_field="op", frozen=True):
    """The text laid out; ``left`` definitions were left as they are."""

    id: int
    text: str
    left: int


class FailedAnswer(msgspec.Struct, tag="failed", tag_field="op", frozen=True):
    """The request itself was wrong."""

    id: int
    message: str


Answer = CursorAnswer | Renamed | SignatureAnswer | Formatted | FailedAnswer

_ready = msgspec.json.Decoder(Ready)
_answers = msgspec.json.Decoder(Answer)


class TextService:
    """One request at a time; close() ends the process."""

    def __init__(self, command_line: Path) -> None:
        self._command_line = command_line
        self._turn = asyncio.Lock()
        self._process: asyncio.subprocess.Process | None = None
        self._names: list[KnownName] = []
        self._ids = 0

    async def names(self) -> list[KnownName]:
        """Every name of Rosy and the Prelude."""
        async with self._turn:
            await self._started()
            return self._names

    async def token(self, source: str, place: Place) -> Token | None:
        """The token that a place is in or right behind."""
        answer = await self._ask(CursorAnswer, op="cursor", source=source, line=place.line, column=place.column)
        return answer.token

    async def rename(self, source: str, place: Place, name: str) -> Renamed:
        """Edits that rename what stands at a place."""
        return await self._ask(Renamed, op="rename", source=source, line=place.line, column=place.column, name=name)

    async def signature(self, source: str, place: Place, declared: object) -> Signature | None:
        """The call at a place; ``declared`` are the program's own names with their types."""
        answer = await self._ask(
            SignatureAnswer, op="signature", source=source, line=place.line, column=place.column, declared=declared
        )
        return answer.signature

    async def format(self, source: str) -> Formatted:
        """The text in the printer's layout."""
        return await self._ask(Formatted, op="format", source=source)

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
                    answer = _answers.decode(await self._exchange(process, line))
            except (OSError, TimeoutError, ValueError, msgspec.DecodeError) as error:
                await self.close()
                raise TextServiceMissing(tr("its helper program stopped; the next attempt starts it again")) from error
            except asyncio.CancelledError:
                # Its answer would be taken for the next request's.
                await self.close()
                raise
            if not isinstance(answer, kind):
                # Both are faults of the program, not of its user.
                raise TextServiceMissing(
                    verbatim(answer.message if isinstance(answer, FailedAnswer) else "wrong answer")
                )
            return answer

    async def _exchange(self, process: asyncio.subprocess.Process, line: bytes) -> bytes:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(line)
        await process.stdin.drain()
        return await process.stdout.readline()

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
            node, str(self._command_line), "text-service", stdin=pipe, stdout=pipe, limit=_MAX_LINE
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
