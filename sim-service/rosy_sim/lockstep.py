"""
A program and a world in step, without any I/O: bytes from the program in, bytes for it out.

The owner moves the bytes and decides when time passes::

    send(lockstep.begin())             feed() until ready
    send(lockstep.sense())             feed() until settled   } once per 20 ms
    lockstep.integrate()                                      }

``feed`` applies commands as they come; nothing moves before ``integrate``.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from .wire.link import Ended, Ready, Settled, SimulatorLink, start_line, step_line, stop_line
from .wire.topics import event_line, odometry_line, show_command, show_event
from .world.events import Command, Event, Say, Sound
from .world.goals import Goals, Moment
from .world.world import World

__all__ = ["Lockstep", "State"]

State = Literal["opening", "ready", "thinking", "settled", "ended"]

_encoder = msgspec.json.Encoder()


class Lockstep:
    """One run of a program in a world."""

    def __init__(self, world: World, seed: int, trace: bool = False) -> None:
        self.world = world
        self._seed = seed
        self._trace = trace
        self._link = SimulatorLink()
        # How far the run is with the goals of its world.
        self.goals = Goals(world.arena.goals)
        # Where the conversation is: opening until `ready`; thinking from sense() to `settled`.
        self.state: State = "opening"
        # Steps integrated so far, and with it the simulated time in units of 20 ms.
        self.step = 0
        # What the program did in the current step; cleared by sense().
        self.commands: list[Command] = []
        self.settled: Settled | None = None
        # What the robot sensed in the current step; set by sense().
        self.events: list[Event] = []
        # The program's last word.
        self.ended: Ended | None = None
        # Ground truth when the current step was sensed.
        self._sensed = (0.0, 0.0, 0.0, 0.0, 0.0)

    @property
    def time(self) -> float:
        """Simulated seconds since the run began."""
        return self.step / 50

    def begin(self) -> bytes:
        """What to send first."""
        return start_line(self._seed, self._trace)

    def stop(self) -> bytes:
        """What to send to ask the program to end."""
        return stop_line()

    def sense(self, memory: bool = False) -> bytes:
        """The batch of the current step, which may ask what the program remembers. Call when ready or integrated."""
        world = self.world
        self.events = events = world.sense()
        self.commands = []
        self.settled = None
        self._link.step = self.step
        self.state = "thinking"
        if self._trace:
            self._sensed = (world.x, world.y, world.theta, world.v, world.w)
        batch = odometry_line(world.odometry()) + step_line(self.step, memory)
        return b"".join(map(event_line, events)) + batch if events else batch

    def feed(self, data: bytes) -> State:
        """
        Take bytes from the program and obey the commands among them.

        Raises:
            LinkError: the program broke the protocol.
        """
        for message in self._link.feed(data):
            if isinstance(message, Settled):
                self.settled = message
                self.state = "settled"
            elif isinstance(message, Ready):
                self.state = "ready"
            elif isinstance(message, Ended):
                self.ended = message
                self.state = "ended"
            else:
                self.commands.append(message)
                self.world.command(message)
        return self.state

    def integrate(self) -> None:
        """Let the step's 20 ms pass."""
        world = self.world
        world.integrate()
        self.step += 1
        if self.goals:
            bits = world.bits
            self.goals.observe(Moment(self.step / 50, world.x, world.y, bits.bumpers, bits.cliffs, bits.wheels))

    def said(self) -> list[str]:
        """What the program said in the current step."""
        return [c.text for c in self.commands if isinstance(c, Say)]

    def sounds(self) -> list[int]:
        """Which sounds the program asked for in the current step."""
        return [c.sound for c in self.commands if isinstance(c, Sound)]

    def trace_line(self) -> bytes:
        """The line of `--trace` for the step that has just settled or ended (DESIGN.md, section 5)."""
        x, y, theta, v, w = self._sensed
        done = self.settled or self.ended
        # A program that died in this step has told nothing of it.
        if done is not None:
            events, commands, fired = done.events, done.commands, done.fired
        else:
            events = [show_event(e) for e in self.events]
            commands, fired = [show_command(c) for c in self.commands], []
        return (
            _encoder.encode(
                {
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
            )
            + b"\n"
        )
