"""Messages of class mode as values, with the limits of their fields."""

from __future__ import annotations

__all__: list[str] = []
