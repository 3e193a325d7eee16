"""Ports for servers that come and go, while others already try to reach them."""

from __future__ import annotations

import random
import socket
from pathlib import Path

__all__ = ["kept_port"]

_LOWEST = 10_000
"""Below are those that other programs may use."""


def kept_port() -> int:
    """
    A free port that no outgoing connection is ever given. One that is tried without a listener may otherwise
    be given that very port for its own end: it then speaks to itself, and the server finds its port taken. ip(7).
    """
    first_outgoing = int(Path("/proc/sys/net/ipv4/ip_local_port_range").read_text().split()[0])
    while True:
        port = random.randrange(_LOWEST, first_outgoing)
        try:
            with socket.create_server(("127.0.0.1", port)):
                return port
        except OSError:
            continue
