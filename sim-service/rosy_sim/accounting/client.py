"""
Client: whom work is charged to. An address in the open, a pupil in a class, a page on this machine itself.
"""

from __future__ import annotations

import ipaddress
from dataclasses import dataclass

__all__ = ["SERVICE", "Client", "network_of"]

_OWN = frozenset({"", "127.0.0.1", "::1"})
"""Addresses of the machine itself, whose pages are clients of their own. A reverse proxy has them, too."""

_PREFIX = 64
"""Bits of an IPv6 address that a network is given; its machines choose the others. RFC 4291, section 2.5.4."""


def network_of(address: str) -> str:
    """What counts as one address: an IPv4 address, the network of an IPv6 address, or the text itself."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if isinstance(found, ipaddress.IPv4Address):
        return address
    if found.ipv4_mapped is not None:
        return str(found.ipv4_mapped)
    return address if found.is_loopback else str(ipaddress.IPv6Network((int(found), _PREFIX), strict=False))


@dataclass(eq=False, slots=True)
class Client:
    """The client of one page; ``page`` is a name that no other page has."""

    address: str
    page: str
    # Set when the page has joined the class as this pupil.
    pupil: int | None = None

    @property
    def name(self) -> str:
        """Equal for the pages that have one budget together."""
        if self.pupil is not None:
            return f"pupil {self.pupil}"
        return f"page {self.page}" if self.address in _OWN else self.network

    @property
    def network(self) -> str:
        """The address, as far as it counts."""
        return network_of(self.address)


SERVICE = Client("", "service")
"""For work that no page asks for."""
