"""
Command ``./rosy class``: lists, exports and deletes classes.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path

from ..atomic_file import AtomicFile
from ..errors import BadInput
from ..sentences.sentence import tr
from ..sentences.terminal_text import neutralize_line
from ..sentences.wording import in_terminal
from .class_export import write_export
from .store.class_places import ClassPlace

__all__ = ["add_class_options", "run_class_command"]


def add_class_options(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("action", choices=("list", "export", "delete"))
    parser.add_argument("name", nargs="?")
    parser.add_argument("-o", dest="output", type=Path, metavar="FILE")


def run_class_command(place: ClassPlace, options: argparse.Namespace, output: Callable[[str], None]) -> int:
    """
    Run the command; returns the exit status.

    Raises:
        BadInput: there is no such class, or it is in use, or the file cannot be written.
    """
    if options.action != "export" and options.output is not None:
        raise BadInput(tr("-o is for export: the file to write."))
    if options.action == "list":
        for name in place.names():
            output(name)
        return 0
    name = _chosen(place, options.name)
    if options.action == "delete":
        place.delete(name)
        output(in_terminal(tr("The class {name} is deleted.", name=name)))
        return 0
    target = options.output or Path(f"{name}.zip")
    with place.read(name) as store, AtomicFile(target) as file:
        programs = write_export(store, file)
        pupils = len(store.pupils())
    written = tr(
        "{file}: {pupils} pupils, {programs} programs.",
        file=neutralize_line(str(target)),
        pupils=pupils,
        programs=programs,
    )
    output(in_terminal(written))
    return 0


def _chosen(place: ClassPlace, name: str | None) -> str:
    """The named class, or the only one that there is."""
    if name is not None:
        return name
    names = place.names()
    if not names:
        raise BadInput(tr("There is no class yet; ./rosy start --class begins one."))
    if len(names) > 1:
        raise BadInput(tr("Which class? There are {names}.", names=list(names)))
    return names[0]
