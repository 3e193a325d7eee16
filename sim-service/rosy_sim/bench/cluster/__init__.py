"""A cluster of nodes on this machine beside one machine: programs in rooms, and a class."""

from __future__ import annotations

__all__: list[str] = []
