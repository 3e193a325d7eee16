"""
Real-time runner: drives a lockstep on the event loop at a chosen speed, paused, or step by step.

It needs no task per step: the loop calls back when the program has answered and when the next step is due, which keeps
hundreds of runs on one core. It ends with exactly one call of ``on_end``, except after abandon().
"""

from __future__ import annotations

import asyncio
import socket
import time
from collections.abc import Callable
from typing import Literal, Protocol

from ..config import Limits
from ..wire.page import Speed
from ..world.time_step import STEP
from .companions import Companions
from .lateness import Lateness
from .loop_link import LoopLink
from .step_phases import StepPhases
from .steps.lockstep import Lockstep
from .steps.quiet_steps import MemoryRequest

__all__ = ["Ending", "RealTimeRunner", "RunnerListener"]

Ending = Literal["done", "error", "stopped", "stuck", "died", "broken", "loud"]

_MEMORY_INTERVAL = 0.1
"""Between two requests for the program's memory, s; each single step requests it as well."""

_MAX_LAG = 0.25
"""A run that is later than this drops the lost time instead of catching up, s."""

_DEADLINE_INTERVAL = 0.25
"""Between two checks of the deadline, s."""

_MAX_SINGLE_STEPS = 1000
"""Single steps that may be requested ahead of time."""


class RunnerListener(Protocol):
    """Receives what happens, on the event loop; must not block."""

    def on_step(self, lockstep: Lockstep) -> None:
        """A step has settled and its time has passed."""

    def on_end(self, lockstep: Lockstep, ending: Ending, detail: str) -> None:
        """The run is over; ``detail`` is for ``broken`` and ``loud``."""


class RealTimeRunner:
    """Drives one run until it ends. Implements ``LinkListener``."""

    def __init__(
        self,
        link: socket.socket,
        lockstep: Lockstep,
        limits: Limits,
        lateness: Lateness,
        phases: StepPhases,
        listener: RunnerListener,
        speed: Speed = 1.0,
        replayed: int = 0,
        clock: Callable[[], float] = time.monotonic,
        companions: Companions | None = None,
    ) -> None:
        self._loop = asyncio.get_running_loop()
        # Of deadlines, s.
        self._clock = clock
        self._lockstep = lockstep
        self._speed = speed
        self._limits = limits
        self._listener = listener
        self._lateness = lateness
        self._phases = phases
        # That of this run while it is at real time.
        self._phase: int | None = None
        # The steps before this one are made as fast as possible, also while the clock is stopped.
        self._replayed = replayed
        # Whether the clock is stopped; forward() makes single steps.
        self.paused = False
        # Single steps requested and not made yet.
        self._single_steps = 0
        # When the next step is due, on the loop's clock; moved on by each step.
        self._due = 0.0
        self._timer: asyncio.Handle | None = None
        # When the memory was requested last, on the loop's clock.
        self._memory_read = 0.0
        # When the program must have answered, on that clock; None while no answer is due.
        self._deadline: float | None = clock() + limits.ready
        # When the deadline was checked last.
        self._deadline_checked = clock()
        self._stopping = False
        self._over = False
        # The programs of the other robots in the room, which make the same steps; None without any.
        self._companions = companions
        # Whether a step has been sensed and is not integrated yet.
        self._is_in_step = False
        self._link = LoopLink(link, lockstep, self)
        self._deadline_timer: asyncio.TimerHandle = self._loop.call_later(_DEADLINE_INTERVAL, self._check_deadline)
        if companions is not None:
            companions.on_settled = self._on_companions_settled
        self._link.send(lockstep.begin())

    # Requests

    def set_speed(self, speed: Speed) -> None:
        """Change the speed of the clock from the next step on."""
        self._speed = speed
        self._start_clock()
        if self._timer is not None:
            self._timer.cancel()
            self._next()

    def pause(self) -> None:
        """Stop before the next step."""
        self.paused = True
        self._leave_phase()
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def resume(self) -> None:
        """Restart the clock."""
        if self.paused:
            self.paused = False
            self._single_steps = 0
            self._start_clock()
            self._continue()

    def forward(self) -> None:
        """Make one step while paused."""
        if self.paused:
            self._single_steps = min(self._single_steps + 1, _MAX_SINGLE_STEPS)
            self._continue()

    def stop(self) -> None:
        """Ask the program to end. One that does not end in time is reported as stopped, and the listener kills it."""
        if self._stopping or self._over:
            return
        self._stopping = True
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        self._deadline = self._clock() + self._limits.stop
        self._link.send(self._lockstep.stop())

    def abandon(self) -> None:
        """Close the link without calling the listener."""
        self._finish()

    # Steps

    def _start_clock(self) -> None:
        """The next step is due now; at real time in a phase that few runs have."""
        self._leave_phase()
        now = self._loop.time()
        if self._speed == 1 and not self.paused:
            self._phase, self._due = self._phases.enter(now)
        else:
            self._due = now

    def _leave_phase(self) -> None:
        if self._phase is not None:
            self._phases.leave(self._phase)
            self._phase = None

    def _continue(self) -> None:
        if self._lockstep.state in ("ready", "settled") and not self._stopping and self._are_companions_settled():
            self._next()

    def _are_companions_settled(self) -> bool:
        return self._companions is None or self._companions.are_settled

    def _on_companions_settled(self) -> None:
        if self._over:
            return
        if self._lockstep.state == "settled" and self._is_in_step:
            self._finish_step()
        if not self._is_in_step and self._timer is None:
            self._continue()

    def _next(self) -> None:
        """Make the next step, or schedule it."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if self._stopping or self._over:
            return
        if self._lockstep.step < self._replayed:
            self._due = self._loop.time()
            self._step()
            return
        if self.paused:
            if self._single_steps:
                self._single_steps -= 1
                self._step()
            return
        if self._speed == "max":
            self._step()
            return
        now = self._loop.time()
        if now - self._due > _MAX_LAG:
            self._start_clock()
        if self._due <= now:
            self._step_due()
        else:
            self._timer = self._loop.call_at(self._due, self._step_due)

    def _step_due(self) -> None:
        assert self._speed != "max"
        self._timer = None
        self._lateness.add(max(0.0, self._loop.time() - self._due))
        self._due += STEP / self._speed
        self._step()

    def _step(self) -> None:
        now = self._loop.time()
        memory: MemoryRequest = "none"
        if self.paused:
            memory = "now"
        elif now - self._memory_read >= _MEMORY_INTERVAL:
            memory = "soon"
        batch = self._lockstep.sense(memory)
        if self._companions is not None:
            self._is_in_step = True
            self._companions.sense()
        if not batch:
            if not self._are_companions_settled():
                return
            self._finish_step()
            # Not at once: other runs have their turn between two steps at full speed.
            self._timer = self._loop.call_soon(self._next)
            return
        if memory != "none":
            self._memory_read = now
        self._deadline = self._clock() + self._limits.settle
        self._link.send(batch)

    def _finish_step(self) -> None:
        """A step has settled, for all programs."""
        lockstep, companions = self._lockstep, self._companions
        if companions is not None:
            self._is_in_step = False
            companions.settle(lockstep.step >= self._replayed)
        lockstep.integrate()
        if companions is not None:
            companions.advance()
        self._listener.on_step(self._lockstep)

    # LinkListener

    def on_answer(self) -> None:
        """The program has answered."""
        state = self._lockstep.state
        if state == "ended":
            assert self._lockstep.ended is not None
            self._listener.on_step(self._lockstep)
            self.on_failure(self._lockstep.ended.how, "")
            return
        if not self._stopping:
            self._deadline = None
        if state == "ready":
            self._start_clock()
        elif state == "settled":
            if not self._are_companions_settled():
                return
            self._finish_step()
        self._continue()

    def on_failure(self, failure: Ending, detail: str) -> None:
        """The run is over, by itself or because nothing comes any more."""
        if not self._over:
            self._finish()
            ending = "stopped" if self._stopping and failure == "died" else failure
            self._listener.on_end(self._lockstep, ending, detail)

    def _check_deadline(self) -> None:
        now = self._clock()
        paused_for = now - self._deadline_checked - _DEADLINE_INTERVAL
        self._deadline_checked = now
        if self._deadline is not None and paused_for > _DEADLINE_INTERVAL:
            # This process was suspended, as when the machine sleeps: the answer may have arrived unread.
            self._deadline += paused_for
        if self._companions is not None:
            # As much as has passed, but not what passed while this process was suspended.
            self._companions.check_deadline(min(_DEADLINE_INTERVAL + paused_for, 2 * _DEADLINE_INTERVAL))
        if self._over:
            return
        if self._deadline is not None and now > self._deadline:
            self.on_failure("stopped" if self._stopping else "stuck", "")
            return
        self._deadline_timer = self._loop.call_later(_DEADLINE_INTERVAL, self._check_deadline)

    def _finish(self) -> None:
        self._over = True
        self._leave_phase()
        self._deadline_timer.cancel()
        if self._timer is not None:
            self._timer.cancel()
        self._link.close()
