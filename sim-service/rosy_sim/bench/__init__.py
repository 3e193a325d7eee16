"""Measurements of the simulator, each with the command that gives it: ``python -m rosy_sim.bench NAME``."""

from __future__ import annotations

__all__: list[str] = []
