"""
A run that somebody watches: lockstep driven by an event loop at a chosen speed, or paused, or step by step.

No task per step: the loop calls back when the program has answered and when the next step is due, which keeps
hundreds of runs on one core. Ends with exactly one call of ``on_end``.
"""

from __future__ import annotations

import asyncio
import socket
import time
from collections import deque
from typing import Literal, Protocol

from .budget import Budget
from .config import Limits
from .lockstep import Lockstep
from .wire.link import LinkError, TooMuch
from .wire.page import Speed
from .world.facts import STEP

__all__ = ["Ending", "Lateness", "LiveRun", "Watcher"]

Ending = Literal["done", "error", "stopped", "stuck", "died", "broken", "loud"]

_LOOK = 0.1
"""How often the program's memory is looked at, s; each single step looks too."""

_FALL_BEHIND = 0.25
"""A run that is later than this forgets the lost time instead of hurrying after it, s."""

_PATROL = 0.25
"""How often a run's deadline is looked at, s."""


_OUTPUT = 20e6
"""Bytes that a program may send in a second for long: forty times what the fastest of the examples sends."""


_MAX_FORWARDS = 1000
"""Single steps that may be asked for ahead of time."""


class Lateness:
    """How late steps began, s: how many there were, and the last some thousand of them."""

    def __init__(self, size: int = 50_000) -> None:
        self._samples: deque[float] = deque(maxlen=size)
        # Steps since the last clear().
        self._steps = 0

    def add(self, late: float) -> None:
        """Remember one step."""
        self._steps += 1
        self._samples.append(late)

    def summary(self) -> dict[str, float]:
        """Count, median, 99th percentile and worst."""
        samples = sorted(self._samples)
        if not samples:
            return {"steps": 0, "p50": 0.0, "p99": 0.0, "worst": 0.0}
        n = len(samples)
        return {
            "steps": self._steps,
            "p50": samples[n // 2],
            "p99": samples[min(n - 1, n * 99 // 100)],
            "worst": samples[-1],
        }

    def clear(self) -> None:
        """Forget all."""
        self._steps = 0
        self._samples.clear()


class Watcher(Protocol):
    """Who is told what happens; called on the loop, must not block."""

    def on_step(self, lockstep: Lockstep) -> None:
        """A step has settled and its time has passed."""

    def on_end(self, lockstep: Lockstep, ending: Ending, detail: str) -> None:
        """The run is over; ``detail`` is for ``broken`` and ``loud``."""


class LiveRun:
    """Owns our end of the link until it ends."""

    def __init__(
        self, link: socket.socket, lockstep: Lockstep, speed: Speed, limits: Limits, watcher: Watcher, late: Lateness
    ) -> None:
        self._loop = asyncio.get_running_loop()
        self._link = link
        self._lockstep = lockstep
        self._speed = speed
        self._limits = limits
        self._watcher = watcher
        self._late = late
        # The clock stands; forward() makes single steps.
        self.paused = False
        # Single steps asked for and not made yet.
        self._forwards = 0
        # When the next step is due, on the loop's clock; moved on by each step.
        self._due = 0.0
        self._timer: asyncio.TimerHandle | None = None
        # When the memory was looked at last, on the loop's clock.
        self._looked = 0.0
        # When the program must have answered, on the monotonic clock; None while it owes nothing.
        self._deadline: float | None = time.monotonic() + limits.ready
        # When that was looked at last.
        self._patrolled = time.monotonic()
        self._stopping = False
        self._over = False
        self._allowance = Budget(_OUTPUT, 2 * _OUTPUT, self._loop.time())
        link.setblocking(False)
        self._loop.add_reader(link, self._read)
        self._patrol: asyncio.TimerHandle = self._loop.call_later(_PATROL, self._look_at_deadline)
        self._send(lockstep.begin())

    # What the watcher may ask

    def set_speed(self, speed: Speed) -> None:
        """Change the clock from the next step on."""
        self._speed = speed
        self._due = self._loop.time()
        if self._timer is not None:
            self._timer.cancel()
            self._next()

    def pause(self) -> None:
        """Stop before the next step."""
        self.paused = True
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def resume(self) -> None:
        """Go on."""
        if self.paused:
            self.paused = False
            self._forwards = 0
            self._due = self._loop.time()
            self._go_on()

    def forward(self) -> None:
        """One step while paused."""
        if self.paused:
            self._forwards = min(self._forwards + 1, _MAX_FORWARDS)
            self._go_on()

    def stop(self) -> None:
        """Ask the program to end; kill it (through the watcher) when it does not."""
        if self._stopping or self._over:
            return
        self._stopping = True
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        self._deadline = time.monotonic() + self._limits.stop
        self._send(self._lockstep.stop())

    def abandon(self) -> None:
        """Close the link without a word to anybody."""
        self._finish()

    # Steps

    def _go_on(self) -> None:
        if self._lockstep.state in ("ready", "settled") and not self._stopping:
            self._next()

    def _next(self) -> None:
        """Arrange for the next step at its time."""
        self._timer = None
        if self._stopping or self._over:
            return
        if self.paused:
            if self._forwards:
                self._forwards -= 1
                self._step()
            return
        if self._speed == "max":
            self._step()
            return
        now = self._loop.time()
        if now - self._due > _FALL_BEHIND:
            self._due = now
        if self._due <= now:
            self._step_due()
        else:
            self._timer = self._loop.call_at(self._due, self._step_due)

    def _step_due(self) -> None:
        assert self._speed != "max"
        self._timer = None
        self._late.add(max(0.0, self._loop.time() - self._due))
        self._due += STEP / self._speed
        self._step()

    def _step(self) -> None:
        self._deadline = time.monotonic() + self._limits.settle
        now = self._loop.time()
        looks = self.paused or now - self._looked >= _LOOK
        if looks:
            self._looked = now
        self._send(self._lockstep.sense(looks))

    def _read(self) -> None:
        try:
            data = self._link.recv(65536)
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            data = b""
        if not data:
            self._end("died", "")
            return
        if not self._allowance.spend(len(data), self._loop.time()):
            self._end("loud", f"more than {_OUTPUT:.0f} bytes a second")
            return
        before = self._lockstep.state
        try:
            state = self._lockstep.feed(data)
        except TooMuch as error:
            self._end("loud", str(error))
            return
        except LinkError as error:
            self._end("broken", str(error))
            return
        if state == before:
            return
        if state == "ended":
            assert self._lockstep.ended is not None
            self._watcher.on_step(self._lockstep)
            self._end(self._lockstep.ended.how, "")
            return
        if not self._stopping:
            self._deadline = None
        if state == "ready":
            self._due = self._loop.time()
        elif state == "settled":
            self._lockstep.integrate()
            self._watcher.on_step(self._lockstep)
        self._go_on()

    def _send(self, data: bytes) -> None:
        try:
            sent = self._link.send(data)
        except (BlockingIOError, InterruptedError):
            sent = 0
        except OSError:
            # The reader sees the end of the stream and what was said before it.
            return
        if sent < len(data):
            # At most a batch is ever under way: a full pipe means that the program reads nothing.
            self._loop.call_soon(self._end, "stuck", "")

    def _look_at_deadline(self) -> None:
        now = time.monotonic()
        stood = now - self._patrolled - _PATROL
        self._patrolled = now
        if self._deadline is not None and stood > _PATROL:
            # We did not run ourselves, as on a machine that was asleep: the answer may be here, unread.
            self._deadline += stood
        if self._deadline is not None and now > self._deadline:
            self._end("stopped" if self._stopping else "stuck", "")
            return
        self._patrol = self._loop.call_later(_PATROL, self._look_at_deadline)

    def _end(self, ending: Ending, detail: str) -> None:
        if not self._over:
            self._finish()
            self._watcher.on_end(self._lockstep, "stopped" if self._stopping and ending == "died" else ending, detail)

    def _finish(self) -> None:
        self._over = True
        self._loop.remove_reader(self._link)
        self._patrol.cancel()
        if self._timer is not None:
            self._timer.cancel()
        self._link.close()
