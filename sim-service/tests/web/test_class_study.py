"""A study over real sockets: the teacher switches it on, each pupil answers, and the board exports it."""

from __future__ import annotations

import asyncio
import io
import zipfile

import httpx

from rosy_sim.config import Config

from ..conftest import PATIENCE
from .test_class import Class, in_class, save, teaching

ON = {"op": "study", "contact": "Prof. Quirk", "takes_part": None}


async def export(opened: Class, key: str | None = None) -> httpx.Response:
    async with httpx.AsyncClient(base_url=f"http://{opened.address}", timeout=PATIENCE) as http:
        return await http.get("/api/class-study", headers={"X-Rosy-Key": opened.key if key is None else key})


def test_a_study_begins_on_the_board_and_each_pupil_answers(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board = await opened.board()
        await ada.send("answer-study", agrees=True)
        assert (await ada.op("refused", "study"))["reason"] == "request"
        assert (await export(opened)).status_code == 409
        await board.send("set-study", contact="  ")
        assert (await board.op("refused", "study"))["reason"] == "request"

        await board.send("set-study", contact=" Prof. Quirk ")
        assert await ada.op("study") == ON
        # Before the answer nothing of the pupil is exported.
        assert "No pupil has agreed" in (await export(opened)).json()["message"]
        await ada.send("answer-study", agrees=True)
        assert await ada.op("study") == {**ON, "takes_part": True}
        shown = await board.op("study", such=lambda m: m["taking_part"] == 1)
        assert shown["contact"] == "Prof. Quirk"

        # A pupil who comes later is asked, too; and so is the same pupil on another device, with the answer.
        ben, _ = await opened.pupil("Ben")
        assert await ben.op("study") == ON
        again = await opened.open()
        await again.send("enter", token=entered["token"])
        assert (await again.op("study"))["takes_part"] is True

        await save(ada, "main = simulate move")
        await ada.send("status", errors=False, running=True, program="p")
        await ada.send("status", errors=False, running=True, program="p")
        # Another one's program is none of this pupil's.
        await ben.send("status", errors=False, running=True, program="p")
        await ada.send("answer-study", agrees=True)
        await ada.op("study")
        assert (await export(opened, "wrong")).status_code == 403
        with zipfile.ZipFile(io.BytesIO((await export(opened)).content)) as archive:
            rows = archive.read("MainTable.csv").decode().splitlines()
        assert [row.split(",")[3] for row in rows[1:]] == ['"File.Create"', '"Run.Program"']

        await board.send("set-study", contact=None)
        assert (await ben.op("study"))["contact"] is None
        assert (await board.op("study"))["contact"] is None
        assert (await export(opened)).status_code == 409

    in_class(config, lesson)


def test_a_study_and_its_answers_are_there_after_a_new_start(config: Config) -> None:
    async def run() -> None:
        async with teaching(config) as opened:
            ada, entered = await opened.pupil("Ada")
            board = await opened.board()
            await board.send("set-study", contact="Prof. Quirk")
            await ada.op("study")
            await ada.send("answer-study", agrees=False)
            await ada.op("study", such=lambda m: m["takes_part"] is False)
        async with teaching(config) as opened:
            ada = await opened.open()
            await ada.send("enter", token=entered["token"])
            assert await ada.op("study") == {**ON, "takes_part": False}
            board = await opened.board()
            assert (await board.op("study"))["taking_part"] == 0

    asyncio.run(run())
