"""Page sessions: what the service keeps of one page, its runs, previews, checks and what it is sent."""

from __future__ import annotations

__all__: list[str] = []
