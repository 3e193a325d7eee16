"""
Simulated robot of one page in its room: what a person and ROS clients do to it, with and without a program.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from functools import partial

from ....run.page_run import PageRun
from ....run.simulated_run import SimulatedRun
from ....run.steps.lockstep import Lockstep, no_such_server
from ....sentences.sentence import Sentence, tr
from ....wire import page
from ....wire.topics import RESET_ODOMETRY, BadMessage, TopicMessage
from ....wire.user_input import published, user_actions
from ....world.events import Command, GiveGoal, Reading, TakeBackGoal
from ....world.time_step import STEPS_PER_SECOND
from ....world.world import ActionRefused, World
from ....worlds.gallery import DEFAULT_WORLD, named_world, usable_world
from ..page_view import PageView, Room
from .hands_recorder import HandsRecorder
from .idle_simulation import IdleSimulation
from .ros_bridge import RosBridge, RosClient

__all__ = ["SimulatedRobot", "default_room"]


class SimulatedRobot:
    """
    Of one page.

    Args:
        view: shows the robot.
        room: where it is; ``view`` shows it already.
        current_run: the run of the page, on any robot.
        refuse: tells the page that an input changed nothing.
    """

    def __init__(
        self,
        view: PageView,
        room: Room,
        current_run: Callable[[], PageRun | None],
        refuse: Callable[[Sentence, Sentence | None], None],
    ) -> None:
        self._view = view
        self.room = room
        self._current_run = current_run
        self._refuse = refuse
        self._now = asyncio.get_running_loop().time
        self.hands = HandsRecorder(self.run)
        self.bridge = RosBridge()
        # Set when the page has chosen another room.
        self.room_changed = asyncio.Event()
        # Steps since the session began, with and without programs.
        self.steps = 0
        self._idle = IdleSimulation(self.bridge, view, self.on_events)

    @property
    def world(self) -> World:
        """The robot in its room as it is now."""
        return self.room.world

    def run(self) -> SimulatedRun | None:
        """The run of a program on this robot, if there is one."""
        run = self._current_run()
        return run if isinstance(run, SimulatedRun) else None

    # The room

    def move_to(self, room: Room) -> None:
        """The page has another room."""
        self.hands.forget_room()
        self.room = room
        self.room_changed.set()
        self._view.show_room(room)
        self.wake()

    def reset(self, room: Room) -> None:
        """The room is as it was before anything moved."""
        self.room = room
        self._view.reset(room)
        self.wake()

    def begin_run(self, room: Room) -> None:
        """A run moves the robot from now on, in this room."""
        self.reset(room)
        self._idle.pause()

    def wake(self) -> None:
        """Something may have changed for the simulation without a program."""
        if self._current_run() is None:
            self._idle.wake(self.world)

    def stop(self) -> None:
        """Make no more steps without a program."""
        self._idle.close()

    def free(self) -> None:
        """A large room is freed now, and not when the garbage collector finds the session."""
        self.reset(default_room())
        self._idle.pause()

    # Hands

    def serve_input(self, request: page.Input) -> None:
        """Serve an input of the page, at the end of a step that is in progress."""
        self.hands.between_steps(lambda: self._serve_input(request))

    def _serve_input(self, request: page.Input) -> None:
        try:
            for action in user_actions(request):
                self.world.apply(action)
                self.hands.record(action)
            for message in published(request):
                self._publish(message)
        except ActionRefused as refused:
            self._refuse(refused.sentence, None)
        except BadMessage as error:
            self._refuse(tr("This message cannot be published."), error.sentence)
        else:
            self._view.show_frame(force=True)
            self.wake()

    # ROS clients

    def join(self) -> RosClient:
        """A ROS client connects."""
        client = self.bridge.join()
        self.wake()
        return client

    def leave(self, client: RosClient) -> None:
        """A ROS client has disconnected."""
        self.bridge.leave(client)
        self.hands.between_steps(partial(self._publish, TakeBackGoal(client.protocol.name)))

    def receive_ros(self, client: RosClient, text: str | bytes) -> None:
        """Serve one message of a ROS client."""
        for message in self.bridge.receive(client, text, self._now()):
            self.hands.between_steps(partial(self._publish, message))

    def _publish(self, message: Command | TopicMessage | GiveGoal | TakeBackGoal) -> None:
        """A person or a ROS client publishes: a command, a goal, or a message for the program and all ROS clients."""
        if isinstance(message, TakeBackGoal) and not self.world.actions.is_pursuing:
            return
        self.hands.record(message)
        if isinstance(message, GiveGoal | TakeBackGoal):
            self.world.apply(message)
            return
        if isinstance(message, Command):
            self._obey(message)
            return
        run = self.run()
        if run is not None:
            run.post(message)
        elif message.topic == RESET_ODOMETRY:
            self.world.reset_odometry()
        self.on_message(message)

    def _obey(self, command: Command) -> None:
        self.world.command(command)
        time = self.steps / STEPS_PER_SECOND
        if command.channel == "Say":
            self._view.show_text(time, str(command.values[0]))
        elif command.channel == "Sound":
            self._view.play_sound(time, int(command.values[0]))
        else:
            self._view.show_frame(force=self._current_run() is None)

    # Steps

    def on_message(self, message: TopicMessage) -> None:
        """A message on a topic that is none of the robot's, for its ROS clients."""
        self.bridge.post(message, self._now())

    def on_events(self, events: list[Reading]) -> None:
        """The robot has sensed these events in a step."""
        self.steps += 1
        has_clients = bool(self.bridge)
        self.world.listen("ros", self.bridge.wanted() if has_clients else ())
        if has_clients:
            self.bridge.post_replies(self.world.actions, self._now())
        if events or has_clients:
            self.bridge.publish(events, self.world.odometry(), self.steps / STEPS_PER_SECOND, self._now())

    def on_step(self, lockstep: Lockstep) -> None:
        """A step of a program has passed."""
        for name in lockstep.unavailable:
            self._refuse(no_such_server(name), None)
        if self.bridge:
            for command in lockstep.commands:
                self.bridge.post_command(command, self._now())
        if lockstep.settled is not None:
            self.hands.record_step(lockstep)
        self.hands.after_step()


def default_room() -> Room:
    """The room of a page that has not chosen one."""
    json = named_world(DEFAULT_WORLD)
    return Room(json, usable_world(json, DEFAULT_WORLD))
