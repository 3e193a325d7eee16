"""WebSockets beside a page's own: class, projector, tests in many rooms, rehearsals of lessons."""

from __future__ import annotations

__all__: list[str] = []
