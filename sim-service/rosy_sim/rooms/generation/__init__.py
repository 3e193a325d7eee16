"""Generated rooms: families, their variation by a seed, and the reductions that shrink a room."""

from __future__ import annotations

__all__: list[str] = []
