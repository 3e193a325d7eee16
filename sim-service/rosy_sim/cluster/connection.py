"""Connection of a process to a Ray cluster; a process has at most one."""

from __future__ import annotations

import logging
import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import ray
from ray.exceptions import RayError

from ..sentences.sentence import tr
from .node import SECRET_REFUSED, ClusterError, other_secret, reach

__all__ = ["NAMESPACE", "ClusterError", "connect", "reached"]

NAMESPACE = "rosy"
"""Of the named actors."""


def connect(address: str) -> None:
    """
    Connect this process to the cluster whose head node is at HOST:PORT.

    Raises:
        ClusterError: it is not there or has another secret, no node of it runs here, or Ray's version differs.
    """
    reach(address)
    said_by_ray = b""
    try:
        with _captured_errors() as captured:
            try:
                ray.init(
                    address=address,
                    namespace=NAMESPACE,
                    log_to_driver=False,
                    logging_level=logging.CRITICAL,
                    configure_logging=False,
                )
            finally:
                said_by_ray = captured()
    except (RayError, OSError, RuntimeError, ValueError) as error:
        if SECRET_REFUSED in said_by_ray:
            raise other_secret(address) from error
        said = f"{error.strerror}." if isinstance(error, OSError) and error.strerror else str(error)
        raise ClusterError(
            tr(
                "The cluster at {address} cannot be used from this machine: {why} Start a node of it here: "
                "./rosy start --cluster {address}",
                address=address,
                why=said.strip().split("\n")[0],
            )
        ) from error


@contextmanager
def reached() -> Iterator[None]:
    """
    Calls of the cluster after ``connect``.

    Raises:
        ClusterError: its head, or the actor that was asked, was lost meanwhile.
    """
    try:
        yield
    except RayError as error:
        raise ClusterError(tr("The cluster cannot be reached any more: {why}", why=type(error).__name__)) from error


@contextmanager
def _captured_errors() -> Iterator[Callable[[], bytes]]:
    """Takes what Ray's own code, which is no Python, writes to the standard error; yields what reads it."""
    kept = os.dup(2)
    with tempfile.TemporaryFile() as file:

        def captured() -> bytes:
            file.seek(0)
            return file.read()

        os.dup2(file.fileno(), 2)
        try:
            yield captured
        finally:
            os.dup2(kept, 2)
            os.close(kept)
