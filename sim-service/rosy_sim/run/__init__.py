"""Runs of programs: lockstep with a world, the clocks that drive it, the queue of runs, and how a run ends."""

from __future__ import annotations

__all__: list[str] = []
