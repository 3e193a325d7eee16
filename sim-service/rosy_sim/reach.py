"""
Where others on the network find a service that listens for everybody: a class must be told an address that it can type.

Nothing is asked of the network, so it works without the internet and on a laptop that is the network itself.
"""

from __future__ import annotations

import fcntl
import ipaddress
import socket
import struct

__all__ = ["is_everybody", "own_addresses"]

_SIOCGIFADDR = 0x8915
"""The IPv4 address of an interface. netdevice(7)."""

_NAME = 15
"""Longest name of an interface, in bytes. netdevice(7), IFNAMSIZ."""

_INNER = ("docker", "br-", "veth", "virbr")
"""How the networks begin that a machine has within itself; nobody else is there."""


def is_everybody(host: str) -> bool:
    """Whether a service that listens there is reached by any of the machine's addresses."""
    try:
        return ipaddress.ip_address(host).is_unspecified
    except ValueError:
        return False


def own_addresses() -> list[str]:
    """The IPv4 addresses of this machine that others may know, in the order of its interfaces."""
    found: list[str] = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        for _, name in socket.if_nameindex():
            if name.startswith(_INNER):
                continue
            request = struct.pack("256s", name.encode()[:_NAME])
            try:
                answer = fcntl.ioctl(asked.fileno(), _SIOCGIFADDR, request)
            except OSError:
                # An interface without an address.
                continue
            address = socket.inet_ntoa(answer[20:24])
            if not ipaddress.ip_address(address).is_loopback:
                found.append(address)
    return found
