"""
What crosses the borders, as bytes and values: rosbridge messages, the robot link, the worker's and the
page's messages. No sockets, no clocks, no tasks: feed bytes in, take messages out. The tables are in
``protocol/README.md``.
"""

from __future__ import annotations

__all__: list[str] = []
