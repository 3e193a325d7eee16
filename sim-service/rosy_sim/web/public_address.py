"""
Address under which a proxy with TLS serves this Rosy to the internet, and what follows from it.

Pages and requests then name the proxy's host; the address of a client is what the proxy says it is.
"""

from __future__ import annotations

from dataclasses import replace
from urllib.parse import urlsplit

from ..config import Config
from ..errors import BadInput
from ..sentences.sentence import tr

__all__ = ["public_names", "with_public_address"]

_ON_THIS_MACHINE = ("127.0.0.1", "::1")
"""Addresses whose ``X-Forwarded-For`` is believed when ROSY_PROXIES names none; others could forge it."""


def with_public_address(config: Config, url: str) -> Config:
    """
    The configuration of a Rosy behind a proxy that serves it at ``url``, such as ``https://rosy.example``.

    Raises:
        BadInput: it is no such address.
    """
    try:
        parts = urlsplit(url)
        port = parts.port
    except ValueError:
        parts, port = urlsplit(""), None
    # A name that is typed in capitals is the same name, and browsers leave the usual port out.
    host = (parts.hostname or "").rstrip(".")
    if (
        parts.scheme != "https"
        or not host
        or parts.username is not None
        or parts.path.strip("/")
        or parts.query
        or parts.fragment
    ):
        raise BadInput(
            tr(
                "--public takes the address that others open, such as https://rosy.example, and not {address}.",
                address=repr(url),
            )
        )
    name = f"[{host}]" if ":" in host else host
    place = name if port in (None, 443) else f"{name}:{port}"
    return replace(
        config,
        public=f"https://{place}",
        # A proxy may name this service, and not itself, as the host that is asked for.
        origins=config.origins | {place},
        proxies=config.proxies or _ON_THIS_MACHINE,
    )


def public_names(config: Config) -> frozenset[str]:
    """The host names that requests through the proxy carry."""
    host = urlsplit(config.public).hostname if config.public is not None else None
    return frozenset() if host is None else frozenset({host})
