"""When pages are served: turns on the event loop, paced frames, deadlines and timers. They know no page."""

from __future__ import annotations

__all__: list[str] = []
