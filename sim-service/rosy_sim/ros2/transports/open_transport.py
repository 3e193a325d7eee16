"""
Which transports an address of ROS 2 asks: DDS and Zenoh, whichever the robot speaks, or Zenoh alone where the port of a
router is given.
"""

from __future__ import annotations

from .address import is_router
from .dds_transport import DdsTransport
from .transport import Transport, Transports
from .zenoh_transport import ZenohTransport

__all__ = ["open_transport"]

_ROUTER_PORT = 7447
"""Where a router listens, on all addresses of its computer (rmw_zenoh, DEFAULT_RMW_ZENOH_ROUTER_CONFIG.json5)."""


def open_transport(domain: int, host: str | None) -> Transport:
    """
    Enter a domain. ``host`` is a computer, or the address of a router of Zenoh with its port; without one DDS uses
    multicast, and the router is that of this computer.
    """
    if host is not None and is_router(host):
        return ZenohTransport(domain, host)
    return Transports((DdsTransport(domain, host), ZenohTransport(domain, f"{host or 'localhost'}:{_ROUTER_PORT}")))
