"""
Service of one class on a node of a cluster: what ``./rosy start --class`` serves, as a process of an actor.

In: class, host and the origin of pages as arguments. Out: one line of JSON when it is ready (``Ready``), or
when it could not start (``Failed``). It ends when its input ends, so nothing is left of it when the actor or its node
is gone.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from dataclasses import replace
from urllib.parse import urlsplit

import msgspec

from ..classroom.store.class_store import Admission
from ..config import discover
from ..errors import RosyError
from ..sentences.sentence import Sentence
from ..web.server import serve

__all__ = ["PORTS", "Failed", "Ready", "Started", "main"]

PORTS = range(8100, 8300)
"""Where the classes of a node listen; each takes the first that is free."""


class Ready(msgspec.Struct, frozen=True, tag=True):
    """Where the class is, as HOST:PORT, and what lets people in."""

    address: str
    code: str
    teacher_key: str


class Failed(msgspec.Struct, frozen=True, tag=True):
    """Why it could not start: a sentence, as its template and the values of the placeholders."""

    id: str
    arguments: dict[str, str | int | float]

    @property
    def sentence(self) -> Sentence:
        """The sentence."""
        return Sentence(self.id, self.arguments)


Started = Ready | Failed


def main(name: str, host: str, origin: str) -> int:
    """Serve until a signal, or until standard input ends."""

    def announce(port: int, admission: Admission | None) -> None:
        assert admission is not None
        ready = Ready(f"{host}:{port}", admission.code, admission.teacher_key)
        _tell(ready)

    threading.Thread(target=_end_with_input, daemon=True).start()
    pages = frozenset({urlsplit(origin).netloc})
    config = replace(discover(), class_name=name, origins=pages, class_address=f"{origin}/?class={name}")
    try:
        return serve(config, host, PORTS, open_browser=False, unprotected=False, announce=announce)
    except RosyError as error:
        print(f"rosy: {error}", file=sys.stderr)
        _tell(Failed(error.sentence.id, dict(_plain(error.sentence))))
        return error.exit_status


def _plain(sentence: Sentence) -> Iterator[tuple[str, str | int | float]]:
    for name, value in sentence.arguments.items():
        yield name, value if isinstance(value, str | int | float) else str(value)


def _tell(started: Started) -> None:
    sys.stdout.write(msgspec.json.encode(started).decode() + "\n")
    sys.stdout.flush()


def _end_with_input() -> None:
    # Unbuffered: the interpreter cannot end while a thread holds the lock of a buffer.
    with open(sys.stdin.fileno(), "rb", buffering=0, closefd=False) as file:
        while file.read(1):
            continue
    # What was acknowledged is in the database; the sandbox of the worker dies with this process.
    os._exit(0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
