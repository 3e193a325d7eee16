"""Attacks on a running service, and how long the others wait meanwhile."""

from __future__ import annotations

__all__: list[str] = []
