"""Connection of a process to a Ray cluster; a process has at most one."""

from __future__ import annotations

import logging
import socket

import ray
from ray.exceptions import RayError

from ..errors import RosyError
from ..sentence import tr

__all__ = ["NAMESPACE", "ClusterError", "connect"]

NAMESPACE = "rosy"
"""Of the named actors."""

_CONNECT = 30.0
"""For the head node to accept a connection, s."""


class ClusterError(RosyError):
    """The cluster cannot be used from this machine, or not any more."""


def connect(address: str) -> None:
    """
    Connect this process to the cluster whose head node is at HOST:PORT.

    Raises:
        ClusterError: it is not there, no node of it runs on this machine, or its version differs.
    """
    try:
        # Ray would try for minutes.
        with socket.create_connection(_host_and_port(address), _CONNECT):
            pass
        ray.init(
            address=address,
            namespace=NAMESPACE,
            log_to_driver=False,
            logging_level=logging.CRITICAL,
            configure_logging=False,
        )
    except (RayError, OSError, RuntimeError, ValueError) as error:
        said = f"{error.strerror}." if isinstance(error, OSError) and error.strerror else str(error)
        raise ClusterError(
            tr(
                "The cluster at {address} cannot be used from this machine: {why} Start a node of it here: "
                "./rosy start --cluster {address}",
                address=address,
                why=said.strip().split("\n")[0],
            )
        ) from error


def _host_and_port(address: str) -> tuple[str, int]:
    host, _, port = address.rpartition(":")
    if not host or not port.isdecimal():
        raise ValueError("HOST:PORT.")
    return host, int(port)
