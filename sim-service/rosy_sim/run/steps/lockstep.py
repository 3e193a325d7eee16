"""
Lockstep of a program and a world, without any I/O: bytes from the program in, bytes for it out.

The owner transfers the bytes and decides when time passes::

    send(lockstep.begin())             feed() until ready
    send(lockstep.sense())             feed() until settled   } once per 20 ms
    lockstep.integrate()                                      }

A step is quiet when the program has said that nothing can fire in it, and no event happens. Such a step has settled
when it is sensed, and nothing is sent. The program gets the states that have changed meanwhile before its next step.

``feed`` applies commands as they come; nothing moves before ``integrate``. Velocities pass the ``velocity_guard``, as
on real robots: the latest is repeated while the program lives (rule R9), and the safety rules may override it. The
watchdog of the base stops the robot of a dead program.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import msgspec

from ...robot_description import simulated_action
from ...sentences.sentence import Sentence, tr
from ...wire.action_frames import has_substitute, reply_frame, service_failure
from ...wire.channels import Values
from ...wire.link_messages import NO_FIRINGS, CancelActionGoal, Ended, Ready, SendActionGoal, Settled
from ...wire.robot_link import Request, SimulatorLink, start_line, step_line, stop_line
from ...wire.topics import CHANNELS, ODOMETRY, RESET_ODOMETRY, TopicMessage, on_demand, reading_line, topic_message
from ...world.events import VELOCITY_CHANNEL, Command, Reading
from ...world.goals import GoalTracker, Observation
from ...world.time_step import STEPS_PER_SECOND
from ...world.world import World
from .blocked_drive import BlockedDrive
from .command_conflicts import CommandConflict, CommandConflicts
from .quiet_steps import MemoryRequest, QuietSteps
from .velocity_guard import OFF, SafetySettings, Velocity, VelocityGuard

__all__ = ["PROGRAM", "Lockstep", "State", "no_such_server"]

State = Literal["opening", "ready", "thinking", "settled", "ended"]

_encoder = msgspec.json.Encoder()

_NO_CONFLICTS: tuple[CommandConflict, ...] = ()

PROGRAM = "program"
"""The client of ``World.actions`` that is the program."""

GUARD_STEPS = 5
"""Steps between two ticks of the velocity guard: 10 Hz, as those of ``Rosy.Robots.Guard`` on a real robot."""


def no_such_server(name: str) -> Sentence:
    """Of an action or a service that the simulated robot does not have."""
    return tr("The simulated robot has no action or service called {name}.", name=name)


class Lockstep:
    """One run of a program in a world."""

    def __init__(
        self, world: World, seed: int, trace: bool = False, safety: SafetySettings = OFF, quiet: bool = True
    ) -> None:
        self.world = world
        self._seed = seed
        self._trace = trace
        self._quiet = QuietSteps() if quiet else None
        # Whether the program tells its firings with their provenance (language rule R12).
        self.observes = False
        self._link = SimulatorLink()
        # The progress of the goals of the world.
        self.goals = GoalTracker(world.arena.goals)
        self.has_goals = bool(self.goals)
        # Where the conversation is: opening until `ready`; thinking from sense() to `settled`.
        self.state: State = "opening"
        # Steps integrated so far, and with it the simulated time in units of 20 ms.
        self.step = 0
        # What the program did in the current step; cleared by sense().
        self.commands: list[Command] = []
        # The same with messages on topics of its own, in order.
        self._actions: list[Command | TopicMessage] = []
        # What it published in the current step on topics of its own.
        self.published: list[TopicMessage] = []
        # Functions that override each other's commands, as far as this step has made it certain.
        self.conflicts: Sequence[CommandConflict] = _NO_CONFLICTS
        self._commands_in_force = CommandConflicts()
        # Whether the last step has made it certain that the robot pushes against something and does not move.
        self.is_blocked = False
        self._blocked_drive = BlockedDrive()
        # Messages on topics of its own and replies to its calls that the program gets in the next step, as lines.
        self._posted: list[bytes] = []
        # The actions that it has called, as it names them, by the identifiers of its goals.
        self._goals: dict[str, str] = {}
        # The actions and services that it has called in the current step and that the robot does not have.
        self.unavailable: list[str] = []
        self.settled: Settled | None = None
        # Whether the program was left out of the current step; set by sense().
        self.was_quiet = False
        # What the robot sensed in the current step; set by sense().
        self.events: list[Reading] = []
        # The program's last line.
        self.ended: Ended | None = None
        # Whether the program uses the mailbox that it was given.
        self.uses_mailbox = False
        self._guard = VelocityGuard(safety, world.robot.limits)
        # The latest values of the channels on topics that the program takes itself.
        self._latest: dict[str, Values] = {}
        # What every quiet step has settled with.
        self._settled_quietly = Settled(0)
        # Ground truth when the current step was sensed.
        self._sensed = (0.0, 0.0, 0.0, 0.0, 0.0)

    @property
    def time(self) -> float:
        """Simulated seconds since the run began."""
        return self.step / STEPS_PER_SECOND

    @property
    def is_overridden(self) -> bool:
        """Whether the safety rules drive instead of the program."""
        return self._guard.is_overriding

    def switch_safety(self, settings: SafetySettings) -> None:
        """Change the safety rules during the run."""
        self._drive(self._guard.switch(settings))

    def begin(self) -> bytes:
        """What to send first."""
        return start_line(self._seed, self._trace, self._quiet is not None)

    def stop(self) -> bytes:
        """What to send to ask the program to end. Its clean-ups read the states of the last step."""
        return self._late_batch() + stop_line()

    def sense(self, memory: MemoryRequest = "none") -> bytes:
        """
        The batch of the current step, which may ask what the program remembers; empty when the step is quiet. Call when
        ready or integrated.
        """
        world = self.world
        self.events = events = world.sense()
        for event in events:
            self._guard.hear(event)
        if self.commands or self._actions:
            self.commands = []
            self._actions = []
            self.published = []
        if self.unavailable:
            self.unavailable = []
        if self._goals:
            self._take_replies()
        self.conflicts = _NO_CONFLICTS
        self.settled = None
        self.was_quiet = False
        if self._trace:
            self._sensed = (world.x, world.y, world.theta, world.v, world.w)
        step, quiet = self.step, self._quiet
        may_skip = quiet is not None and quiet.covers(step, memory) and not self._posted and not self.observes
        if quiet is not None and may_skip and (not events or quiet.skip(events)):
            quiet.odometry = world.odometry()
            self.settled = self._settled_quietly
            self.settled.step = step
            self.was_quiet = True
            self.state = "settled"
            return b""
        asks = memory != "none"
        late = b""
        if quiet is not None:
            if quiet.odometry is not None:
                late = self._late_batch()
            quiet.end(asks)
        self._link.step = step
        self.state = "thinking"
        last = step_line(step, asks, self.observes)
        if not events and not self._posted and not self._link.subscribed:
            return late + ODOMETRY.line(world.odometry()) + last
        sensed = self._lines([*events, Reading(ODOMETRY.name, world.odometry())])
        # Messages of the program's own topics stand before the odometry.
        sensed[-1:-1] = self._posted
        self._posted = []
        return late + b"".join(sensed) + last

    def _late_batch(self) -> bytes:
        """The states of the quiet steps that have passed; empty when there were none."""
        missed = self._quiet.take_missed() if self._quiet is not None else None
        if missed is None:
            return b""
        return b"".join(self._lines(missed)) + step_line(self.step - 1, late=True)

    def _lines(self, readings: list[Reading]) -> list[bytes]:
        """
        The lines of what the robot sensed in a step.

        On a topic that the program takes itself they are whole messages; the channels that share a topic give one.
        """
        if not self._link.subscribed:
            *others, last = readings
            lines = [reading_line(reading) for reading in others]
            lines.append(ODOMETRY.line(last.values) if last.channel == ODOMETRY.name else reading_line(last))
            return lines
        lines = []
        for index, reading in enumerate(readings):
            channel = CHANNELS[reading.channel]
            if channel.topic not in self._link.subscribed:
                lines.append(ODOMETRY.line(reading.values) if channel is ODOMETRY else reading_line(reading))
                continue
            self._latest[channel.name] = reading.values
            later = (CHANNELS[r.channel] for r in readings[index + 1 :] if r.channel != channel.name)
            if all(other.topic != channel.topic for other in later):
                whole = topic_message(self._latest, channel.topic, self.time, self.step)
                lines.append(TopicMessage(channel.topic, whole).line())
        return lines

    def post(self, message: TopicMessage) -> None:
        """A message for the program, if it takes the topic: in the next step; or one that the robot obeys."""
        if message.topic == RESET_ODOMETRY:
            self.world.reset_odometry()
        if message.topic in self._link.subscribed:
            self._posted.append(message.line())

    def _take_replies(self) -> None:
        for reply in self.world.actions.take_replies(PROGRAM):
            if reply.kind == "result":
                named = self._goals.pop(reply.ident, reply.action)
            else:
                named = self._goals.get(reply.ident, reply.action)
            self._posted.append(_encoder.encode(reply_frame(reply, named)) + b"\n")

    def _call(self, request: Request) -> None:
        """The program calls an action or a service, or takes back a goal."""
        actions = self.world.actions
        if isinstance(request, SendActionGoal):
            self._goals[request.id] = request.action
            is_known = actions.send(PROGRAM, request.id, simulated_action(request.action), request.args)
            if not is_known and not has_substitute(request):
                self.unavailable.append(request.action)
        elif isinstance(request, CancelActionGoal):
            self.cancel_goals(request.id)
        else:
            self.unavailable.append(request.service)
            self._posted.append(_encoder.encode(service_failure(request.id, request.service)) + b"\n")

    def cancel_goals(self, ident: str | None = None) -> None:
        """Take back a goal of the program, or all of them: then the robot stands."""
        if self.world.actions.cancel(PROGRAM, ident):
            self.world.drive(0.0, 0.0)

    def feed(self, data: bytes) -> State:
        """
        Take bytes from the program and obey the commands among them.

        Raises:
            LinkError: the program broke the protocol.
        """
        for message in self._link.feed(data):
            if isinstance(message, Command):
                self._actions.append(message)
                self.commands.append(message)
                self._carry_out(message)
            elif isinstance(message, Settled):
                self.settled = message
                self.state = "settled"
                self.world.listen("program", message.listens)
                # Of a topic that the program takes itself it gets every message.
                if self._quiet is not None and not self._link.subscribed:
                    self._quiet.begin(self.step, message.quiet)
                if self._actions:
                    found = self._commands_in_force.observe(self.step, message.fired, message.sent, self._actions)
                    self.conflicts = found
            elif isinstance(message, Ready):
                self.world.listen("topics", on_demand(self._link.subscribed))
                self.uses_mailbox = message.mailbox
                self.state = "ready"
            elif isinstance(message, Ended):
                self.ended = message
                self.state = "ended"
                self.cancel_goals()
                self.world.listen("program", ())
                self.world.listen("topics", ())
            elif isinstance(message, Request):
                self._call(message)
            else:
                # As in ROS, a program that takes the topic gets its own messages as well.
                self._actions.append(message)
                self.published.append(message)
                self.post(message)
        return self.state

    def _carry_out(self, command: Command) -> None:
        if command.channel == VELOCITY_CHANNEL:
            linear, angular = command.values
            self._drive(self._guard.command(self.step / STEPS_PER_SECOND, float(linear), float(angular)))
        else:
            self.world.command(command)

    def _drive(self, wanted: Velocity | None) -> None:
        if wanted is not None:
            self.world.drive(*wanted)

    def integrate(self) -> None:
        """Let the step's 20 ms pass."""
        self.guard()
        self.world.integrate()
        self.advance()

    def guard(self) -> None:
        """Let the velocity guard look at the settled step."""
        if self.step % GUARD_STEPS == 0 and self.ended is None:
            self._drive(self._guard.tick(self.time))
            if self._goals and self.is_overridden:
                # The rules and the robot's own program would drive at once.
                self.cancel_goals()

    def advance(self) -> None:
        """The step's 20 ms have passed in the world."""
        self.step += 1
        self.is_blocked = self._blocked_drive.observe(self.world)
        if self.has_goals:
            self.goals.observe(self.observation())

    @property
    def has_bumped(self) -> bool:
        """Whether a zone of the bumper is pressed."""
        return self.world.sensors.bumpers != 0

    def observation(self) -> Observation:
        """The state after the last step, for goals and properties."""
        world = self.world
        bits = world.sensors
        return Observation(self.time, world.x, world.y, bits.bumpers, bits.cliffs, bits.wheels, world.is_blocked)

    def channels(self) -> list[str]:
        """The channels of the current step's commands in their order; empty for a topic of the program's own."""
        return [one.channel if isinstance(one, Command) else "" for one in self._actions]

    def said(self) -> list[str]:
        """What the program said in the current step."""
        return [str(c.values[0]) for c in self.commands if c.channel == "Say"]

    def sounds(self) -> list[int]:
        """Which sounds the program asked for in the current step."""
        return [int(c.values[0]) for c in self.commands if c.channel == "Sound"]

    def trace_line(self, provenance: bool = False) -> bytes:
        """The line of `--trace` for the step that has just settled or ended (protocol §8)."""
        x, y, theta, v, w = self._sensed
        done = self.settled or self.ended
        # A program that died in this step has reported nothing of it.
        events, commands, fired = (done.events, done.commands, done.fired) if done is not None else ([], [], [])
        line: dict[str, object] = {
            "t": self.time,
            "x": x,
            "y": y,
            "theta": theta,
            "v": v,
            "w": w,
            "events": events,
            "commands": commands,
            "fired": fired,
        }
        if provenance:
            line["firings"] = done.firings if done is not None else NO_FIRINGS
        return _encoder.encode(line) + b"\n"
