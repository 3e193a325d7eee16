"""
Addresses of robots on ROS 2: ``ros2:DOMAIN@HOST/NAMESPACE?options``, all of whose parts may be absent. Pure but for
the default domain.

``HOST`` is a computer that alone is asked, without multicast: for networks that do not carry it, and for one of several
robots with the same topics. With a port it is a router of Zenoh. Whether an address is valid is decided by
``rosy-robot`` (Rosy.Robots.Target).
"""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from urllib.parse import parse_qsl, urlencode

__all__ = ["Ros2Address", "is_router", "parse_ros2_address"]

_ADDRESS = re.compile(r"ros2:(\d{1,3})?(?:@([^/?]+))?((?:/[^/?]+)*)(?:\?(.*))?")


@dataclass(frozen=True, slots=True)
class Ros2Address:
    """``host`` is ``None`` when only multicast is used; ``namespace`` is empty or has a slash first."""

    domain: int
    host: str | None
    namespace: str
    options: tuple[tuple[str, str], ...] = ()

    def bare(self) -> str:
        """Without options; robots of one domain are told apart by their namespaces."""
        return f"ros2:{self.domain}{'' if self.host is None else f'@{self.host}'}{self.namespace}"

    def text(self) -> str:
        """With its options."""
        return f"{self.bare()}?{urlencode(self.options, safe='/')}" if self.options else self.bare()


def is_router(host: str) -> bool:
    """Whether a host is a router of Zenoh: one with a port, which computers on DDS do not have."""
    return re.search(r":\d+$", host) is not None


def parse_ros2_address(address: str) -> Ros2Address | None:
    """
    ``None`` when it is none of ROS 2. The domain that is not given is that of ``ROS_DOMAIN_ID``, as everywhere in
    ROS 2.
    """
    found = _ADDRESS.fullmatch(address)
    if found is None:
        return None
    usual = os.environ.get("ROS_DOMAIN_ID", "")
    domain = int(found[1] or (usual if usual.isdecimal() else 0))
    return Ros2Address(domain, found[2], found[3], tuple(parse_qsl(found[4] or "", keep_blank_values=True)))
