"""
Service: what lives as long as the web application. Worker, queues and registries, and the sockets that use them.
"""

from __future__ import annotations

import asyncio
import contextlib
import sys
import time
from collections.abc import AsyncIterator, Callable

from starlette.applications import Starlette

from ..accounting.resources import Budgets
from ..classroom.classroom import Classroom
from ..classroom.hand_in_checks import HandInChecks
from ..config import Config
from ..ownership.robot_discovery import discover_robots
from ..ownership.robot_registry import RobotRegistry
from ..ownership.run_recorder import RunRecorder
from ..previews.preview_pool import PreviewPool
from ..run.frame_rate import FrameRate
from ..run.lateness import Lateness
from ..run.worker_session import RunServices
from ..sentences.sentence import Sentence
from ..sentences.terminal_text import neutralize_line
from ..sentences.wording import in_terminal
from ..wire import page
from ..worker.prepared_runs import PreparedRuns
from ..worker.supervisor import WorkerStatus, WorkerSupervisor
from .pacing.loop_scheduler import LoopScheduler, PageTurns
from .sessions.page_session import PageSession
from .sockets.class_sockets import ClassSockets
from .sockets.lesson_rehearsals import LessonRehearsals
from .sockets.page_sockets import PageSockets
from .sockets.projector_sockets import ProjectorSockets
from .sockets.room_tests import RoomTests
from .sockets.ros2_robot import Ros2Robot
from .sockets.ros_sockets import RosSockets

__all__ = ["Service"]


class Service:
    """``classroom`` is that of class mode."""

    def __init__(self, config: Config, classroom: Classroom | None = None) -> None:
        self.config = config
        self.classroom = classroom
        # Ends the service, and says why; the server sets it.
        self.end: Callable[[Sentence], None] = lambda _: None
        self.loop_scheduler = LoopScheduler()
        self.lateness = Lateness()
        self.budgets = Budgets(config.limits)
        self.worker = WorkerSupervisor(config, self._on_worker_status)
        self.recorder = RunRecorder(config.recordings, self._tell) if config.records else None
        self.robots = RobotRegistry(
            config.robots,
            config.robot_executable,
            time.monotonic,
            self._on_robots_change,
            self.recorder,
            discovers=bool(config.nearby),
        )
        self.previews = PreviewPool(config, self.budgets.previews)
        self.prepared_runs = PreparedRuns(self.worker, config.limits.prepared)
        self._run_services = RunServices(
            self.worker,
            self.budgets,
            config.limits,
            self.lateness,
            FrameRate(config.limits.frame_rate, self.lateness),
        )
        self.pages = PageSockets(self.budgets.pages, self.loop_scheduler, self._open_session)
        self.sessions = self.pages.sessions
        self.ros_clients = RosSockets(self.sessions, self.loop_scheduler)
        place = config.simulator_address
        self.ros2_robot = Ros2Robot(place, self.sessions, self._tell) if place is not None else None
        background = self.budgets.background
        self.room_tests = RoomTests(config, self.sessions, background)
        self.lesson_rehearsals = LessonRehearsals(config, self.sessions, background)
        self._checks: HandInChecks | None = None
        self.class_sockets: ClassSockets | None = None
        self.projectors: ProjectorSockets | None = None
        if classroom is not None:
            self._checks = HandInChecks(classroom.tasks, config, background)
            self.class_sockets = ClassSockets(classroom, self._checks, self.sessions, self.loop_scheduler, self.budgets)
            self.projectors = ProjectorSockets(classroom, self.sessions, self.loop_scheduler, self.budgets.locked)

    @staticmethod
    def _tell(sentence: Sentence) -> None:
        """Tell the person who started Rosy."""
        print(f"rosy: {neutralize_line(in_terminal(sentence))}", file=sys.stderr)

    def _open_session(self, ident: str, turns: PageTurns, address: str) -> PageSession:
        if self.ros2_robot is not None:
            self.ros2_robot.page_opened()
        return PageSession(
            ident,
            self._run_services,
            self.robots,
            self.previews,
            self.prepared_runs,
            turns,
            self.classroom is not None,
            address,
        )

    def _on_worker_status(self, status: WorkerStatus) -> None:
        for session in self.sessions.values():
            session.outbox.put(page.worker_state(status, self.worker.fault))

    def _on_robots_change(self) -> None:
        for session in self.sessions.values():
            session.ownership.send_robots()

    @contextlib.asynccontextmanager
    async def lifespan(self, _app: Starlette) -> AsyncIterator[None]:
        """Keep a worker while the application runs."""
        supervision = [asyncio.create_task(self.worker.run())]
        supervision.append(asyncio.create_task(discover_robots(self.config.nearby, self.robots.set_nearby)))
        if self.recorder is not None:
            supervision.append(asyncio.create_task(self.recorder.recover()))
        if self.ros2_robot is not None:
            supervision.append(asyncio.create_task(self.ros2_robot.run()))
        if self.classroom is not None:
            supervision.append(asyncio.create_task(self._keep_class(self.classroom)))
        if self.class_sockets is not None:
            supervision.append(asyncio.create_task(self.class_sockets.watch_suspension()))
        try:
            yield
        finally:
            # Concurrently: no robot keeps driving while others are being stopped.
            await asyncio.gather(*(session.close() for session in list(self.sessions.values())))
            await self.previews.close()
            if self.recorder is not None:
                await self.recorder.close()
            if self._checks is not None:
                await self._checks.cancel()
            for task in supervision:
                task.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await task
            # Last: a class that is being kept needs its store.
            if self.classroom is not None:
                await self.classroom.close()

    async def _keep_class(self, classroom: Classroom) -> None:
        self.end(await classroom.keep_store())
