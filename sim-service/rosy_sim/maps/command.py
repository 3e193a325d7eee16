"""Command ``room``: a room from a map of ROS."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path

import msgspec

from ..atomic_file import AtomicFile
from ..sentences.sentence import Sentence, tr
from ..worlds.gallery import usable_arena
from .scanned_room import SMALLEST, room_of_map

__all__ = ["add_room_options", "make_room"]


def add_room_options(parser: argparse.ArgumentParser) -> None:
    """What ``room`` takes."""
    parser.add_argument("file", type=Path)
    parser.add_argument("-o", dest="output", type=Path, metavar="ROOM")


def make_room(options: argparse.Namespace, say: Callable[[Sentence], None]) -> int:
    """Write the room of a map to a file, and say what it is; returns the exit status."""
    path: Path = options.file
    output: Path = options.output or path.with_suffix(".json")
    room = room_of_map(path)
    usable_arena(room.world, str(path))
    with AtomicFile(output) as file:
        file.write(msgspec.json.format(msgspec.json.encode(room.world), indent=2) + b"\n")
    x, y = room.start
    say(
        tr(
            "{output}: {width} by {height} m, {walls} walls; the robot starts at ({x}, {y}).",
            output=output,
            width=room.width,
            height=room.height,
            walls=room.walls,
            x=x,
            y=y,
        )
    )
    if room.unknown:
        say(tr("Hatched, because no scan has seen it: {area} m².", area=round(room.unknown, 2)))
    if room.specks:
        say(tr("Left out, because they have fewer than {cells} cells: {n}.", cells=SMALLEST, n=room.specks))
    return 0
