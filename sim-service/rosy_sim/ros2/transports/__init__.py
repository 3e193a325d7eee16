"""Transports of ROS 2: names, messages and graph over DDS and over Zenoh, behind one interface."""

from __future__ import annotations

__all__: list[str] = []
