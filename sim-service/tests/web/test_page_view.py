"""Frames by how much of the page is seen."""

from __future__ import annotations

import math

import pytest

from rosy_sim.config import Config
from rosy_sim.run.frame_rate import FrameRate
from rosy_sim.run.lateness import Lateness
from rosy_sim.web.service import Service
from rosy_sim.web.sessions.outbox import Outbox
from rosy_sim.web.sessions.page_view import PageView, Room
from rosy_sim.wire import page
from rosy_sim.wire.robot_process import FrameLine
from rosy_sim.wire.telemetry import PoseShown, Shown
from rosy_sim.world.arena import Pose
from rosy_sim.world.events import Command

from ..conftest import hall
from .page_client import Page, story


class Clock:
    """Goes on by hand, s."""

    now = 0.0

    def time(self) -> float:
        return self.now


class Sent(Outbox):
    """Counts the frames that a page would get if it read each at once."""

    def __init__(self) -> None:
        super().__init__(10)
        self.frames: list[page.Frame] = []

    def put(self, answer: page.Answer) -> None:
        if isinstance(answer, page.Frame):
            self.frames.append(answer)


def watched(visible: page.Visible | None, seconds: int = 10) -> tuple[PageView, Sent]:
    """The frames of a run at 50 steps a second."""
    clock, sent = Clock(), Sent()
    view = PageView(sent, Room({}, hall()), FrameRate(60.0, Lateness()), clock.time)
    if visible is not None:
        view.set_visibility(visible)
    for step in range(50 * seconds):
        view.step = step
        view.add_fired(["move"])
        view.show_frame()
        clock.now += 0.02
    return view, sent


@pytest.mark.parametrize(("visible", "most"), [(None, 500), ("focused", 500), ("visible", 203), ("hidden", 0)])
def test_a_page_gets_as_many_frames_as_its_user_can_see(visible: page.Visible | None, most: int) -> None:
    _, sent = watched(visible)
    assert most - 3 <= len(sent.frames) <= most


def test_a_frame_tells_when_the_program_sensed_each_event() -> None:
    sent = Sent()
    view = PageView(sent, Room({}, hall()), FrameRate(60.0, Lateness()), Clock().time)
    view.add_sensed(0.06, ["Bumper CenterBumper Pressed"])
    view.add_sensed(0.08, ["Bumper LeftBumper Pressed", "Button Button0 Pressed"])
    view.show_frame(force=True)
    view.show_frame(force=True)
    assert [frame.times for frame in sent.frames] == [[0.06, 0.08, 0.08], None]
    assert len(sent.frames[0].sensed) == 3


def test_frames_tell_all_channels_at_the_start_of_a_run_and_then_what_differs() -> None:
    clock, sent, world = Clock(), Sent(), hall()
    view = PageView(sent, Room({}, world), FrameRate(60.0, Lateness()), clock.time)

    def told() -> dict[str, Shown]:
        view.show_frame(force=True)
        return sent.frames[-1].channels

    first = told()
    assert first["Led1"] == [0]
    assert told() == {}
    world.command(Command("Led1", (2,)))
    assert told() == {"Led1": [2]}
    # A number that is drawn the same is not told again.
    world.v += 1e-9
    assert told() == {}
    view.run = 1
    assert told() == {**first, "Led1": [2]}


def test_after_a_real_robot_was_shown_the_simulated_one_tells_what_differs_from_it() -> None:
    clock, sent = Clock(), Sent()
    view = PageView(sent, Room({}, hall()), FrameRate(60.0, Lateness()), clock.time)
    view.show_frame()
    clock.now += 1
    view.show_telemetry(FrameLine(0.1, PoseShown(0.0, 0.0, 0.0), {"Led1": [2]}, [], [], False))
    clock.now += 1
    view.show_frame()
    assert [frame.channels for frame in sent.frames[1:]] == [{"Led1": [2]}, {"Led1": [0]}]


def test_a_page_that_is_seen_again_gets_a_frame_with_what_fired_last() -> None:
    view, sent = watched("hidden")
    view.set_visibility("visible")
    [frame] = sent.frames
    assert (frame.step, set(frame.fired), len(frame.fired)) == (499, {"move"}, 200)
    view.set_visibility("focused")
    assert len(sent.frames) == 1


def test_a_hidden_page_is_told_what_its_program_says_and_gets_no_frames(config: Config) -> None:
    async def play(page: Page, _: Service) -> None:
        await page.send("visibility", state="hidden")
        await page.send("run", run=1, source="drive:0.3 say:hi@30", speed=1)
        await page.op("state", run=1, state="running")
        before = len([m for m in page.seen if m["op"] == "frame"])
        await page.op("said", run=1)
        assert len([m for m in page.seen if m["op"] == "frame"]) == before
        await page.send("visibility", state="focused")
        await page.until(lambda m: m["op"] == "frame" and m["run"] == 1 and m["step"] > 0)

    story(play, config)


def frame_line(time: float) -> FrameLine:
    return FrameLine(time, PoseShown(0.0, 0.0, 0.0), {}, [], [], False)


def test_frames_of_the_run_before_are_not_those_of_the_next_one() -> None:
    clock, sent = Clock(), Sent()
    view = PageView(sent, Room({}, hall()), FrameRate(60.0, Lateness()), clock.time)

    def shown(time: float) -> bool:
        before = len(sent.frames)
        view.show_telemetry(frame_line(time))
        clock.now += 0.02
        return len(sent.frames) > before

    assert shown(5.0)
    view.await_robot()
    assert [shown(5.1), shown(0.01)] == [False, False]
    view.begin_robot()
    clock.now += 0.02
    # The first is still on its way from before; the clock of the robot begins anew.
    assert [shown(5.2), shown(0.02), shown(0.04)] == [False, True, True]
    view.end_robot()
    assert shown(5.3)


def test_a_real_robot_is_shown_where_its_odometry_begins() -> None:
    clock, sent = Clock(), Sent()
    view = PageView(sent, Room({}, hall()), FrameRate(60.0, Lateness()), clock.time)
    view.origin = Pose(1.0, 2.0, math.pi / 2)
    view.show_telemetry(FrameLine(0.1, PoseShown(0.5, 0.25, 0.1), {}, [], [], False))
    found = sent.frames[-1].pose
    assert (found.x, found.y, found.theta) == pytest.approx((0.75, 2.5, math.pi / 2 + 0.1), abs=1e-4)
