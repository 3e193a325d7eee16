"""
Page session: one connected page. Serves its requests, each of which is passed to the part that it is about.

Everything happens on the event loop: a message is served in a turn of the page (``loop_scheduler.py``), and the room
that it asks for is built in several. Compilations and checks are tasks. The socket of the page is in
``web/sockets/page_sockets.py``.
"""

from __future__ import annotations

import asyncio
from dataclasses import replace

import msgspec

from ...accounting.client import Client
from ...errors import BadInput
from ...ownership.heartbeats import Heartbeats
from ...ownership.robot_ownership import RobotOwnership
from ...ownership.robot_process import RobotProcess
from ...ownership.robot_registry import RobotRegistry
from ...previews.preview_pool import PreviewPool
from ...run.steps.velocity_guard import SafetySettings
from ...run.worker_session import RunServices
from ...sentences.sentence import tr, verbatim
from ...wire import page
from ...worker.prepared_runs import PreparedRuns
from ...world.world import ActionRefused, World
from ..pacing.loop_scheduler import PageTurns
from .outbox import Outbox
from .page_preparation import PagePreparation
from .page_previews import PagePreviews
from .page_runs import PageRuns
from .program_checks import ProgramChecks
from .simulator.room_building import BuiltRoom, build_room, rebuild_room

__all__ = ["PageSession"]


class PageSession:
    """Lives as long as its page is connected; close() ends everything it started."""

    def __init__(
        self,
        ident: str,
        services: RunServices,
        robots: RobotRegistry,
        previews: PreviewPool,
        prepared: PreparedRuns,
        turns: PageTurns,
        in_class: bool = False,
        address: str = "",
    ) -> None:
        self.id = ident
        self._turns = turns
        # Whose budget this page uses.
        self.client = Client(address, ident)
        self._budgets = services.budgets
        services = replace(services, client=self.client)
        self._limits = services.limits
        self.outbox = Outbox(self._limits.page_queue)
        self._preparation = PagePreparation(prepared)
        self._runs = runs = PageRuns(services, self._preparation, self.outbox)
        self.simulator = runs.simulator
        self.recordings = runs.recordings
        self._checks = ProgramChecks(
            services.worker, services.budgets.questions, self.client, self.outbox, runs.on_checked
        )
        now = asyncio.get_running_loop().time
        self._previews = PagePreviews(previews, self.client, self.outbox.put, now, services.worker.wait_ready)
        # The real robot that this page owns, if any.
        self.ownership = RobotOwnership(ident, robots, self._limits, self.outbox.put, runs.view, runs.safety)
        self._heartbeats = Heartbeats()
        # Set by close(): nothing may start any more.
        self.closed = asyncio.Event()
        self.outbox.put(page.Hello(session=self.id, in_class=True if in_class else msgspec.UNSET))
        self.outbox.put(page.worker_state(services.worker.state, services.worker.fault))
        runs.view.show_room(self.simulator.room)
        self.ownership.send_robots()

    @property
    def safety(self) -> SafetySettings:
        """The safety rules of the page's simulated robot."""
        return self._runs.safety.settings

    @property
    def world(self) -> World:
        """The simulated robot in its room."""
        return self.simulator.world

    @property
    def room_json(self) -> object:
        """The room as JSON: another object after each change."""
        return self.simulator.room.json

    def snapshot(self) -> page.Frame:
        """The simulated robot as it is now, for others than the page."""
        return self._runs.view.snapshot()

    async def receive(self, text: str | bytes) -> None:
        """Serve one message of the page, or refuse it. There is one at a time."""
        try:
            async with self._turns.turn(len(text)):
                request = page.read_request(text)
                if not isinstance(request, page.ChooseWorld | page.Reset | page.Run):
                    self._serve(request)
                    return
            if isinstance(request, page.ChooseWorld):
                built = await build_room(request.world, self._turns)
            else:
                built = await rebuild_room(self.simulator.room, self._turns)
            async with self._turns.turn():
                if not self.closed.is_set():
                    self._serve_with_room(request, built)
        except page.BadRequest as error:
            # The hint is for developers.
            self._runs.refuse(tr("The page sent something Rosy does not understand."), verbatim(str(error)))
        except (BadInput, ActionRefused) as error:
            self._runs.refuse(error.sentence)

    def _serve_with_room(self, request: page.ChooseWorld | page.Reset | page.Run, built: BuiltRoom) -> None:
        match request:
            case page.ChooseWorld():
                room = built.with_robot()
                self._end_now()
                self._forget_run()
                self.simulator.move_to(room)
            case page.Reset():
                self._end_now()
                self._forget_run()
                self.simulator.reset(built.with_robot())
                self._runs.view.show_room(self.simulator.room)
            case page.Run():
                self._end_now()
                sources = [request.source, *(companion.source for companion in request.companions)]
                if all(self._is_short_enough(source) for source in sources):
                    self._runs.start(request, built, self.ownership)

    def _serve(self, request: page.Request) -> None:
        match request:
            case page.Check():
                if self._is_short_enough(request.source):
                    self._preparation.on_edited(request.source)
                    self._checks.check(request)
            case page.Complete():
                self._checks.complete(request)
            case page.PreparePreviews():
                self._previews.prepare()
            case page.Preview():
                self._preview(request)
            case page.ChooseLessonStep():
                self._runs.lesson.choose(request.step, self.world.arena)
            case page.Input():
                self.simulator.serve_input(request)
            case page.Replay():
                self._end_now()
                self._runs.replay(request)
            case page.Observe():
                self._runs.observe(request)
            case page.Visibility():
                self._runs.view.set_visibility(request.state)
            case page.Why() | page.WhyNot():
                self._runs.answer(request)
            case page.Unlock():
                self.ownership.unlock(request.code, self.client.address)
            case page.Take():
                self._end_now()
                self.ownership.acquire(request)
            case page.Leave():
                self._end_now()
                self.ownership.release()
            case page.SwitchSafety():
                self.simulator.hands.between_steps(lambda: self._switch_safety(request.on))
            case page.EmergencyStop() | page.Free() | page.Alive():
                self._tell_robot(request)
            case page.Stop() | page.SetSpeed() | page.Pause() | page.Resume() | page.Forward():
                self._runs.control(request)

    def _tell_robot(self, request: page.EmergencyStop | page.Free | page.Alive) -> None:
        robot = self.ownership.process
        if robot is None:
            return
        match request:
            case page.EmergencyStop():
                robot.emergency_stop()
            case page.Free():
                robot.free()
            case page.Alive():
                self._confirm_alive(robot, request.seen)

    def _confirm_alive(self, robot: RobotProcess, seen: int) -> None:
        """Pass a page's heartbeat on, with the time of the answer that the page had seen; ask for the next one."""
        time = self._heartbeats.time_of(seen)
        if time is not None:
            robot.alive(time)
        self.outbox.put(page.Seen(self._heartbeats.next()))

    def _switch_safety(self, on: bool) -> None:
        safety = self._runs.safety
        settings = replace(safety.settings, on=on)
        robot = self.ownership.process
        if robot is not None:
            robot.switch_safety(on)
            self._runs.twin.switch_safety(settings)
            return
        safety.set(settings)
        self.simulator.hands.record_safety(settings)

    def _is_short_enough(self, source: str) -> bool:
        if len(source) <= self._limits.source:
            return True
        self._runs.refuse(
            tr("This program is too long."),
            tr("A program can have at most {most} characters.", most=self._limits.source),
        )
        return False

    def _preview(self, request: page.Preview) -> None:
        # A real robot has neither this room nor a simulator's path.
        if self.ownership.process is not None or not self._is_short_enough(request.source):
            return
        hands = self.simulator.hands
        if not hands.is_complete:
            self._previews.cancel()
            self.outbox.put(page.Previewed(request.id, "unrepeatable", 0.0, (0.0, 0.0, 0.0), [], [], [], []))
            return
        self._previews.request(hands.preview_task(request, self.room_json))

    def _forget_run(self) -> None:
        """The last run is no longer what previews repeat."""
        self._previews.cancel()
        self.simulator.hands.begin(0, self.safety)

    def _end_now(self) -> None:
        """End the current run at once; the page is told."""
        self._previews.cancel()
        self._runs.end_now()

    async def close(self) -> None:
        """End everything this session started."""
        self.closed.set()
        self._preparation.close()
        self.simulator.stop()
        self._end_now()
        await self._checks.close()
        await self._previews.close()
        await self._runs.close()
        await self.ownership.close()
        self._runs.free()
        for queue in self._budgets.queues:
            queue.leave(self.client)
