"""The fixed time step of the simulation. ``protocol/README.md``, section 2: a step is 20 ms of simulated time."""

from __future__ import annotations

__all__ = ["STEP", "STEPS_PER_SECOND"]

STEPS_PER_SECOND = 50
"""Steps in a simulated second."""

STEP = 0.02
"""Simulated time of one step, s."""
