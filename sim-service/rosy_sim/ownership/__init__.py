"""Real robots: their registry and configuration, the locks of their drivers, their processes and runs."""

from __future__ import annotations

__all__: list[str] = []
