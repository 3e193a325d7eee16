"""Why a pupil may need help."""

from __future__ import annotations

from rosy_sim.classroom.messages.message_fields import LessonProgress
from rosy_sim.classroom.messages.pupil_messages import Status
from rosy_sim.classroom.pupil_state import ERROR_NEEDS_HELP, IDLE_NEEDS_HELP, PupilState


def test_an_error_needs_help_after_a_minute_and_not_once_it_is_gone() -> None:
    state = PupilState()
    state.connect(1, 0.0)
    state.report(1, Status(errors=True, running=False), 10.0)
    state.report(1, Status(errors=True, running=False), 30.0)
    assert state.needs(10.0 + ERROR_NEEDS_HELP - 1) == []
    assert state.needs(10.0 + ERROR_NEEDS_HELP) == ["error"]
    state.report(1, Status(errors=False, running=False), 80.0)
    assert state.needs(81.0) == []


def test_five_minutes_without_a_run_need_help() -> None:
    state = PupilState()
    state.connect(1, 100.0)
    assert state.needs(100.0 + IDLE_NEEDS_HELP - 1) == []
    assert state.needs(100.0 + IDLE_NEEDS_HELP) == ["idle"]
    state.report(1, Status(errors=False, running=True), 500.0)
    assert state.needs(5000.0) == []
    state.report(1, Status(errors=False, running=False), 5000.0)
    assert state.needs(5000.0 + IDLE_NEEDS_HELP - 1) == []
    assert state.needs(5000.0 + IDLE_NEEDS_HELP) == ["idle"]


def test_a_pupil_who_is_not_there_needs_no_help_but_the_hand_stays_up() -> None:
    state = PupilState()
    state.connect(1, 0.0)
    state.connect(2, 0.0)
    state.report(2, Status(errors=True, running=False), 0.0)
    state.hand = True
    state.disconnect(1, 1.0)
    assert state.needs(1000.0) == ["hand", "error", "idle"]
    state.disconnect(2, 1000.0)
    assert state.needs(2000.0) == ["hand"]


def test_two_devices_of_a_pupil_do_not_hide_each_others_runs_errors_and_lessons() -> None:
    state = PupilState()
    state.connect(1, 0.0)
    state.report(1, Status(errors=True, running=True, lesson=LessonProgress("Bump!", 1, 3)), 1.0)
    state.connect(2, 2.0)
    state.report(2, Status(errors=False, running=False), 3.0)
    assert state.running
    assert state.needs(1.0 + ERROR_NEEDS_HELP) == ["error"]
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
    assert state.needs(10.0 + ERROR_NEEDS_HELP) == []
    assert state.needs(10.0 + IDLE_NEEDS_HELP) == ["idle"]
