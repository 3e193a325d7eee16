"""
Command ``./rosy start --cluster``: be a node of a cluster, serve its pages, begin or end a class of it.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from urllib.parse import urlsplit

from ..config import Config
from ..errors import BadInput
from ..sentences.sentence import tr
from .node import start_node, use_token

__all__ = ["add_cluster_options", "run_cluster_command"]


def add_cluster_options(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("--cluster", dest="address", nargs="?", metavar="ADDRESS")
    parser.add_argument("--host")
    parser.add_argument("--port", type=int)
    parser.add_argument("--processes", type=int, metavar="N")
    parser.add_argument("--pages", action="store_true")
    parser.add_argument("--class", dest="class_name", metavar="NAME")
    parser.add_argument("--end", action="store_true")
    parser.add_argument("--origin", metavar="URL")
    parser.add_argument("--unprotected", action="store_true")


def run_cluster_command(config: Config, options: argparse.Namespace, output: Callable[[str], None]) -> int:
    """
    Run it; returns the exit status.

    Raises:
        RosyError: an option, or the cluster, cannot be used.
    """
    _check(options)
    if not (options.pages or options.class_name):
        return start_node(config, options, output)
    if options.address is None:
        raise BadInput(tr("Which cluster? Say --cluster HOST:PORT."))
    # Ray reads how it is to be used when it is imported.
    use_token()
    from .class_command import begin_class, end_class, serve_pages

    if options.pages:
        return serve_pages(config, options)
    return end_class(options, output) if options.end else begin_class(options, output)


def _check(options: argparse.Namespace) -> None:
    """
    Refuse options that do not go together.

    Raises:
        BadInput: one sentence about the first of them.
    """
    if options.pages and options.class_name:
        raise BadInput(tr("--pages and --class are two commands; say one after the other."))
    if options.end and not options.class_name:
        raise BadInput(tr("--end is for --class NAME: the class that ends."))
    if options.origin is None:
        return
    if not (options.pages or options.class_name):
        raise BadInput(tr("--origin is for --class NAME and for --pages."))
    origin = urlsplit(options.origin)
    if origin.scheme not in ("http", "https") or not origin.netloc or origin.path.rstrip("/"):
        raise BadInput(tr("--origin is the address of the pages, such as https://rosy.example, without a path."))
