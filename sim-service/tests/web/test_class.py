"""Class mode over real sockets: joining, saving, the board, and attempts at what is another's."""

from __future__ import annotations

import asyncio
import io
import json
import zipfile
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import replace
from typing import Any

import httpx
import pytest
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import InvalidStatus

from rosy_sim.classroom import authentication
from rosy_sim.classroom.store.class_folder import open_class
from rosy_sim.config import Config
from rosy_sim.web.service import Service
from rosy_sim.web.sockets import class_connection

from ..conftest import PATIENCE, UNHURRIED
from .page_client import serving

Message = dict[str, Any]


class Client:
    """A page or a board that remembers what it was told."""

    def __init__(self, socket: ClientConnection) -> None:
        self.socket = socket
        self.seen: list[Message] = []

    async def send(self, op: str, **fields: Any) -> None:
        await self.socket.send(json.dumps({"op": op, **fields}))

    async def op(self, *ops: str, such: Callable[[Message], bool] = lambda _: True) -> Message:
        """The next message of one of these kinds."""
        async with asyncio.timeout(PATIENCE):
            while True:
                message: Message = json.loads(await self.socket.recv())
                self.seen.append(message)
                if message["op"] in ops and such(message):
                    return message


class Class:
    """A running class."""

    def __init__(self, address: str, code: str, key: str, stack: AsyncExitStack, service: Service) -> None:
        self.address = address
        self.service = service
        self.code = code
        self.key = key
        self._stack = stack

    async def open(self, path: str = "class", **options: Any) -> Client:
        url = f"ws://{self.address}/api/{path}"
        return Client(await self._stack.enter_async_context(connect(url, **{**UNHURRIED, **options})))

    async def pupil(self, nickname: str) -> tuple[Client, Message]:
        client = await self.open()
        await client.send("join", code=self.code, nickname=nickname, language="en")
        return client, await client.op("entered")

    async def board(self) -> Client:
        client = await self.open("board")
        await client.send("unlock", key=self.key)
        await client.op("board")
        return client


@asynccontextmanager
async def teaching(config: Config) -> AsyncIterator[Class]:
    """A class, in whose folder an earlier one may have left its store."""
    with open_class(config.classes, "7b") as store:
        admission = store.admission()
        async with serving(config, store) as (address, service), AsyncExitStack() as stack:
            yield Class(address, admission.code, admission.teacher_key, stack, service)


def in_class(config: Config, lesson: Callable[[Class], Awaitable[None]]) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            await lesson(opened)

    asyncio.run(run())


async def save(client: Client, text: str, base: int = 0, **more: Any) -> Message:
    request = {"program": "p", "name": "walk", "reason": "change", "mark": f"m{len(text)}", "base": base, **more}
    await client.send("save", text=text, **request)
    return await client.op("saved", "conflict", "unsaved", "refused")


def test_a_class_is_named_before_anything_else_by_an_identifier_that_stays(config: Config) -> None:
    found: list[str] = []

    async def lesson(opened: Class) -> None:
        first = json.loads(await (await opened.open()).socket.recv())
        assert first["op"] == "class"
        assert opened.code not in first["id"]
        found.append(first["id"])

    in_class(config, lesson)
    in_class(config, lesson)
    in_class(replace(config, classes=config.classes / "elsewhere"), lesson)
    first, again, other = found
    assert first == again != other


def test_progress_in_lessons_is_of_the_pupil_on_every_device_and_on_the_board(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("=Ada")
        ben, _ = await opened.pupil("Ben")
        assert entered["progress"] == {}
        board = await opened.board()
        bump = {"lesson": "bump", "title": "Bump!", "steps": 5}
        await ada.send("progress", **bump, done=["guess", "run"])
        await ada.send("progress", **bump, done=["make"])
        shown = await board.op("lessons", such=lambda m: bool(m["lessons"]) and m["lessons"][0][3] == 3)
        assert shown["lessons"] == [[entered["pupil"], "bump", "Bump!", 3, 5]]
        again = await opened.open()
        await again.send("resume", code=opened.code, words=entered["words"])
        assert (await again.op("entered"))["progress"] == {"bump": ["guess", "run", "make"]}
        async with httpx.AsyncClient(base_url=f"http://{opened.address}", timeout=PATIENCE) as http:
            answer = await http.get("/api/class-backup", headers={"X-Rosy-Key": opened.key})
        with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
            table = archive.read("lessons.csv").decode("utf-8-sig").splitlines()
        assert table == ['"pupil","Bump!"', '"\'=Ada","3 of 5"', '"Ben",""']
        words.append(entered["words"])
        await ben.send("progress", **bump, done=["x"] * 101)
        assert (await ben.op("refused"))["reason"] == "request"

    async def next_day(opened: Class) -> None:
        ada = await opened.open()
        await ada.send("resume", code=opened.code, words=words[0])
        assert (await ada.op("entered"))["progress"] == {"bump": ["guess", "run", "make"]}

    words: list[str] = []
    in_class(config, lesson)
    in_class(config, next_day)


def test_a_pupil_continues_on_another_device_with_three_words(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        first, entered = await opened.pupil("Ada")
        assert len(entered["words"].split()) == 3
        saved = await save(first, "one")
        second = await opened.open()
        await second.send("resume", code=opened.code.upper(), words=entered["words"].upper())
        again = await second.op("entered")
        assert (again["pupil"], again["nickname"]) == (entered["pupil"], "Ada")
        assert [(p["id"], p["name"], p["version"]) for p in again["programs"]] == [("p", "walk", saved["version"])]
        await second.send("read", program="p")
        assert (await second.op("program"))["text"] == "one"
        # Both devices are let in again by their own tokens.
        assert again["token"] != entered["token"]
        for token in (entered["token"], again["token"]):
            third = await opened.open()
            await third.send("enter", token=token)
            assert (await third.op("entered"))["token"] is None

    in_class(config, lesson)


def test_a_class_is_as_it_was_when_its_service_starts_again(config: Config) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            client, entered = await opened.pupil("Ada")
            await save(client, "one")
            code = opened.code
        async with teaching(config) as opened:
            assert opened.code == code
            client = await opened.open()
            await client.send("enter", token=entered["token"])
            assert (await client.op("entered"))["programs"][0]["name"] == "walk"
            board = await opened.board()
            (shown,) = (await board.op("pupils"))["pupils"]
            assert (shown["nickname"], shown["program"]) == ("Ada", "walk")

    asyncio.run(run())


def test_two_devices_conflict_and_nothing_is_lost(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        first, entered = await opened.pupil("Ada")
        base = (await save(first, "one"))["version"]
        second = await opened.open()
        await second.send("enter", token=entered["token"])
        await second.op("entered")
        newer = await save(second, "two", base)
        conflict = await save(first, "three", base)
        assert (conflict["op"], conflict["text"], conflict["version"]) == ("conflict", "two", newer["version"])
        assert (await save(first, "three", program="p-2"))["op"] == "saved"

    in_class(config, lesson)


def test_a_pupil_reaches_no_other_pupils_work(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, _ = await opened.pupil("Ada")
        ben, entered = await opened.pupil("Ben")
        await save(ada, "of Ada", program="adas")
        # The same identifier is a program of one's own.
        assert (await save(ben, "of Ben", program="adas"))["op"] == "saved"
        await ben.send("read", program="adas")
        assert (await ben.op("program"))["text"] == "of Ben"
        # An identifier of another pupil, forged into every request, is not read.
        await ben.send("read", program="adas", pupil=entered["pupil"] - 1)
        assert (await ben.op("program"))["text"] == "of Ben"
        # Requests of the board are none of a pupil's socket.
        await ben.send("open", pupil=entered["pupil"] - 1, program="adas")
        assert (await ben.op("refused", "program"))["reason"] == "request"
        assert "of Ada" not in json.dumps(ben.seen)

    in_class(config, lesson)


def test_a_stolen_class_code_opens_an_empty_desk_only(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, _ = await opened.pupil("Ada")
        await save(ada, "of Ada")
        thief = await opened.open()
        await thief.send("save", program="p", name="x", text="x", reason="change", base=0, mark="m")
        assert (await thief.op("refused"))["reason"] == "token"
        await thief.send("read", program="p")
        assert (await thief.op("refused"))["reason"] == "token"
        await thief.send("resume", code=opened.code, words="apple apple apple")
        assert (await thief.op("refused"))["reason"] == "words"
        await thief.send("enter", token="1")
        assert (await thief.op("refused"))["reason"] == "token"
        await thief.send("join", code=opened.code, nickname="ADA")
        assert (await thief.op("refused"))["reason"] == "taken"
        await thief.send("join", code=opened.code, nickname="Thief")
        assert (await thief.op("entered"))["programs"] == []

    in_class(config, lesson)


@pytest.mark.parametrize(
    ("nickname", "reason"),
    [
        ("", "nickname-empty"),
        ("x" * 25, "nickname-long"),
        ("\u202eadA", "nickname-letters"),
        ("a\x00", "nickname-letters"),
    ],
)
def test_a_hostile_nickname_is_refused(config: Config, nickname: str, reason: str) -> None:
    async def lesson(opened: Class) -> None:
        client = await opened.open()
        await client.send("join", code=opened.code, nickname=nickname)
        assert (await client.op("refused"))["reason"] == reason

    in_class(config, lesson)


def test_markup_in_a_nickname_reaches_the_board_as_text(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        await opened.pupil("<img src=x>")
        board = await opened.board()
        (shown,) = (await board.op("pupils"))["pupils"]
        assert shown["nickname"] == "<img src=x>"

    in_class(config, lesson)


def test_guessing_is_limited_and_those_who_know_the_code_still_enter(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        guesser = await opened.open()
        _, entered = await opened.pupil("Ada")
        reasons = []
        for n in range(12):
            await guesser.send("join", code=f"wrong{n}", nickname="Eve")
            reasons.append((await guesser.op("refused"))["reason"])
        assert reasons[:9] == ["code"] * 9
        assert reasons[-1] == "attempts"
        assert entered["nickname"] == "Ada"

    in_class(config, lesson)


def test_the_right_key_enters_however_many_wrong_ones_were_tried(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        _, entered = await opened.pupil("Ada")
        guessers = [await opened.open("board"), await opened.open("projector"), await opened.open("board")]
        for n in range(15):
            for guesser in guessers:
                await guesser.send("unlock", key=f"wrong {n}")
                last = await guesser.op("refused")
        assert last["reason"] == "attempts"
        await opened.board()
        # A device that has been in the class is let in as well.
        page = await opened.open()
        await page.send("enter", token=entered["token"])
        assert (await page.op("entered", "refused"))["op"] == "entered"

    in_class(config, lesson)


@pytest.mark.parametrize("path", ["board", "projector"])
def test_boards_without_the_key_take_no_place_from_one_that_has_it(config: Config, path: str) -> None:
    async def lesson(opened: Class) -> None:
        teacher = await opened.board()
        silent = [await opened.open(path) for _ in range(15)]
        # Each newcomer takes the place of the oldest that gave no key.
        async with asyncio.timeout(PATIENCE):
            for client in silent[:5]:
                await client.socket.wait_closed()
        assert all(client.socket.close_code is None for client in silent[5:])
        await opened.board()
        await teacher.send("attention", message="Eyes up!")
        await opened.pupil("Ada")
        await teacher.op("pupils", such=lambda m: bool(m["pupils"]))

    in_class(config, lesson)


@pytest.mark.parametrize("path", ["board", "projector"])
def test_a_board_that_gives_no_key_is_closed_and_one_that_gave_it_stays(
    config: Config, path: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def lesson(opened: Class) -> None:
        teacher = await opened.board()
        # The teacher's board has given its key, however slow the machine is.
        monkeypatch.setattr(class_connection, "LOCKED_SECONDS", 0.05)
        silent = await opened.open(path)
        async with asyncio.timeout(PATIENCE):
            await silent.socket.wait_closed()
        assert silent.socket.close_code == 1008
        await opened.pupil("Ada")
        await teacher.op("pupils", such=lambda m: bool(m["pupils"]))

    in_class(config, lesson)


def test_thirty_pupils_behind_one_address_enter_at_once(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        async def enters(request: Message) -> Message:
            client = await opened.open()
            await client.send(**request)
            return await client.op("entered", "refused")

        joins = [{"op": "join", "code": opened.code, "nickname": f"pupil {n}"} for n in range(30)]
        joined = await asyncio.gather(*map(enters, joins))
        assert {answer["op"] for answer in joined} == {"entered"}
        # As after a restart of the service, when all pages connect again.
        again = await asyncio.gather(*(enters({"op": "enter", "token": answer["token"]}) for answer in joined))
        assert [answer.get("nickname") for answer in again] == [f"pupil {n}" for n in range(30)]

    in_class(config, lesson)


def test_the_board_tells_nothing_without_the_key(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, _ = await opened.pupil("Ada")
        await save(ada, "of Ada")
        board = await opened.open("board")
        for request in (
            {"op": "open", "pupil": 1},
            {"op": "attention", "message": "hi"},
            {"op": "send", "name": "x", "text": "x"},
            {"op": "unlock", "key": opened.code},
            {"op": "unlock", "key": ""},
        ):
            await board.send(**request)
            assert (await board.op("refused"))["reason"] == "key"
        assert [message["op"] for message in board.seen] == ["refused"] * 5
        # A pupil's socket takes no request of the board.
        await ada.send("attention", message="hi")
        assert (await ada.op("refused", "attention"))["op"] == "refused"

    in_class(config, lesson)


def test_the_board_shows_pupils_their_programs_and_their_hands(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        ada, entered = await opened.pupil("Ada")
        await save(ada, "one")
        await ada.send("hand", up=True)
        await ada.send("status", errors=False, running=True, lesson={"name": "Bump!", "done": 1, "steps": 5})
        shown = await board.op("pupils", such=lambda m: bool(m["pupils"]) and m["pupils"][0]["running"])
        (pupil,) = shown["pupils"]
        assert (pupil["nickname"], pupil["online"], pupil["program"]) == ("Ada", True, "walk")
        assert pupil["needs"] == ["hand"]
        assert pupil["lesson"] == {"name": "Bump!", "done": 1, "steps": 5}
        await board.send("open", pupil=entered["pupil"])
        assert (await board.op("program"))["text"] == "one"
        await board.send("lower", pupil=entered["pupil"])
        await ada.op("lowered")

    in_class(config, lesson)


def test_eyes_up_and_a_sent_program_reach_every_page_also_a_late_one(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        board = await opened.board()
        ada, _ = await opened.pupil("Ada")
        await board.send("attention", message="Eyes up!")
        assert (await ada.op("attention"))["message"] == "Eyes up!"
        await board.send("send", name="start", text="{}")
        sent = await board.op("sent")
        assert (sent["pages"], sent["later"]) == (1, 0)
        handout = await ada.op("handout")
        assert (handout["what"], handout["name"]) == ("program", "start")
        ben, _ = await opened.pupil("Ben")
        assert (await ben.op("attention"))["message"] == "Eyes up!"
        assert (await ben.op("handout"))["name"] == "start"
        await board.send("attention", message=None)
        assert (await ben.op("attention"))["message"] is None

    in_class(config, lesson)


def test_a_room_or_a_lesson_reaches_the_chosen_pupils_only_also_later(config: Config) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            _, third = await opened.pupil("Cleo")
        async with teaching(config) as opened:
            board = await opened.board()
            ada, first = await opened.pupil("Ada")
            ben, _ = await opened.pupil("Ben")
            await board.send("send", what="program", name="for all", text="{}")
            assert (await board.op("sent"))["later"] == 1
            some = [first["pupil"], third["pupil"]]
            await board.send("send", what="lesson", name="Bump!", text="bump", pupils=some)
            sent = await board.op("sent")
            assert (sent["pages"], sent["later"]) == (1, 1)
            assert (await ada.op("handout"))["name"] == "for all"
            handout = await ada.op("handout")
            assert (handout["what"], handout["name"], handout["text"]) == ("lesson", "Bump!", "bump")
            cleo = await opened.open()
            await cleo.send("enter", token=third["token"])
            assert (await cleo.op("handout"))["what"] == "lesson"
            for pupils in ([], [99]):
                await board.send("send", what="room", name="x", text="{}", pupils=pupils)
                assert (await board.op("refused"))["reason"] == "request"
            # The next one for all replaces it.
            await board.send("send", what="room", name="maze", text='"maze"')
            assert (await cleo.op("handout"))["what"] == "room"
            assert (await ben.op("handout"))["name"] == "for all"
            assert (await ben.op("handout"))["what"] == "room"

    asyncio.run(run())


def test_the_board_shows_the_room_of_a_pupils_page(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        page = await opened.open("session")
        hello = await page.op("hello")
        assert hello["class"] is True
        ada, entered = await opened.pupil("Ada")
        await ada.send("here", session=hello["session"])
        board = await opened.board()
        room = await board.op("room")
        assert room["pupil"] == entered["pupil"]
        places = await board.op("places")
        assert places["places"][0][0] == entered["pupil"]
        await page.send("world", world={"name": "square", "size": [2, 2], "start": {"x": 1, "y": 1.5, "theta": 0}})
        assert (await board.op("room"))["world"]["name"] == "square"
        assert (await board.op("places"))["places"] == [[entered["pupil"], 1.0, 1.5, 0.0]]

    in_class(config, lesson)


_START = {"x": 1, "y": 1, "theta": 0}
_SVG = "<svg onload=harm()><script>harm()</script></svg>"
_DATA = "data:image/svg+xml,<svg onload='harm()'/>"

NO_ROOMS: list[dict[str, Any]] = [
    {"size": [3, 3], "start": _START, "background": _DATA},
    {"size": [3, 3], "start": _START, "picture": _SVG},
    {"size": [3, 3], "start": _START, "thumbnail": {"href": "https://harm.example/a.png"}},
    {"name": {"svg": _SVG}, "size": [3, 3], "start": _START},
    {"title": [_SVG], "size": [3, 3], "start": _START},
    {"size": [1e9, 1e9], "start": _START},
    {"size": [3, 3], "start": {"x": _SVG, "y": _DATA, "theta": None}},
    {"tiles": [_SVG, _SVG], "start": _START},
    {"tile": 1e-9, "tiles": ["..", ".."], "start": _START},
    {"tiles": ["." * 2000] * 300, "start": _START},
    {"size": [3, 3], "start": _START, "walls": [_DATA]},
    {"size": [3, 3], "start": _START, "boxes": [{"x": 1, "y": 1, "w": 1, "h": _SVG}]},
    {"size": [3, 3], "start": _START, "boxes": [{"x": 2, "y": 2, "w": 0.1, "h": 0.1}] * 2001},
    {"size": [3, 3], "start": _START, "goals": [{"kind": "reach", "x": 2, "y": 2, "r": _DATA}]},
    {"size": [3, 3], "start": _START, "goals": [{"kind": _SVG, "x": 2, "y": 2, "r": 1}]},
    {"size": [3, 3], "start": _START, "dock": _SVG},
    {"size": [3, 3], "start": _START, "realism": {"slip": _SVG}},
]


def test_a_room_that_would_be_another_picture_never_reaches_the_board(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        page = await opened.open("session")
        hello = await page.op("hello")
        ada, _ = await opened.pupil("Ada")
        await ada.send("here", session=hello["session"])
        board = await opened.board()
        await board.op("room")
        await page.op("world")
        for world in NO_ROOMS:
            await page.send("world", world=world)
            await page.op("refusal")
        # Markup where a name may stand is text, as in a nickname.
        room = {"name": _SVG, "title": _DATA, "size": [2, 2], "start": _START}
        await page.send("world", world=room)
        assert (await board.op("room"))["world"] == room
        assert [message["op"] for message in board.seen].count("room") == 2

    in_class(config, lesson)


def test_a_page_of_another_site_is_kept_out(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        for path in ("class", "board"):
            url = f"ws://{opened.address}/api/{path}"
            with pytest.raises(InvalidStatus):
                await connect(url, additional_headers={"Origin": "http://elsewhere.example"}, **UNHURRIED).__aenter__()

    in_class(config, lesson)


def test_without_class_mode_there_is_no_class(config: Config) -> None:
    async def run() -> None:
        async with serving(config) as (address, _):
            async with connect(f"ws://{address}/api/session", **UNHURRIED) as socket:
                assert "class" not in json.loads(await socket.recv())
            with pytest.raises(InvalidStatus):
                await connect(f"ws://{address}/api/board", **UNHURRIED).__aenter__()

    asyncio.run(run())


def test_the_board_follows_the_program_that_it_has_opened(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        first = await save(ada, "one")
        board = await opened.board()
        await board.send("open", pupil=entered["pupil"])
        assert (await board.op("program"))["text"] == "one"
        other = await save(ada, "another program", program="q")
        await save(ada, "three", base=first["version"], mark="m-three")
        changed = await board.op("program-changed")
        assert changed == {
            "op": "program-changed",
            "pupil": entered["pupil"],
            "program": "p",
            "name": "walk",
            "text": "three",
        }
        # Now the other program.
        await board.send("open", pupil=entered["pupil"], program="q")
        assert (await board.op("program"))["text"] == "another program"
        await save(ada, "another one", program="q", base=other["version"], mark="m-q")
        assert (await board.op("program-changed"))["text"] == "another one"

    in_class(config, lesson)


def test_the_backup_has_everything_and_needs_the_key(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, _ = await opened.pupil("Ada")
        await save(ada, "one")
        async with httpx.AsyncClient(base_url=f"http://{opened.address}", timeout=PATIENCE) as http:
            for headers in ({}, {"X-Rosy-Key": opened.code}):
                assert (await http.get("/api/class-backup", headers=headers)).status_code == 403
            answer = await http.get("/api/class-backup", headers={"X-Rosy-Key": opened.key})
        with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
            assert archive.read("001 Ada/walk.rosy").decode() == "one"
            content = json.loads(archive.read("class.json"))
        assert [pupil["nickname"] for pupil in content["pupils"]] == ["Ada"]
        assert opened.key not in str(content)

    in_class(config, lesson)


def test_requests_of_pupils_boards_and_projectors_wait_for_the_turn_of_their_address(config: Config) -> None:
    async def run() -> None:
        with open_class(config.classes, "7b") as store:
            admission = store.admission()
            async with serving(config, store) as (address, service), AsyncExitStack() as stack:
                opened = Class(address, admission.code, admission.teacher_key, stack, service)
                pupil, board, projector = [await opened.open(path) for path in ("class", "board", "projector")]
                # A message of a page that takes long.
                await service.loop_scheduler.begin("192.0.2.1")
                await pupil.send("join", code=opened.code, nickname="Ada", language="en")
                await board.send("unlock", key=opened.key)
                await projector.send("unlock", key=opened.key)
                answers = [
                    asyncio.create_task(c.op("entered", "board", "projected")) for c in (pupil, board, projector)
                ]
                done, _ = await asyncio.wait(answers, timeout=0.1)
                assert not done
                service.loop_scheduler.end("192.0.2.1", 0.0)
                assert [(await answer)["op"] for answer in answers] == ["entered", "board", "projected"]

    asyncio.run(run())


def test_an_address_that_joins_again_and_again_does_not_fill_the_class(
    config: Config, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(authentication, "JOINS_EACH", 3)

    async def lesson(opened: Class) -> None:
        async def join(nickname: str, **options: Any) -> Message:
            client = await opened.open(**options)
            await client.send("join", code=opened.code, nickname=nickname, language="en")
            return await client.op("entered", "refused")

        # One that is not let in does not count.
        answers = [await join(nickname) for nickname in ("Ada", "Ada", "Ben", "Cleo", "Dan")]
        assert [answer.get("reason") for answer in answers] == [None, "taken", None, None, "joins"]
        assert (await join("Eve", local_addr=("127.0.0.2", 0)))["op"] == "entered"
        again = await opened.open()
        await again.send("resume", code=opened.code, words=answers[0]["words"])
        assert (await again.op("entered", "refused"))["op"] == "entered"

    in_class(config, lesson)
