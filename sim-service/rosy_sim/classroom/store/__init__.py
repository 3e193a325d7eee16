"""Storage of a class: its tables in SQLite or PostgreSQL, where it is, and the thread that writes."""

from __future__ import annotations

__all__: list[str] = []
