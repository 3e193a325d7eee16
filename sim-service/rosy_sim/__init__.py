"""A simulated robot, the programs that drive it and the page that shows it."""

from __future__ import annotations

__all__: list[str] = []
