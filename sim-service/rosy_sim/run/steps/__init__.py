"""Steps of a run, without a clock: lockstep with a program, quiet steps, safety of velocities, inputs, replay."""

from __future__ import annotations

__all__: list[str] = []
