"""
Clients of the compiler's process, the worker.

``launcher`` starts it in its sandbox, ``blocking_worker`` serves plain programs, ``supervisor`` serves asyncio and
replaces a worker that has died through ``fork_server``, ``liveness`` detects one that is wedged.
"""

from __future__ import annotations

__all__: list[str] = []
