"""
Occupancy grids: which cells of a map are occupied and which are free; the others are unknown.

A row is one whole number with a bit per cell, the lowest bit for the first column; the first row is the lowest. So
whole rows are compared and shifted at once, and a large map costs milliseconds where a loop over cells costs seconds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from .graymap import Graymap

__all__ = ["Occupancy", "bits", "eroded", "occupancy_of"]


@dataclass(frozen=True, slots=True)
class Occupancy:
    """A grid. ``left`` and ``bottom`` count the columns and rows of the image that were cropped there."""

    width: int
    height: int
    occupied: list[int]
    free: list[int]
    left: int = 0
    bottom: int = 0

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


def occupancy_of(image: Graymap, *, negate: bool, occupied_above: float, free_below: float) -> Occupancy:
    """The cells of an image, by the rules of ``map_server``."""
    share = [(v if negate else 255 - v) / 255 for v in range(256)]
    occupied = bytes(ord("1") if s > occupied_above else ord("0") for s in share)
    free = bytes(ord("1") if s < free_below and not s > occupied_above else ord("0") for s in share)
    # The last pixel of a row is the first digit of its number; the last row of an image is the lowest.
    rows = [image.pixels[i * image.width : (i + 1) * image.width][::-1] for i in range(image.height)][::-1]
    return Occupancy(
        image.width,
        image.height,
        [int(row.translate(occupied), 2) for row in rows],
        [int(row.translate(free), 2) for row in rows],
    )


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
