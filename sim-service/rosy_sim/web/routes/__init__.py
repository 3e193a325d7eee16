"""HTTP API of the web application, by subject."""

from __future__ import annotations

__all__: list[str] = []
