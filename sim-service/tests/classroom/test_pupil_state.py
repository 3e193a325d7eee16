"""Why a pupil may need help."""

from __future__ import annotations

import pytest

from rosy_sim.classroom.messages.board_messages import Need
from rosy_sim.classroom.messages.message_fields import LessonProgress
from rosy_sim.classroom.messages.pupil_messages import Status
from rosy_sim.classroom.pupil_state import ERROR_NEEDS_HELP, IDLE_NEEDS_HELP, PupilState, RunClock


def needs(state: PupilState, now: float) -> list[Need]:
    """Of a pupil whose class was free to run all the time."""
    return state.needs(now, idle=state.is_idle(now, 0.0))


def test_an_error_needs_help_after_a_minute_and_not_once_it_is_gone() -> None:
    state = PupilState()
    state.connect(1, 0.0)
    state.report(1, Status(errors=True, running=False), 10.0)
    state.report(1, Status(errors=True, running=False), 30.0)
    assert needs(state, 10.0 + ERROR_NEEDS_HELP - 1) == []
    assert needs(state, 10.0 + ERROR_NEEDS_HELP) == ["error"]
    state.report(1, Status(errors=False, running=False), 80.0)
    assert needs(state, 81.0) == []


def test_five_minutes_without_a_run_need_help() -> None:
    state = PupilState()
    state.connect(1, 100.0)
    assert needs(state, 100.0 + IDLE_NEEDS_HELP - 1) == []
    assert needs(state, 100.0 + IDLE_NEEDS_HELP) == ["idle"]
    state.report(1, Status(errors=False, running=True), 500.0)
    assert needs(state, 5000.0) == []
    state.report(1, Status(errors=False, running=False), 5000.0)
    assert needs(state, 5000.0 + IDLE_NEEDS_HELP - 1) == []
    assert needs(state, 5000.0 + IDLE_NEEDS_HELP) == ["idle"]


def test_a_pupil_who_is_not_there_needs_no_help_but_the_hand_stays_up() -> None:
    state = PupilState()
    state.connect(1, 0.0)
    state.connect(2, 0.0)
    state.report(2, Status(errors=True, running=False), 0.0)
    state.hand = True
    state.disconnect(1, 1.0)
    assert needs(state, 1000.0) == ["hand", "error", "idle"]
    state.disconnect(2, 1000.0)
    assert needs(state, 2000.0) == ["hand"]


def test_two_devices_of_a_pupil_do_not_hide_each_others_runs_errors_and_lessons() -> None:
    state = PupilState()
    state.connect(1, 0.0)
    state.report(1, Status(errors=True, running=True, lesson=LessonProgress("Bump!", 1, 3)), 1.0)
    state.connect(2, 2.0)
    state.report(2, Status(errors=False, running=False), 3.0)
    assert state.running
    assert needs(state, 1.0 + ERROR_NEEDS_HELP) == ["error"]
    assert state.lesson == LessonProgress("Bump!", 1, 3)
    # The room with the running program is shown, and without one that of the device used last.
    assert state.in_order() == [1, 2]
    state.report(1, Status(errors=True, running=False), 4.0)
    assert state.in_order() == [1, 2]
    state.report(2, Status(errors=False, running=False), 5.0)
    assert state.in_order() == [2, 1]


def test_a_device_that_dies_while_its_program_runs_leaves_no_run_behind() -> None:
    state = PupilState()
    state.connect(1, 0.0)
    state.connect(2, 0.0)
    state.report(1, Status(errors=True, running=True), 1.0)
    state.disconnect(1, 10.0)
    assert not state.running
    assert needs(state, 10.0 + ERROR_NEEDS_HELP) == []
    assert needs(state, 10.0 + IDLE_NEEDS_HELP) == ["idle"]


def a_class(pupils: int) -> list[PupilState]:
    """Pupils who connected at 0 s."""
    states = [PupilState() for _ in range(pupils)]
    for state in states:
        state.connect(1, 0.0)
    return states


@pytest.mark.parametrize(
    ("online", "idle", "most"),
    [(30, 30, True), (30, 16, True), (30, 15, False), (7, 4, True), (8, 4, False), (3, 3, False), (1, 1, False)],
)
def test_pupils_without_a_run_are_named_unless_they_are_most_of_the_class(online: int, idle: int, most: bool) -> None:
    now = IDLE_NEEDS_HELP + 10.0
    states = a_class(online)
    for state in states[idle:]:
        state.report(1, Status(errors=False, running=True), 1.0)
    away = PupilState()
    assert RunClock(0.0).most_idle([*states, away, away], now) is most
    assert sum(state.is_idle(now, 0.0) for state in states) == idle


def test_after_a_pause_the_time_without_a_run_starts_anew() -> None:
    state, clock = a_class(1)[0], RunClock(0.0)
    clock.pause()
    assert not state.is_idle(10_000.0, clock.free_since)
    clock.resume(10_000.0)
    assert not state.is_idle(10_000.0 + IDLE_NEEDS_HELP - 1, clock.free_since)
    assert state.is_idle(10_000.0 + IDLE_NEEDS_HELP, clock.free_since)


def test_the_first_run_after_an_explanation_without_a_pause_starts_the_time_of_all_anew() -> None:
    states, clock = a_class(6), RunClock(0.0)
    end = 10 * IDLE_NEEDS_HELP
    assert clock.most_idle(states, end)
    clock.run_begins(states, end)
    states[0].report(1, Status(errors=False, running=True), end)
    assert not any(state.is_idle(end + IDLE_NEEDS_HELP - 1, clock.free_since) for state in states)
    # While the class works, a run changes nothing for the others.
    for state in states[1:5]:
        state.report(1, Status(errors=False, running=True), end + 10.0)
    clock.run_begins(states, end + IDLE_NEEDS_HELP)
    assert states[5].is_idle(end + IDLE_NEEDS_HELP, clock.free_since)
