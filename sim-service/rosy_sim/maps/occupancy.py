"""
Occupancy grids: which cells of a map are occupied and which are free; the others are unknown.

A row is one whole number with a bit per cell, the lowest bit for the first column; the first row is the lowest. So
whole rows are compared and shifted at once, and a large map costs milliseconds where a loop over cells costs seconds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from .map_file import MapFile, Mode
from .map_image import MapImage

__all__ = ["Occupancy", "bits", "dilated", "eroded", "occupancy_of"]


@dataclass(frozen=True, slots=True)
class Occupancy:
    """A grid. ``left`` and ``bottom`` count the columns and rows of the image that were cropped there."""

    width: int
    height: int
    occupied: list[int]
    free: list[int]
    left: int = 0
    bottom: int = 0

    def unknown(self) -> list[int]:
        """The cells that are neither occupied nor free."""
        every = (1 << self.width) - 1
        return [every & ~(a | b) for a, b in zip(self.occupied, self.free, strict=True)]

    def cropped(self) -> Occupancy:
        """Without the unknown margins; with no cells when none is known."""
        known = [a | b for a, b in zip(self.occupied, self.free, strict=True)]
        filled = [y for y, row in enumerate(known) if row]
        if not filled:
            return Occupancy(0, 0, [], [])
        columns = 0
        for row in known:
            columns |= row
        left = (columns & -columns).bit_length() - 1
        low, high = filled[0], filled[-1] + 1
        return Occupancy(
            columns.bit_length() - left,
            high - low,
            [row >> left for row in self.occupied[low:high]],
            [row >> left for row in self.free[low:high]],
            self.left + left,
            self.bottom + low,
        )


def occupancy_of(image: MapImage, file: MapFile) -> Occupancy:
    """
    The cells of an image, by the rules of ``map_server``, but what its saver marks as unknown is unknown.

    ROS 2's saver writes unknown cells as level 205 beside a default ``free_thresh`` of 0.25, which would make them
    free.
    """
    occupied, free = _occupied_and_free_levels(file)
    # The last pixel of a row is the first digit of its number; the last row of an image is the lowest.
    starts = range(0, image.width * image.height, image.width)[::-1]
    rows = [image.pixels[i : i + image.width][::-1] for i in starts]
    opaque = [
        int(image.opacity[i : i + image.width][::-1].translate(_OPAQUE), 2) if image.opacity else -1 for i in starts
    ]
    return Occupancy(
        image.width,
        image.height,
        [int(row.translate(occupied), 2) & known for row, known in zip(rows, opaque, strict=True)],
        [int(row.translate(free), 2) & known for row, known in zip(rows, opaque, strict=True)],
    )


_OPAQUE = bytes(ord("1") if level == 255 else ord("0") for level in range(256))

_UNKNOWN_LEVELS: dict[Mode, tuple[int, ...]] = {"trinary": (205,), "scale": (205, 127, 128), "raw": ()}
"""Levels of grey that savers write for unknown cells; in mode scale the middle one where the image has no opacity."""

_MOST_RAW = 100
"""Pixels of mode raw are occupancies in percent; all above are unknown."""


def _occupied_and_free_levels(file: MapFile) -> tuple[bytes, bytes]:
    """For each level of grey a ``1`` where it is occupied, and where it is free."""
    occupied, free = bytearray(b"0" * 256), bytearray(b"0" * 256)
    marks = _UNKNOWN_LEVELS[file.mode]
    for level in range(256):
        if file.mode == "raw":
            if level > _MOST_RAW:
                continue
            share = level / _MOST_RAW
        else:
            share = (level if file.negate else 255 - level) / 255
        if level in marks or (file.negate and 255 - level in marks):
            continue
        if share >= file.occupied_from:
            occupied[level] = ord("1")
        elif share <= file.free_to:
            free[level] = ord("1")
    return bytes(occupied), bytes(free)


def bits(row: int) -> Iterator[int]:
    """The columns of the cells of a row, ascending."""
    while row:
        lowest = row & -row
        yield lowest.bit_length() - 1
        row ^= lowest


def eroded(rows: list[int], *, square: bool) -> list[int]:
    """The cells whose four neighbours, or eight with ``square``, are there too; outside of the grid there are none."""
    inner = [row & row << 1 & row >> 1 for row in rows]
    beside = [0, *(inner if square else rows), 0]
    return [row & beside[y] & beside[y + 2] for y, row in enumerate(inner)]


def dilated(rows: list[int]) -> list[int]:
    """The cells and their four neighbours, those of the grid and others to its left."""
    beside = [0, *rows, 0]
    return [row | row << 1 | row >> 1 | beside[y] | beside[y + 2] for y, row in enumerate(rows)]
