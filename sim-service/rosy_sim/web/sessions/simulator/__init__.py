"""Simulated robot of one page: its room, hands on it, its ROS clients, and time without a program."""

from __future__ import annotations

__all__: list[str] = []
