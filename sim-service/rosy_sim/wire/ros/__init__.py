"""ROS 1 as rosbridge speaks it: message types by their definitions, operations, encodings, fragments, rosapi."""

from __future__ import annotations

__all__: list[str] = []
