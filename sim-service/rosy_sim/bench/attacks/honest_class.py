"""
Class of honest pupils, as clients of the protocol in a process of their own: each checks, runs, previews and saves with
pauses in between, and a board opens programs. What is asked for and how long each answer takes is the same in every
round.

A request that is refused, or whose answer does not come within ``PATIENCE``, counts as failed.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import random
import time
from collections import defaultdict
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from typing import Any

from websockets.asyncio.client import ClientConnection
from websockets.exceptions import ConnectionClosed

from .page_client import connected

__all__ = ["KINDS", "PATIENCE", "Class", "Round", "run_honest_class"]

KINDS = ("check", "run", "preview", "save", "board")

PATIENCE = 600.0
"""For an answer, s: far above what a person waits."""

_WORK = ["check", "check", "save", "check", "run", "check", "save", "preview"]
"""What a pupil does, over and over, in a random order."""

_PAUSES = (2.0, 6.0)
"""Shortest and longest between two requests of a pupil, s."""

_BOARD_PAUSE = 0.5
"""Between two programs that the teacher opens, s."""

_PREVIEW_SECONDS = 10.0
"""Of the run that is previewed, simulated."""

_PROGRAM = """accelerateNUMBER :: Velocity -> Velocity
accelerateNUMBER (Velocity v w) = Velocity (v + 0.3) 0.4

main = simulate accelerateNUMBER
"""
"""With a name of its own each time, so that no answer is one that was given before."""

Message = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Class:
    """Where the class is, and how it is entered."""

    port: int
    pupils: int
    code: str
    key: str
    robots: str


@dataclass(slots=True)
class Round:
    """What a round has found: times of answers by kind, s, and the requests that failed."""

    times: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    failed: list[str] = field(default_factory=list)
    # When a new page was let in and when its program drove, s.
    entered: float = 0.0
    drove: float = 0.0


class _Socket:
    """A socket that is read all the time; answers are waited for by what they are."""

    def __init__(self, socket: ClientConnection) -> None:
        self._socket = socket
        self._wanted: dict[asyncio.Future[Message], Callable[[Message], bool]] = {}
        self._refused: str | None = None
        self.reading = asyncio.create_task(self._read())

    async def _read(self) -> None:
        with contextlib.suppress(ConnectionClosed, OSError):
            async for text in self._socket:
                # Frames of a run that nothing is asked of are most of all messages.
                if not self._wanted:
                    continue
                message: Message = json.loads(text)
                for answer, is_it in list(self._wanted.items()):
                    if not answer.done() and is_it(message):
                        answer.set_result(message)
        self._refused = "closed"
        for answer in self._wanted:
            if not answer.done():
                answer.set_exception(ConnectionError("closed"))

    async def ask(self, wanted: Callable[[Message], bool], op: str, **fields: Any) -> Message:
        """
        Send a request; its answer.

        Raises:
            TimeoutError: it did not come.
            ConnectionError: the service has closed the socket.
        """
        if self._refused is not None:
            raise ConnectionError(self._refused)
        answer: asyncio.Future[Message] = asyncio.get_running_loop().create_future()
        self._wanted[answer] = wanted
        try:
            await self._socket.send(json.dumps({"op": op, **fields}))
            async with asyncio.timeout(PATIENCE):
                return await answer
        except ConnectionClosed as closed:
            raise ConnectionError(str(closed)) from closed
        finally:
            del self._wanted[answer]


class _Pupil:
    """One page of a pupil with its socket of the class."""

    def __init__(self, number: int, page: _Socket, member: _Socket) -> None:
        self._page = page
        self._member = member
        self.chance = random.Random(number)
        self._count = number * 1_000_000
        self._version = 0

    async def do(self, kind: str) -> str | None:
        """Ask for one thing and wait for its answer; what went wrong."""
        self._count += 1
        number = self._count
        source = _PROGRAM.replace("NUMBER", str(number))
        match kind:
            case "check":
                checked = await self._page.ask(_like(op="checked", id=number), "check", id=number, source=source)
                return "problems" if checked["problems"] else None
            case "preview":
                shown = await self._page.ask(
                    _like(op="previewed", id=number), "preview", id=number, source=source, seconds=_PREVIEW_SECONDS
                )
                return None if shown["ended"] == "time" else str(shown["ended"])
            case "run":
                begun = await self._page.ask(
                    lambda m: m.get("run") == number and (m.get("state") == "ended" or bool(m.get("step"))),
                    "run",
                    **{"run": number, "source": source, "seed": 1, "speed": 1},
                )
                return str(begun["problems"]) if begun["op"] == "state" else None
            case _:
                mark = f"m{number}"
                saved = await self._member.ask(
                    lambda m: m["op"] == "refused" or m.get("mark") == mark,
                    "save",
                    **{"program": "own", "name": "own", "text": source, "reason": "change", "base": self._version},
                    mark=mark,
                )
                self._version = saved.get("version", self._version)
                return None if saved["op"] == "saved" else str(saved)


def _like(**fields: Any) -> Callable[[Message], bool]:
    return lambda message: all(message.get(name) == value for name, value in fields.items())


def run_honest_class(place: Class, talk: Connection) -> None:
    """Enter, say so, and play a round of so many seconds for each number that comes; 0 ends."""
    asyncio.run(_run(place, talk))


async def _run(place: Class, talk: Connection) -> None:
    async with AsyncExitStack() as stack:

        async def opened(path: str) -> _Socket:
            return await stack.enter_async_context(_opened(place, path))

        pupils = []
        for number in range(1, place.pupils + 1):
            page, member = await opened("session"), await opened("class")
            hello = await page.ask(lambda m: m["op"] in ("checked", "refusal"), "check", id=0, source=_PROGRAM)
            assert hello["op"] == "checked", hello
            entered = await member.ask(
                lambda m: m["op"] in ("entered", "refused"),
                "join",
                **{"code": place.code, "nickname": f"pupil {number}", "language": "en"},
            )
            assert entered["op"] == "entered", entered
            pupils.append((entered["pupil"], _Pupil(number, page, member)))
        board = await opened("board")
        await board.ask(_like(op="board"), "unlock", key=place.key)
        talk.send("ready")
        while seconds := await asyncio.to_thread(talk.recv):
            talk.send(await _play(place, [one for _, one in pupils], board, [ident for ident, _ in pupils], seconds))


@asynccontextmanager
async def _opened(place: Class, path: str) -> AsyncIterator[_Socket]:
    async with connected(place.port, path) as connection:
        socket = _Socket(connection)
        try:
            yield socket
        finally:
            socket.reading.cancel()


async def _play(place: Class, pupils: list[_Pupil], board: _Socket, idents: list[int], seconds: float) -> Round:
    """A round: everybody does each thing once at least."""
    found = Round()
    end = time.monotonic() + seconds

    async def measure(kind: str, who: str, work: Awaitable[str | None]) -> None:
        begun = time.monotonic()
        try:
            fault = await work
        except TimeoutError:
            fault = "no answer"
        except ConnectionError as error:
            fault = str(error)
        found.times[kind].append(time.monotonic() - begun)
        if fault is not None:
            found.failed.append(f"{kind} of {who}: {fault}")

    async def learn(number: int, pupil: _Pupil) -> None:
        kinds: list[str] = []
        # Each thing once at least; with little time without pauses.
        kinds_left = pupil.chance.sample(sorted(set(_WORK)), len(set(_WORK)))
        while kinds_left or time.monotonic() < end:
            if not kinds:
                kinds = pupil.chance.sample(_WORK, len(_WORK))
            kind = kinds_left.pop() if kinds_left else kinds.pop()
            if seconds >= sum(_PAUSES):
                await asyncio.sleep(pupil.chance.uniform(*_PAUSES))
            await measure(kind, f"pupil {number}", pupil.do(kind))

    async def teach() -> None:
        turn = 0
        while turn == 0 or time.monotonic() < end:
            pupil = idents[turn % len(idents)]
            turn += 1
            await measure("board", "the teacher", _show(board, pupil))
            await asyncio.sleep(_BOARD_PAUSE)

    async def enter() -> str | None:
        begun = time.monotonic()
        async with _opened(place, "session") as page:
            unlocked = await page.ask(lambda m: m["op"] in ("robots", "refusal"), "unlock", code=place.robots)
            found.entered = time.monotonic() - begun
            if unlocked["op"] == "refusal":
                return str(unlocked["message"])
            newcomer = _Pupil(0, page, page)
            newcomer._count = random.Random(begun).randrange(1_000_000)
            begun = time.monotonic()
            fault = await newcomer.do("run")
            found.drove = time.monotonic() - begun
            return fault

    await asyncio.gather(
        *(learn(number, pupil) for number, pupil in enumerate(pupils, 1)),
        teach(),
        measure("new", "a new page", enter()),
    )
    return found


async def _show(board: _Socket, pupil: int) -> str | None:
    shown = await board.ask(_like(op="program", pupil=pupil), "open", pupil=pupil)
    return None if "text" in shown else str(shown)
