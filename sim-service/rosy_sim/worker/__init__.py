"""
The worker from outside: starting it in its sandbox, asking it, noticing when it dies.

``launch`` starts a process, ``blocking`` asks it from a plain program, ``client`` from asyncio, ``pulse`` tells whether
it lives.
"""

from __future__ import annotations

__all__: list[str] = []
