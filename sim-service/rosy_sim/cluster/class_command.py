"""
Live classes of a cluster from the command line: ``./rosy start --cluster ADDRESS --pages`` serves the page and tells
pages where their class is; ``--class NAME`` has a class served by a node, and ``--end`` ends it.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import replace
from typing import Any
from urllib.parse import urlsplit

import ray
from ray.exceptions import RayError

from ..classroom.store.class_folder import check_name
from ..config import Config
from ..errors import BadInput
from ..sentences.sentence import tr
from ..sentences.wording import in_terminal
from ..web.lan_addresses import lan_addresses
from ..web.server import serve
from .class_routes import class_routes
from .class_service import Failed, Ready
from .classes import directory
from .connection import reached

__all__ = ["DEFAULT_PORT", "begin_class", "end_class", "serve_pages"]

DEFAULT_PORT = 8080
"""Where pages are served, as by ``./rosy start``."""


def serve_pages(config: Config, options: argparse.Namespace) -> int:
    """
    Serve the page, and where each class is, until an interrupt; returns the exit status.

    Raises:
        ClusterError: the cluster cannot be used from this machine.
        BadInput: the address cannot be used.
    """
    classes = directory(options.address)

    async def find(name: str) -> str | None:
        try:
            found: Ready | None = await classes.find.remote(name)
        except RayError:
            return None
        return None if found is None else found.address

    async def services() -> dict[str, str] | None:
        try:
            found: dict[str, str] = await classes.services.remote()
        except RayError:
            return None
        return found

    host = options.host or "0.0.0.0"
    if options.origin is not None:
        # Behind a proxy pages come from its address.
        config = replace(config, origins=frozenset({urlsplit(options.origin).netloc}))
    more = class_routes(find, services)
    return serve(config, host, _port(options), False, options.unprotected, more=more)


def begin_class(options: argparse.Namespace, output: Callable[[str], None]) -> int:
    """
    Have a class served by a node, and print what lets people in; returns the exit status.

    Raises:
        ClusterError: the cluster cannot be used from this machine.
        BadInput: the name cannot be used, or the class cannot start.
    """
    check_name(options.class_name)
    own = f"http://{next(iter(lan_addresses()), '127.0.0.1')}:{_port(options)}"
    origin = (options.origin or own).rstrip("/")
    classes = directory(options.address)
    with reached():
        return _begin(classes, options.class_name, origin, output)


def _begin(classes: Any, name: str, origin: str, output: Callable[[str], None]) -> int:
    is_new = name not in ray.get(classes.names.remote())
    has_room = not is_new or ray.get(classes.has_room.remote())
    # Before anything is printed: an interrupt of the wait leaves a class that has begun.
    ray.get(classes.place.remote(name, origin))
    if not has_room:
        full = tr(
            "No node has room for the class now. It begins when a node joins that serves classes (docs/district.md), "
            "or when another class ends; Ctrl-C ends the wait."
        )
        output(in_terminal(full))
    else:
        output(in_terminal(tr("A node with room for the class is chosen, and the class starts there.")))
    found = _wait_for(classes, name, is_new, output)
    pupils = f"{origin}/?class={name}#class={found.code}"
    board = f"{origin}/board.html?class={name}#key={found.teacher_key}"
    output(in_terminal(tr("Pupils open     {addresses}", addresses=pupils)))
    output(in_terminal(tr("Class code      {code}", code=found.code)))
    output(in_terminal(tr("Teacher's board {address}", address=board)))
    output(in_terminal(tr("Keep the board's address to yourself: its key shows all programs.")))
    output(in_terminal(tr("The class is on {address} now.", address=found.address)))
    return 0


def end_class(options: argparse.Namespace, output: Callable[[str], None]) -> int:
    """
    End a class, which stays in the database; returns the exit status.

    Raises:
        ClusterError: the cluster cannot be used from this machine.
        BadInput: no node serves it.
    """
    classes = directory(options.address)
    with reached():
        has_ended = ray.get(classes.end.remote(options.class_name))
    if not has_ended:
        raise BadInput(tr("No node serves a class called {name}.", name=options.class_name))
    output(in_terminal(tr("The class {name} has ended; its programs are kept.", name=options.class_name)))
    return 0


def _wait_for(classes: Any, name: str, is_new: bool, output: Callable[[str], None]) -> Ready:
    """
    Where a class is, when a node has room for it and it has started; an interrupt ends the wait.

    Raises:
        BadInput: a class that was not begun before cannot start; it is begun no more.
    """
    told: Failed | None = None
    while True:
        found: Ready | None = ray.get(classes.find.remote(name))
        if found is not None:
            return found
        fault: Failed | None = ray.get(classes.fault.remote(name))
        if fault is not None and is_new:
            ray.get(classes.end.remote(name))
            raise BadInput(fault.sentence)
        if fault is not None and fault != told:
            told = fault
            output(in_terminal(fault.sentence))
            output(in_terminal(tr("It is tried again; Ctrl-C ends the wait, and --end the class.")))


def _port(options: argparse.Namespace) -> int:
    return DEFAULT_PORT if options.port is None else int(options.port)
