"""A suspended service is reported on the board; and when pupils who run nothing need help."""

from __future__ import annotations

import json

from rosy_sim.classroom.pupil_state import IDLE_NEEDS_HELP
from rosy_sim.config import Config
from rosy_sim.web.sockets.class_sockets import SUSPENDED_FROM

from .test_class import Class, in_class


def test_a_page_that_asks_is_answered_on_every_socket_also_before_it_was_let_in(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        for path in ("class", "board", "projector"):
            client = await opened.open(path)
            await client.socket.send('{"op":"ping"}')
            await client.op("pong")
            assert {message["op"] for message in client.seen} <= {"class", "pong"}
        ada, _ = await opened.pupil("Ada")
        await ada.socket.send('{"op":"ping"}')
        await ada.op("pong")

    in_class(config, lesson)


def test_the_board_says_how_long_the_service_was_suspended_also_a_board_that_connects_afterwards(
    config: Config,
) -> None:
    async def lesson(opened: Class) -> None:
        # No board is open while the service stands still: its connection was lost.
        sockets = opened.service.class_sockets
        assert sockets is not None
        clock = sockets.clock
        sockets.clock = lambda: clock() + 2 * SUSPENDED_FROM
        board = await opened.board()
        told = await board.op("suspended")
        assert 2 * SUSPENDED_FROM <= told["seconds"] < 3 * SUSPENDED_FROM
        assert (await (await opened.board()).op("suspended")) == told

    in_class(config, lesson)


def test_pupils_are_not_named_for_the_time_of_a_pause(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        ada, entered = await opened.pupil("Ada")
        board = await opened.board()
        await ada.send("status", errors=False, running=False)
        classroom = opened.service.classroom
        assert classroom is not None
        now = classroom.now
        classroom.now = lambda: now() + IDLE_NEEDS_HELP
        shown = await board.op("pupils", such=lambda message: message["pupils"][0]["needs"] == ["idle"])
        assert shown["pupils"][0]["id"] == entered["pupil"]
        await board.send("attention", message="Look at me")
        await ada.op("attention")
        await board.op("pupils", such=lambda message: message["pupils"][0]["needs"] == [])
        await board.send("attention", message=None)
        await ada.op("attention")
        # Without the new start of the time the first look would name Ada again.
        assert classroom.pupils_shown().pupils[0].needs == []
        classroom.now = lambda: now() + 2 * IDLE_NEEDS_HELP
        await board.op("pupils", such=lambda message: message["pupils"][0]["needs"] == ["idle"])

    in_class(config, lesson)


def test_most_of_the_class_is_a_sentence_and_not_a_list_of_names(config: Config) -> None:
    async def lesson(opened: Class) -> None:
        pupils = [(await opened.pupil(f"Pupil {number}"))[0] for number in range(5)]
        board = await opened.board()
        classroom = opened.service.classroom
        assert classroom is not None
        now = classroom.now
        classroom.now = lambda: now() + IDLE_NEEDS_HELP
        shown = await board.op("pupils", such=lambda message: message["most_idle"])
        assert [pupil["needs"] for pupil in shown["pupils"]] == [[]] * 5
        # The class begins to work again.
        await pupils[0].send("status", errors=False, running=True)
        shown = await board.op("pupils", such=lambda message: not message["most_idle"])
        assert json.dumps(shown).count('"idle"') == 0

    in_class(config, lesson)
