"""
LAN addresses of this machine: under which others on the network reach a service that listens on all interfaces.

Nothing is sent, so it works without the internet and on a laptop that is the network's access point.
"""

from __future__ import annotations

import ipaddress

import ifaddr

__all__ = ["is_unspecified", "lan_addresses"]

_INTERNAL = ("docker", "br-", "veth", "virbr")
"""Prefixes of interfaces to networks inside of this machine."""


def is_unspecified(host: str) -> bool:
    """Whether a service that listens there is reachable by every address of the machine."""
    try:
        return ipaddress.ip_address(host).is_unspecified
    except ValueError:
        return False


def lan_addresses() -> list[str]:
    """The IPv4 addresses of this machine that others can reach, in the order of its interfaces."""
    return [
        str(address.ip)
        for adapter in ifaddr.get_adapters()
        if not adapter.name.startswith(_INTERNAL)
        for address in adapter.ips
        if address.is_IPv4 and not ipaddress.ip_address(str(address.ip)).is_loopback
    ]
