"""Web application behind the page: server, page sessions, what a page is shown, static files, ROS clients."""

from __future__ import annotations

__all__: list[str] = []
