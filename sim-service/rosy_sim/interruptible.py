"""
Waits of the main thread that an interrupt (Ctrl-C) ends, also in a process with other threads.

The system may give a signal to any thread of a process, and Python runs its handler in the main thread, when that next
wakes: without a wake-up of its own a main thread that waits for others would not notice it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import Future, wait
from typing import TypeVar

__all__ = ["results"]

_T = TypeVar("_T")

_WAKE_EVERY = 0.2
"""How often the main thread wakes, s."""


def results(futures: Iterable[Future[_T]]) -> Iterator[_T]:
    """
    The results in the order of the futures, each as soon as it is there; raises what a future raised.

    Futures that have not begun by an interrupt or an error are cancelled.
    """
    waiting = list(futures)
    try:
        for future in waiting:
            while not wait((future,), timeout=_WAKE_EVERY).done:
                pass
            yield future.result()
    finally:
        for future in waiting:
            future.cancel()
